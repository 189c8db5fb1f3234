# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be looked at on a graded solid: the fraction of a constituent, or a property mixed from the cards."""
from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from freecad.fgmesh.model import constituents, stored
from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.model.texts import TRANSLATE_LATER

_FRACTION = TRANSLATE_LATER("FGMesh", "fraction of {}")
_NAMELESS_FRACTION = TRANSLATE_LATER("FGMesh", "fraction of constituent {}")
PROPERTIES = {
    "YoungsModulus": (TRANSLATE_LATER("FGMesh", "Young's modulus"), "GPa"),
    "PoissonRatio": (TRANSLATE_LATER("FGMesh", "Poisson's ratio"), ""),
    "Density": (TRANSLATE_LATER("FGMesh", "density"), "kg/m^3"),
    "ThermalConductivity": (TRANSLATE_LATER("FGMesh", "thermal conductivity"), "W/m/K"),
    "ThermalExpansionCoefficient": (TRANSLATE_LATER("FGMesh", "thermal expansion"), "um/m/K"),
    "SpecificHeat": (TRANSLATE_LATER("FGMesh", "specific heat"), "J/kg/K"),
    "YieldStrength": (TRANSLATE_LATER("FGMesh", "yield strength"), "MPa"),
}
"""{name in material cards: (name for users, unit that it is shown in)}."""


class Quantity(NamedTuple):
    """A value that depends linearly on the fractions."""

    name: str  # English, with {} for `constituent`; translated in the context "FGMesh"
    constituent: str
    unit: str
    of_constituents: tuple  # its values where each alone is

    def values(self, fractions):
        """Those at places with these fractions, (n, k)."""
        return fractions[:, : len(self.of_constituents)] @ np.array(self.of_constituents)

    @property
    def range(self):
        return min(self.of_constituents), max(self.of_constituents)

    def title(self, translate=str):
        """What it is called, by a function that translates."""
        name = translate(self.name).format(self.constituent)
        return f"{name}, {self.unit}" if self.unit else name


def constituent_names(thing):
    """What the constituents of `thing` are called; where its parts are of different materials, as in Boolean fragments,
    each name in its place: "Steel / Brass". Empty where a part has no names."""
    materials = [stored.texts(part, "FGMConstituents") for part, _ in graded_parts(thing)]
    if not all(materials):
        return []
    in_place = zip_longest(*materials)
    return [" / ".join(dict.fromkeys(name for name in names if name)) for names in in_place]


def constituent_count(thing):
    """The most constituents that a part of `thing` has."""
    return max((len(stored.texts(part, "FGMFractions")) + 1 for part, _ in graded_parts(thing)), default=2)


def fraction_titles(solid, count, translate=str):
    """What the fractions of the `count` constituents of `solid`, None where it was deleted, are called."""
    names = constituent_names(solid) if solid is not None else []
    return [quantity.title(translate) for quantity in _fractions(names, count)]


def shown_quantities(names, count, document):
    """The Quantities of a solid made of `count` constituents called `names` (as many, or none yet): the fractions, then
    each property that all cards have, mixed in proportion to the fractions (rule of mixtures, Voigt 1889).
    """
    found = _fractions(names, count)
    cards = [constituents.properties(name, document) for name in names]
    for key, (name, unit) in PROPERTIES.items() if len(cards) == count else ():
        values = tuple(constituents.number_in(card.get(key), unit) for card in cards)
        if None not in values and len(set(values)) > 1:
            found.append(Quantity(name, "", unit, values))
    return found


def _fractions(names, count):
    named = len(names) == count
    name = _FRACTION if named else _NAMELESS_FRACTION
    titles = names if named else [str(number) for number in range(1, count + 1)]
    ones = np.eye(count).tolist()
    return [Quantity(name, title, "", tuple(values)) for title, values in zip(titles, ones)]
