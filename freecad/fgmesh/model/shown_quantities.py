# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be looked at on a graded solid: the fraction of a constituent, or a property mixed from the cards."""
from typing import NamedTuple

import FreeCAD

from freecad.fgmesh.model import constituents
from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.model.texts import TRANSLATE_LATER

_FRACTION = TRANSLATE_LATER("FGMesh", "fraction of {}")
_NAMELESS = (
    TRANSLATE_LATER("FGMesh", "fraction of constituent 1"),
    TRANSLATE_LATER("FGMesh", "fraction of constituent 2"),
)
_PROPERTIES = (
    ("YoungsModulus", TRANSLATE_LATER("FGMesh", "Young's modulus"), "GPa"),
    ("PoissonRatio", TRANSLATE_LATER("FGMesh", "Poisson's ratio"), ""),
    ("Density", TRANSLATE_LATER("FGMesh", "density"), "kg/m^3"),
    ("ThermalConductivity", TRANSLATE_LATER("FGMesh", "thermal conductivity"), "W/m/K"),
    ("ThermalExpansionCoefficient", TRANSLATE_LATER("FGMesh", "thermal expansion"), "um/m/K"),
    ("SpecificHeat", TRANSLATE_LATER("FGMesh", "specific heat"), "J/kg/K"),
)
"""Name in material cards, name for users, unit that it is shown in."""


class Quantity(NamedTuple):
    """A value that depends linearly on the fraction of the first constituent."""

    name: str  # English, with {} for `constituent`; translated in the context "FGMesh"
    constituent: str
    unit: str
    at_zero: float
    at_one: float

    def values(self, fraction):
        """Those at places with these fractions, (n,)."""
        return self.at_zero + (self.at_one - self.at_zero) * fraction

    @property
    def range(self):
        return min(self.at_zero, self.at_one), max(self.at_zero, self.at_one)

    def title(self, translate=str):
        """What it is called, by a function that translates."""
        name = translate(self.name).format(self.constituent)
        return f"{name}, {self.unit}" if self.unit else name


def fraction_title(solid, translate=str):
    """What the fraction of the first constituent of `solid`, None where it was deleted, is called."""
    parts = graded_parts(solid) if solid is not None else []
    names = list(getattr(parts[0][0], "FGMConstituents", [])) if parts else []
    return _fractions(names)[0].title(translate)


def shown_quantities(names, document):
    """The Quantities of a solid made of the constituents called `names` (two, or none yet): the fractions, then
    each property that both cards have, mixed in proportion to the fractions (rule of mixtures, Voigt 1889).
    """
    found = _fractions(names)
    cards = [constituents.properties(name, document) for name in names]
    for key, name, unit in _PROPERTIES if len(cards) == 2 else ():
        values = [_value(card.get(key), unit) for card in cards]
        if None not in values and values[0] != values[1]:
            found.append(Quantity(name, "", unit, values[1], values[0]))
    return found


def _fractions(names):
    titles = [(_FRACTION, name) for name in names] if len(names) == 2 else [(name, "") for name in _NAMELESS]
    return [Quantity(*titles[0], "", 0, 1), Quantity(*titles[1], "", 1, 0)]


def _value(text, unit):
    """The number in `unit` that a card's text stands for; None where it is none."""
    if not text:
        return None
    try:
        quantity = FreeCAD.Units.Quantity(text)
        return float(quantity.getValueAs(unit)) if unit else float(quantity)
    except Exception:  # FreeCAD's parser of quantities knows many
        return None
