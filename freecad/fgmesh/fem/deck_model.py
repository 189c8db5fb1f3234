# SPDX-License-Identifier: GPL-3.0-or-later
"""The model part of a deck for CalculiX or Abaqus, with a material for each bin; and fractions as fields of Abaqus."""
import numpy as np

from freecad.fgmesh.io.abaqus import write_mesh_part, write_rows, write_set
from freecad.fgmesh.io.deck_numbers import deck_number

_KEYWORDS = {
    "*ELASTIC": ("YoungsModulus", "PoissonRatio"),
    "*DENSITY": ("Density",),
    "*CONDUCTIVITY": ("ThermalConductivity",),
    "*EXPANSION": ("ThermalExpansionCoefficient",),
    "*SPECIFIC HEAT": ("SpecificHeat",),
}
"""What each of them tells of a material."""


def bin_names(binned):
    """Of the sets and materials of the bins."""
    return [f"Bin{number:04}" for number in range(1, binned.count + 1)]


def write_model(file, mesh, binned):
    """Writes an io.groups.GroupedMesh with the Bins of its elements to an open text file: all but a step."""
    write_mesh_part(file, mesh)
    file.write(f"** Properties are at most {binned.error:.3g} off, relatively; in mm, t, s, K, MPa\n")
    for number, (name, members) in enumerate(zip(bin_names(binned), binned.members())):
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
