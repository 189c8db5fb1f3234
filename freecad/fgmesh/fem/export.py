# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of a document with fractions and properties as files for other programs."""
import os
from pathlib import Path

from freecad.fgmesh import core
from freecad.fgmesh.fem.bins import bins
from freecad.fgmesh.fem.deck_model import bin_names, write_fractions, write_model
from freecad.fgmesh.fem.fem_mesh import from_fem_mesh
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.fem.graded_material import groups_of_bins
from freecad.fgmesh.io import replaced_together
from freecad.fgmesh.io.abaqus import ALL_NODES, ALL_SOLIDS
from freecad.fgmesh.io.fields import fields_with
from freecad.fgmesh.io.mesh_file import WRITERS
from freecad.fgmesh.io.xdmf import write_xdmf, write_xdmf_facets
from freecad.fgmesh.mixing import read_laws

_WITH_FIELDS = (".vtu", ".msh", ".xdmf")
_DECK = ".inp"


def export_properties(mesh, path, mixing=None, most_bins=20, allowed_error=0.0):
    """Writes `mesh`, a graded mesh that is up to date, to `path`, as a whole or not at all: `.vtu`, `.msh`, `.xdmf` or
    `.inp`, in mm, t, s, K, MPa, with properties by the laws `mixing` (as make_analysis() takes them). All else is as in the
    file of that kind which the command line writes, and so are the names.

    .vtu, .msh, .xdmf: tetrahedra and boundary triangles with properties, named as "Density (t/mm^3)", at nodes and in
    both; at nodes `fraction_1` ..., `vertex`, `edge`; in cells `solid`, `face`. In .msh edges and vertices, too, and
    physical groups SolidN, FaceN, EdgeN, VertexN. The triangles of .xdmf go to a second file, `<name>_facets.xdmf`.

    .inp: the model for a deck of CalculiX or Abaqus, to be completed by a step: a material and a section for each of the
    bins that most_bins or allowed_error come to (see bins()); ELSET SolidN, NSET SolidN, FaceN, EdgeN, VertexN, SURFACE
    FaceN. The fractions go to a second file, `<name>_fractions.inp`, as the fields that Abaqus knows and CalculiX refuses:
    a deck that includes it has them as field variables.

    Groups that a user has added to the Fem mesh are written, too, under names that cannot break a file (io.names), but
    for groups of nodes in .msh, which has none.

    Raises core.InvalidInput, core.GeometryError, io.OutputError.
    """
    path = Path(os.fspath(path))
    extension = path.suffix.lower()
    if extension not in [*_WITH_FIELDS, _DECK]:
        known = ", ".join([*_WITH_FIELDS, _DECK])
        advice = "; as .med FreeCAD exports the mesh object itself, with its groups"
        raise core.InvalidInput(
            f"{str(path)!r}: properties go to files that end in {known}{advice if extension == '.med' else ''}"
        )
    laws = read_laws(mixing or {})
    graded = graded_mesh(mesh)
    if extension == _DECK:
        _write_deck(mesh, graded, bins(graded.in_tets(laws), most_bins, allowed_error), path)
    else:
        _write_fields(mesh, graded, laws, path)


def _write_fields(mesh, graded, laws, path):
    written = _grouped(mesh, graded)
    fields = fields_with(written, graded.at_nodes(laws), graded.named(graded.in_tets(laws)))
    writers = {path: WRITERS.get(path.suffix.lower(), write_xdmf)}
    if path.suffix.lower() == ".xdmf":
        writers[_beside(path, "facets")] = write_xdmf_facets
    with replaced_together(*writers) as temporary:
        for write, place in zip(writers.values(), temporary):
            write(written, fields, place)


def _beside(path, what):
    return path.with_name(f"{path.stem}_{what}{path.suffix}")


def _grouped(mesh, graded, taken=()):
    return from_fem_mesh(mesh.FemMesh, graded.solids + 1, groups_of_bins(mesh), taken)


def _write_deck(mesh, graded, binned, path):
    written = _grouped(mesh, graded, [ALL_NODES, ALL_SOLIDS, *bin_names(binned)])
    at_nodes = graded.at_nodes()
    with replaced_together(path, _beside(path, "fractions")) as (model, fractions):
        with open(model, "w", encoding="ascii") as file:
            write_model(file, written, binned)
        with open(fractions, "w", encoding="ascii") as file:
            write_fractions(file, at_nodes)
