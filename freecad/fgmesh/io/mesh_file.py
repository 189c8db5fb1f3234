# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing result as a file: the format follows from the extension.

.vtu: ParaView and VTK; every field.        .msh: gmsh 4.1; every field, physical groups.
.inp: CalculiX and Abaqus; sets, surfaces.  .unv: Salome and FreeCAD; groups.

Points keep their order, and so do tetrahedra (of four or ten nodes) and, after them, triangles; but in .msh
all are sorted by the part of the shape that they belong to, and of faces that coincide only the lowest is named.
"""
import os

import numpy as np

from freecad.fgmesh.io import abaqus, gmsh, unv
from freecad.fgmesh.io.atomic import OutputError, replaced_together
from freecad.fgmesh.io.fields import cell_data, point_data


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


def _write_vtu(result, path):
    import meshio  # takes a while to load, and only files need it

    cells = [_typed("tetra", result.tets), _typed("triangle", result.triangles)]
    mesh = meshio.Mesh(np.asarray(result.points), cells, point_data(result), cell_data(result))
    mesh.write(path, file_format="vtu")


def _typed(kind, cells):
    """The name that meshio gives to cells of so many nodes, and the cells."""
    cells = np.asarray(cells)
    nodes = cells.shape[1]
    return (kind if nodes < 5 else f"{kind}{nodes}"), cells


WRITERS = {".vtu": _write_vtu, ".inp": abaqus.write_abaqus, ".unv": unv.write_unv, ".msh": gmsh.write_gmsh}
EXTENSIONS = tuple(WRITERS)
