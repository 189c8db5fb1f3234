# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing result as a file: the format follows from the extension.

.vtu: ParaView and VTK; every field.        .msh: gmsh 4.1; every field, physical groups SolidN and FaceN.
.inp: CalculiX and Abaqus; sets, surfaces.  .unv: Salome and FreeCAD; groups.

Points keep their order, and so do tetrahedra (of four or ten nodes) and, after them, triangles; but in .msh
all are sorted by the solid or face that they belong to.
"""
import os

import numpy as np

from freecad.fgmesh.io import abaqus, unv
from freecad.fgmesh.io.atomic import OutputError, replaced_together
from freecad.fgmesh.io.boundary import element_sides


def write_mesh(result, path):
    """Write a MeshingResult to `path`, as a whole or not at all. Raises OutputError."""
    write = WRITERS[mesh_format(path)]
    with replaced_together(path) as (temporary,):
        write(result, temporary)


def mesh_format(path):
    """The extension of `path`, one of EXTENSIONS. Raises OutputError for any other."""
    extension = os.path.splitext(os.fspath(path))[1].lower()
    if extension not in EXTENSIONS:
        raise OutputError(
            f"{os.fspath(path)!r}: the extension {extension!r} is no known mesh format; "
            f"use {', '.join(EXTENSIONS)}"
        )
    return extension


def point_data(result):
    """Volume fractions at the points, by name; each (n,) float64. They sum to one."""
    first = np.asarray(result.fraction)
    return {"fraction_1": first, "fraction_2": 1.0 - first}


def cell_data(result):
    """Fields of the cells, by name: one array for the tetrahedra, one for the triangles.

    Tetrahedra carry face 0, triangles solid 0. Triangles carry the variation and the angle of the tetrahedron
    behind them: viewers draw them in front of it.
    """
    behind, _ = element_sides(result)
    variation, angle = np.asarray(result.variation), np.asarray(result.dihedral_min)
    return {
        "solid": [np.asarray(result.tet_solids, np.int32), np.zeros(len(behind), np.int32)],
        "face": [np.zeros(len(variation), np.int32), np.asarray(result.triangle_faces, np.int32)],
        "variation": [variation, variation[behind]],
        "dihedral_min": [angle, angle[behind]],
    }


def _write_vtu(result, path):
    import meshio  # takes a while to load, and only files need it

    cells = [_typed("tetra", result.tets), _typed("triangle", result.triangles)]
    mesh = meshio.Mesh(np.asarray(result.points), cells, point_data(result), cell_data(result))
    mesh.write(path, file_format="vtu")


def _write_gmsh(result, path):
    """Gmsh 4.1 through meshio, which wants a block of cells for each entity, and each point on one entity."""
    import meshio

    fields = cell_data(result)
    blocks, data, names = [], {name: [] for name in (*fields, "gmsh:physical", "gmsh:geometrical")}, {}
    kinds = [
        ("tetra", "Solid", 3, result.tets, fields["solid"]),
        ("triangle", "Face", 2, result.triangles, fields["face"]),
    ]
    for kind, (cell_type, word, dimension, cells, owner) in enumerate(kinds):
        for number in np.unique(owner[kind]):
            chosen = np.flatnonzero(owner[kind] == number)
            blocks.append(_typed(cell_type, np.asarray(cells)[chosen]))
            names[f"{word}{number}"] = np.array([number, dimension])
            for name, field in fields.items():
                data[name].append(field[kind][chosen])
            for tag in ("gmsh:physical", "gmsh:geometrical"):
                data[tag].append(np.full(len(chosen), number, np.int32))
    # In the file, points stand entity by entity; some readers, meshio among them, number them as they stand.
    entities = _entities_with_cells(result)
    order = np.lexsort((entities[:, 1], entities[:, 0]))
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    blocks = [(cell_type, place[cells]) for cell_type, cells in blocks]
    points = {name: values[order] for name, values in point_data(result).items()}
    points["gmsh:dim_tags"] = entities[order]
    mesh = meshio.Mesh(np.asarray(result.points)[order], blocks, points, data, field_data=names)
    mesh.write(path, file_format="gmsh")


def _typed(kind, cells):
    """The name that meshio gives to cells of so many nodes, and the cells."""
    cells = np.asarray(cells)
    nodes = cells.shape[1]
    return (kind if nodes < 5 else f"{kind}{nodes}"), cells


def _entities_with_cells(result):
    """Dimension and number of a solid or face that carries each point; (n, 2) int32.

    Edges and vertices are left out: meshio would place all of them at the coordinates' origin.
    """
    entities = np.empty((len(result.points), 2), np.int32)
    for dimension, cells, numbers in (3, result.tets, result.tet_solids), (
        2,
        result.triangles,
        result.triangle_faces,
    ):
        owners = np.column_stack([np.full(len(cells), dimension), numbers])
        entities[np.asarray(cells)] = owners[:, None]
    return entities


WRITERS = {".vtu": _write_vtu, ".inp": abaqus.write_abaqus, ".unv": unv.write_unv, ".msh": _write_gmsh}
EXTENSIONS = tuple(WRITERS)
