# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as a file: the format follows from the extension.

.vtu: ParaView and VTK; every field.        .msh: gmsh 4.1; every field, physical groups.
.inp: CalculiX and Abaqus; sets, surfaces.  .unv: Salome and FreeCAD; groups.

Points keep their order, and so do tetrahedra (of four or ten nodes) and, after them, triangles; but in .msh
all are sorted by the part of the shape that they belong to.
"""
import os

from freecad.fgmesh.io import abaqus, gmsh, unv
from freecad.fgmesh.io.atomic import OutputError, replaced_together
from freecad.fgmesh.io.fields import fields_of
from freecad.fgmesh.io.groups import grouped


def write_mesh(result, path):
    """Write a MeshingResult to `path`, as a whole or not at all. Raises OutputError."""
    extension = mesh_format(path)
    with replaced_together(path) as (temporary,):
        write_result(result, temporary, extension)


def write_result(result, path, extension):
    """Write a MeshingResult to a path that needs no protection, in the format of `extension`."""
    mesh = grouped(result)
    WRITERS[extension](mesh, fields_of(mesh, result), path)


def mesh_format(path):
    """The extension of `path`, one of EXTENSIONS. Raises OutputError for any other."""
    extension = os.path.splitext(os.fspath(path))[1].lower()
    if extension not in EXTENSIONS:
        raise OutputError(
            f"{os.fspath(path)!r}: the extension {extension!r} is no known mesh format; "
            f"use {', '.join(EXTENSIONS)}"
        )
    return extension


def _write_vtu(mesh, fields, path):
    import meshio  # takes a while to load, and only these files need it

    cells = [_typed("tetra", mesh.tets), _typed("triangle", mesh.triangles)]
    meshio.Mesh(mesh.points, cells, fields.at_points, fields.in_cells).write(path, file_format="vtu")


def _typed(kind, cells):
    """The name that meshio gives to cells of so many nodes, and the cells."""
    nodes = cells.shape[1]
    return (kind if nodes < 5 else f"{kind}{nodes}"), cells


WRITERS = {
    ".vtu": _write_vtu,
    ".inp": abaqus.write_abaqus,
    ".unv": unv.write_unv,
    ".msh": gmsh.write_gmsh,
}
"""{extension: a function of a GroupedMesh, its Fields and a path}."""
EXTENSIONS = tuple(WRITERS)
