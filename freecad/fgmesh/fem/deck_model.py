# SPDX-License-Identifier: GPL-3.0-or-later
"""The model part of a deck for CalculiX or Abaqus, with a material for each bin; and fractions as fields of Abaqus."""
import numpy as np

from freecad.fgmesh.io.abaqus import write_elements, write_rows, write_set
from freecad.fgmesh.io.deck_numbers import deck_number

_KEYWORDS = {
    "*ELASTIC": ("YoungsModulus", "PoissonRatio"),
    "*DENSITY": ("Density",),
    "*CONDUCTIVITY": ("ThermalConductivity",),
    "*EXPANSION": ("ThermalExpansionCoefficient",),
    "*SPECIFIC HEAT": ("SpecificHeat",),
}
"""What each of them tells of a material."""


def write_model(file, fields, binned, fem_mesh):
    """Writes a graded_fields.GradedMesh to an open text file: all but a step. binned: the Bins of its elements; the groups
    of `fem_mesh` on faces, edges and vertices become sets of nodes."""
    write_elements(file, fields.points, fields.tets)
    for solid in np.unique(fields.solids):
        write_set(file, "ELSET", f"Solid{solid + 1}", np.flatnonzero(fields.solids == solid))
    for name, nodes in _node_groups(fem_mesh):
        write_set(file, "NSET", name, nodes)
    file.write(f"** Properties are at most {binned.error:.3g} off, relatively; in mm, t, s, K, MPa\n")
    for number, members in enumerate(binned.members()):
        name = f"Bin{number + 1:04}"
        write_set(file, "ELSET", name, members)
        file.write(f"*MATERIAL, NAME={name}\n")
        for keyword, properties in _KEYWORDS.items():
            if all(one in binned.values for one in properties):
                row = ", ".join(deck_number(binned.values[one][number]) for one in properties)
                file.write(f"{keyword}\n{row}\n")
        file.write(f"*SOLID SECTION, ELSET={name}, MATERIAL={name}\n")


def write_fractions(file, at_nodes):
    """Writes the fractions among the values at nodes, as GradedMesh.at_nodes() gives them, to an open text file: field
    variable N is fraction N."""
    for number in range(1, 1 + sum(name.startswith("fraction_") for name in at_nodes)):
        fraction = at_nodes[f"fraction_{number}"]
        known = np.flatnonzero(np.isfinite(fraction))
        file.write(f"** fraction_{number}\n*INITIAL CONDITIONS, TYPE=FIELD, VARIABLE={number}\n")
        write_rows(file, "%d, %s", [(known + 1).tolist(), map(deck_number, fraction[known].tolist())])


def _node_groups(fem_mesh):
    """Yield (name, 0-based nodes) of the groups of faces, edges and vertices."""
    for group in fem_mesh.Groups:
        kind, members = fem_mesh.getGroupElementType(group), fem_mesh.getGroupElements(group)
        if kind == "Volume" or not members:
            continue
        if kind != "Node":
            members = {node for member in members for node in fem_mesh.getElementNodes(member)}
        yield fem_mesh.getGroupName(group), np.array(sorted(members)) - 1
