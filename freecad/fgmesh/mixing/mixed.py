# SPDX-License-Identifier: GPL-3.0-or-later
"""The properties of mixtures, each by its law."""
import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.mixing import comparison, conduction, elastic
from freecad.fgmesh.mixing.formula import Formula
from freecad.fgmesh.mixing.properties import PROPERTIES, Cards, check_name

_ROUNDING = 1e-6
"""How far fractions may be from [0, 1], and their sum from 1."""


def mixed(fractions, cards, laws, wanted=None, within_range=True):
    """{property: (n,) floats} of the mixtures with `fractions` (n, k), rows of the sum 1.

    cards: {property: (k,) numbers} of the constituents, in units that fit together (the stress in tamura(q) and the
    values of formulas included); None or NaN where a constituent's is not known. laws: what `read_laws` gives.
    wanted: names of properties; where None, of all that are in `cards`. within_range: whether what formulas give must be
    in the range of its property; only these fractions count.

    Voigt's and Reuss's means are those of the property itself, Young's modulus and Poisson's ratio included, as the
    literature on graded materials has it; but for Reuss's Poisson's ratio, which is that of the bulk and shear moduli,
    whose harmonic means give the harmonic mean of Young's moduli, too. All other laws of both work on bulk and
    shear moduli: see `elastic`.

    Raises InvalidInput: fractions, properties or laws that have no meaning, a constituent without a property that a
    law needs, values outside of their range in cards or from formulas.
    """
    fractions = _checked(fractions)
    mixture = _Mixture(fractions, Cards(cards, fractions.shape[1]), within_range)
    values = {}
    for name in cards if wanted is None else wanted:
        check_name(name)
        values[name] = mixture.value(name, laws[name])
    return values


class _Mixture:
    def __init__(self, fractions, cards, within_range):
        self.fractions, self.cards, self._within_range = fractions, cards, within_range
        self._moduli = {}  # both of Young's modulus and Poisson's ratio ask for the same

    def value(self, name, law):
        """The property `name` by its Law or Formula, (n,)."""
        law.check(self.fractions.shape[1])
        if isinstance(law, Formula):
            return law.values(self.fractions, self.cards, self._within_range)
        purpose = f"{name} by {law.name}"
        values = self.cards.of(name, purpose)
        if law.name == "voigt":
            return self.fractions @ values
        if law.name == "by_mass":
            masses = self.fractions * self.cards.of("Density", purpose)
            return masses @ values / masses.sum(axis=1)
        if law.name == "tamura":
            # Tamura, Tomota and Ozawa, 3rd Int. Conf. Strength of Metals and Alloys (1973) 611, both strain and
            # stress of the constituents being different: q = (s1 - s2)/(e2 - e1).
            return comparison.mean(self.fractions, values, law.number)
        if name in ("YoungsModulus", "PoissonRatio"):
            moduli = self._elastic(law, purpose)
            return moduli.young if name == "YoungsModulus" else moduli.poisson
        if name == "ThermalExpansionCoefficient":
            return elastic.expansion(law, self.fractions, self._parts(purpose), values)
        if law.name in ("reuss", "hill"):
            series = comparison.mean(self.fractions, values, 0)
            return series if law.name == "reuss" else (series + self.fractions @ values) / 2
        return conduction.conductivity(law, self.fractions, values)

    def _parts(self, purpose):
        return elastic.of_constituents(
            self.cards.of("YoungsModulus", purpose), self.cards.of("PoissonRatio", purpose)
        )

    def _elastic(self, law, purpose):
        key = law.name, law.number
        if key not in self._moduli:
            self._moduli[key] = elastic.mixture(law, self.fractions, self._parts(purpose))
        return self._moduli[key]


def _checked(fractions):
    """(n, k) floats of the sum 1, none below zero, but for rounding those that were given."""
    try:
        fractions = np.asarray(fractions, float)
    except (TypeError, ValueError):
        raise core.InvalidInput("fractions must be an array of numbers of shape (n, k)") from None
    if fractions.ndim != 2 or fractions.shape[1] < 1:
        raise core.InvalidInput(f"fractions must be an array of shape (n, k), not {fractions.shape}")
    sums = fractions.sum(axis=1)
    fine = (fractions >= -_ROUNDING).all(axis=1) & (np.abs(sums - 1) <= _ROUNDING)
    if not fine.all():
        place = np.flatnonzero(~fine)[0]
        row = ", ".join(f"{value:.6g}" for value in fractions[place])
        raise core.InvalidInput(
            f"the fractions at place {place} are {row}: "
            "they must lie between 0 and 1 and have the sum 1, so correct the material's formulas"
        )
    fractions = np.maximum(fractions, 0)
    return fractions / fractions.sum(axis=1, keepdims=True)
