# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of a document with fractions and properties as files for other programs."""
import os
from pathlib import Path

from freecad.fgmesh import core
from freecad.fgmesh.fem.bins import bins
from freecad.fgmesh.fem.deck_model import write_fractions, write_model
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.io import replaced_together
from freecad.fgmesh.mixing import read_laws

_FIELD_FORMATS = {".vtu": "vtu", ".msh": "gmsh"}
"""{extension: its name in meshio} of files that have fields. gmsh's is that of version 4.1."""
_DECK = ".inp"


def export_properties(mesh, path, mixing=None, most_bins=20, allowed_error=0.0):
    """Writes `mesh`, a graded mesh that is up to date, to `path`, as a whole or not at all: `.vtu`, `.msh` or `.inp`, in mm,
    t, s, K, MPa, with properties by the laws `mixing` (as make_analysis() takes them).

    .vtu, .msh: properties at nodes and in tetrahedra, named as "Density (t/mm^3)"; at nodes `fraction_1` ...; in tetrahedra
    `solid`, the N of SolidN.

    .inp: the model for a deck of CalculiX or Abaqus, to be completed by a step: a material and a section for each of the
    bins that most_bins or allowed_error come to (see bins()), ELSET SolidN, and the groups of the mesh on faces, edges and
    vertices as NSET. The fractions go to a second file, `<name>_fractions.inp`, as the fields that Abaqus knows and
    CalculiX refuses: a deck that includes it has them as field variables.

    Raises core.InvalidInput, core.GeometryError, io.OutputError.
    """
    path = Path(os.fspath(path))
    extension = path.suffix.lower()
    if extension not in [*_FIELD_FORMATS, _DECK]:
        known = ", ".join([*_FIELD_FORMATS, _DECK])
        advice = "; as .med FreeCAD exports the mesh object itself, with its groups"
        raise core.InvalidInput(
            f"{str(path)!r}: properties go to files that end in {known}{advice if extension == '.med' else ''}"
        )
    laws = read_laws(mixing or {})
    fields = graded_mesh(mesh)
    if extension == _DECK:
        binned = bins(fields.in_tets(laws), most_bins, allowed_error)
        _write_deck(fields, laws, binned, mesh.FemMesh, path)
    else:
        _write_fields(fields, laws, path, _FIELD_FORMATS[extension])


def _write_fields(fields, laws, path, file_format):
    import meshio

    kind = "tetra" if fields.tets.shape[1] == 4 else "tetra10"
    in_tets = {"solid": fields.solids + 1.0, **fields.named(fields.in_tets(laws))}
    written = meshio.Mesh(
        fields.points,
        [(kind, fields.tets)],
        point_data=fields.at_nodes(laws),
        cell_data={name: [values] for name, values in in_tets.items()},
    )
    with replaced_together(path) as (temporary,):
        written.write(temporary, file_format=file_format)


def _write_deck(fields, laws, binned, fem_mesh, path):
    at_nodes = fields.at_nodes(laws)
    beside = path.with_name(f"{path.stem}_fractions{path.suffix}")
    with replaced_together(path, beside) as (model, fractions):
        with open(model, "w", encoding="utf-8") as file:
            write_model(file, fields, binned, fem_mesh)
        with open(fractions, "w", encoding="ascii") as file:
            write_fractions(file, at_nodes)
