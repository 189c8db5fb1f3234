# SPDX-License-Identifier: GPL-3.0-or-later
"""The properties that can be mixed, by their names in material cards, and the values that they may have."""
import math
from typing import NamedTuple

import numpy as np

from freecad.fgmesh import core


class Property(NamedTuple):
    """The open range of its values, and the law for where none is named."""

    above: float
    below: float
    default: str

    def holds(self, values):
        """Which of `values` are allowed; NaN and infinite ones never are."""
        return (values > self.above) & (values < self.below)

    @property
    def demand(self):
        """What values have to be, for a message."""
        limits = ((self.above, "above"), (self.below, "below"))
        told = [f"{word} {limit:g}" for limit, word in limits if math.isfinite(limit)]
        return " and ".join(["finite", *told] if len(told) < 2 else told)


PROPERTIES = {
    "YoungsModulus": Property(0, math.inf, "voigt"),
    "PoissonRatio": Property(-1, 0.5, "voigt"),  # or that of YoungsModulus, see `laws.read_laws`
    "Density": Property(0, math.inf, "voigt"),
    "ThermalConductivity": Property(0, math.inf, "voigt"),
    "ThermalExpansionCoefficient": Property(-math.inf, math.inf, "voigt"),
    "SpecificHeat": Property(0, math.inf, "by_mass"),
    "YieldStrength": Property(0, math.inf, "voigt"),
}


def check_name(name):
    """Raises InvalidInput where `name` is no property that can be mixed."""
    if name not in PROPERTIES:
        raise core.InvalidInput(f"no property {name!r} can be mixed: take one of {', '.join(PROPERTIES)}")


class Cards:
    """What the material cards of the constituents tell: {property: (k,) numbers}, None or NaN where one is silent."""

    def __init__(self, values, constituents):
        self._values, self._constituents = values, constituents

    def of(self, name, purpose, numbers=None):
        """The values (k,) of property `name`, checked for the constituents with `numbers`, for all where None.

        purpose: what they are needed for, for a message. Raises InvalidInput that names the constituent where its
        card is silent or its value has no meaning.
        """
        count = self._constituents
        values = self._numbers(name)
        for number in numbers or range(1, count + 1):
            value = values[number - 1]
            if np.isnan(value):
                raise core.InvalidInput(
                    f"constituent {number} has no {name}, which {purpose} needs: "
                    "add it to its material, or choose another law"
                )
            if not PROPERTIES[name].holds(value):
                raise core.InvalidInput(
                    f"the {name} of constituent {number} is {value:g}, but must be {PROPERTIES[name].demand}: "
                    "correct its material"
                )
        return values

    def _numbers(self, name):
        count = self._constituents
        given = self._values.get(name)
        if given is None:
            return np.full(count, math.nan)
        try:
            values = np.array([math.nan if value is None else float(value) for value in given])
        except (TypeError, ValueError):
            raise core.InvalidInput(f"{name}: give one number for each constituent, not {given!r}") from None
        if len(values) != count:
            raise core.InvalidInput(
                f"{name}: give one number for each of the {count} constituents, not {len(values)}"
            )
        return values
