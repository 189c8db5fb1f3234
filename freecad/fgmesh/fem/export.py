# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of a document with fractions and properties as files for other programs."""
import os
from pathlib import Path

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.fem.bins import bins
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.io import replaced_together
from freecad.fgmesh.io.abaqus import write_elements, write_rows, write_set
from freecad.fgmesh.mixing import read_laws

_FORMATS = {".vtu": "vtu", ".msh": "gmsh"}
"""{extension: its name in meshio}. gmsh's is that of version 4.1."""

_CARDS = {
    ("YoungsModulus", "PoissonRatio"): "*ELASTIC",
    ("Density",): "*DENSITY",
    ("ThermalConductivity",): "*CONDUCTIVITY",
    ("ThermalExpansionCoefficient",): "*EXPANSION",
    ("SpecificHeat",): "*SPECIFIC HEAT",
}
"""What decks call the properties that one card tells."""


def export_properties(mesh, path, mixing=None, most_bins=20, allowed_error=0.0):
    """Writes `mesh`, a graded mesh that is up to date, to `path`, as a whole or not at all: `.vtu`, `.msh` or `.inp`.

    .vtu, .msh: at nodes and in tetrahedra properties by the laws `mixing` (as make_analysis() takes them), in mm, t, s, K,
    MPa, named as "Density (t/mm^3)"; at nodes `fraction_1` ...; in tetrahedra `solid`, the N of SolidN.

    .inp: the model for a deck of CalculiX or Abaqus, in the same units, to be completed by a step: a material and a section
    for each of the bins that most_bins or allowed_error come to (see bins()), ELSET SolidN, and the groups of the mesh on
    faces, edges and vertices as NSET. The fractions go to a second file, `<name>_fractions.inp`, as the fields that Abaqus
    knows and CalculiX refuses: one that includes it has them as field variables.

    Raises core.InvalidInput, core.GeometryError, io.OutputError.
    """
    path = Path(os.fspath(path))
    extension = path.suffix.lower()
    if extension not in [*_FORMATS, ".inp"]:
        known = ", ".join([*_FORMATS, ".inp"])
        advice = (
            "; as .med FreeCAD exports the mesh object itself, with its groups" if extension == ".med" else ""
        )
        raise core.InvalidInput(f"{str(path)!r}: properties go to files that end in {known}{advice}")
    laws = read_laws(mixing or {})
    fields = graded_mesh(mesh)
    if extension != ".inp":
        with replaced_together(path) as (temporary,):
            _with_fields(fields, laws).write(temporary, file_format=_FORMATS[extension])
        return
    binned = bins(fields.in_tets(laws), most_bins, allowed_error)
    values = fields.at_nodes(laws)
    with replaced_together(path, path.with_name(f"{path.stem}_fractions.inp")) as (model, fractions):
        with open(model, "w", encoding="ascii") as file:
            _write_model(file, fields, binned, mesh.FemMesh)
        with open(fractions, "w", encoding="ascii") as file:
            _write_fractions(file, values)


def _with_fields(fields, laws):
    import meshio

    kind = "tetra" if fields.tets.shape[1] == 4 else "tetra10"
    in_tets = {"solid": fields.solids + 1.0, **fields.named(fields.in_tets(laws))}
    return meshio.Mesh(
        fields.points,
        [(kind, fields.tets)],
        point_data=fields.at_nodes(laws),
        cell_data={name: [values] for name, values in in_tets.items()},
    )


def _write_model(file, fields, binned, fem_mesh):
    write_elements(file, fields.points, fields.tets)
    for solid in np.unique(fields.solids):
        write_set(file, "ELSET", f"Solid{solid + 1}", np.flatnonzero(fields.solids == solid))
    for name, nodes in _node_sets(fem_mesh):
        write_set(file, "NSET", name, nodes)
    order = np.argsort(binned.numbers, kind="stable")
    count = len(next(iter(binned.values.values())))
    starts = np.searchsorted(binned.numbers[order], np.arange(1, count))
    file.write(f"** Properties are at most {binned.error:.3g} off, relatively; in mm, t, s, K, MPa\n")
    for number, members in enumerate(np.split(order, starts)):
        name = f"Bin{number + 1:04}"
        write_set(file, "ELSET", name, members)
        file.write(f"*MATERIAL, NAME={name}\n")
        for properties, card in _CARDS.items():
            if all(known in binned.values for known in properties):
                row = ", ".join(f"{binned.values[known][number]:.13g}" for known in properties)
                file.write(f"{card}\n{row}\n")
        file.write(f"*SOLID SECTION, ELSET={name}, MATERIAL={name}\n")


def _node_sets(fem_mesh):
    """Yield (name, 0-based nodes) of the groups of faces, edges and vertices."""
    for group in fem_mesh.Groups:
        kind, members = fem_mesh.getGroupElementType(group), fem_mesh.getGroupElements(group)
        if kind == "Volume" or not members:
            continue
        if kind != "Node":
            members = {node for member in members for node in fem_mesh.getElementNodes(member)}
        yield fem_mesh.getGroupName(group), np.array(sorted(members)) - 1


def _write_fractions(file, values):
    for number in range(1, 1 + sum(name.startswith("fraction_") for name in values)):
        fraction = values[f"fraction_{number}"]
        known = np.flatnonzero(np.isfinite(fraction))
        file.write(f"** fraction_{number}\n*INITIAL CONDITIONS, TYPE=FIELD, VARIABLE={number}\n")
        write_rows(file, "%d, %.17g", [known + 1, fraction[known]])
