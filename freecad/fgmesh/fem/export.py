# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of a document with fractions and properties as a file for other programs."""
import os

from freecad.fgmesh import core
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.io import replaced_together
from freecad.fgmesh.mixing import read_laws

_FORMATS = {".vtu": "vtu", ".msh": "gmsh"}
"""{extension: its name in meshio}. gmsh's is that of version 4.1."""


def export_properties(mesh, path, mixing=None):
    """Writes `mesh`, a graded mesh that is up to date, to `path`, as a whole or not at all: `.vtu` or `.msh`.

    At nodes and in tetrahedra: properties by the laws `mixing` (as make_analysis() takes them), in mm, t, s, K, MPa, named
    as "Density (t/mm^3)"; at nodes `fraction_1` ...; in tetrahedra `solid`, the N of SolidN. Raises core.InvalidInput,
    core.GeometryError, io.OutputError.
    """
    import meshio

    extension = os.path.splitext(os.fspath(path))[1].lower()
    if extension not in _FORMATS:
        raise core.InvalidInput(
            f"{os.fspath(path)!r}: properties go to files that end in {', '.join(_FORMATS)}"
        )
    laws = read_laws(mixing or {})
    fields = graded_mesh(mesh)
    kind = "tetra" if fields.tets.shape[1] == 4 else "tetra10"
    in_tets = {"solid": fields.solids + 1.0, **fields.named(fields.in_tets(laws))}
    written = meshio.Mesh(
        fields.points,
        [(kind, fields.tets)],
        point_data=fields.at_nodes(laws),
        cell_data={name: [values] for name, values in in_tets.items()},
    )
    with replaced_together(path) as (temporary,):
        written.write(temporary, file_format=_FORMATS[extension])
