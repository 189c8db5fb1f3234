# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be looked at on a graded solid: the fraction of a constituent, or a property mixed from the cards."""
from typing import NamedTuple

import FreeCAD

from freecad.fgmesh.model import constituents
from freecad.fgmesh.model.graded_parts import graded_parts

_PROPERTIES = (
    ("YoungsModulus", "GPa"),
    ("PoissonRatio", ""),
    ("Density", "kg/m^3"),
    ("ThermalConductivity", "W/m/K"),
    ("ThermalExpansionCoefficient", "um/m/K"),
    ("SpecificHeat", "J/kg/K"),
)
"""Name in material cards, unit that it is shown in."""


class Quantity(NamedTuple):
    """A value that depends linearly on the fraction of the first constituent."""

    name: str
    unit: str
    at_zero: float
    at_one: float

    def values(self, fraction):
        """Those at places with these fractions, (n,)."""
        return self.at_zero + (self.at_one - self.at_zero) * fraction

    @property
    def range(self):
        return min(self.at_zero, self.at_one), max(self.at_zero, self.at_one)

    @property
    def title(self):
        return f"{self.name}, {self.unit}" if self.unit else self.name


def fraction_title(solid):
    """What the fraction of the first constituent of `solid` is called; None for a solid that was deleted."""
    parts = graded_parts(solid) if solid is not None else []
    names = list(getattr(parts[0][0], "FGMConstituents", [])) if parts else []
    return _fraction_of(names[0] if names else "constituent 1")


def shown_quantities(names, document):
    """The Quantities of a solid made of the constituents called `names` (two, or none yet): the fractions, then
    each property that both cards have, mixed in proportion to the fractions (rule of mixtures, Voigt 1889).
    """
    first, second = names if len(names) == 2 else ("constituent 1", "constituent 2")
    found = [Quantity(_fraction_of(first), "", 0, 1), Quantity(_fraction_of(second), "", 1, 0)]
    cards = [constituents.properties(name, document) for name in names]
    for name, unit in _PROPERTIES if len(cards) == 2 else ():
        values = [_value(card.get(name), unit) for card in cards]
        if None not in values and values[0] != values[1]:
            found.append(Quantity(name, unit, values[1], values[0]))
    return found


def _fraction_of(name):
    return f"fraction of {name}"


def _value(text, unit):
    """The number in `unit` that a card's text stands for; None where it is none."""
    if not text:
        return None
    try:
        quantity = FreeCAD.Units.Quantity(text)
        return float(quantity.getValueAs(unit)) if unit else float(quantity)
    except Exception:  # FreeCAD's parser of quantities knows many
        return None
