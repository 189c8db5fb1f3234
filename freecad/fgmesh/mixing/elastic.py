# SPDX-License-Identifier: GPL-3.0-or-later
"""Isotropic mixtures of isotropic elastic constituents: their bulk and shear moduli, and thermal expansion.

Arrays are fractions (n, k), and properties of the constituents (k,) in one unit of stress.
"""
from typing import NamedTuple

import numpy as np

from freecad.fgmesh.mixing import comparison

LAWS = ("reuss", "hill", "hashin_shtrikman_lower", "hashin_shtrikman_upper", "mori_tanaka", "self_consistent")
"""Those that work on bulk and shear moduli, so that Young's modulus and Poisson's ratio come from one of them."""


class Moduli(NamedTuple):
    bulk: np.ndarray
    shear: np.ndarray

    @property
    def young(self):
        return 9 * self.bulk * self.shear / (3 * self.bulk + self.shear)

    @property
    def poisson(self):
        return (3 * self.bulk - 2 * self.shear) / (6 * self.bulk + 2 * self.shear)


def of_constituents(young, poisson):
    """Moduli (k,) of Young's moduli and Poisson's ratios."""
    return Moduli(young / (3 * (1 - 2 * poisson)), young / (2 * (1 + poisson)))


def mixture(law, fractions, parts):
    """Moduli (n,) of the mixture by a Law named in `LAWS`; parts: Moduli of the constituents.

    Reuss, Z. angew. Math. Mech. 9 (1929) 49; Hill, Proc. Phys. Soc. A 65 (1952) 349: half of Voigt's and half of
    Reuss's moduli. The others: see `media`.
    """
    if law.name == "hill":
        halves = [(fractions @ one + comparison.mean(fractions, one, 0)) / 2 for one in parts]
        return Moduli(*halves)
    stars = (0, 0) if law.name == "reuss" else media(law, fractions, parts)
    return Moduli(*(comparison.mean(fractions, one, star) for one, star in zip(parts, stars)))


def media(law, fractions, parts):
    """K* and G* of the comparison medium with moduli K0, G0, around spherical grains, one number or (n,) each.

    Hashin and Shtrikman, J. Mech. Phys. Solids 11 (1963) 127, in Walpole's form (the same 14 (1966) 151), which
    allows for the stiffest in bulk not being that in shear: K0 and G0 are the least or largest of any constituent.
    Mori and Tanaka, Acta Metall. 21 (1973) 571, in Benveniste's form (Mech. Mater. 6 (1987) 147): those of the matrix.
    Hill, J. Mech. Phys. Solids 13 (1965) 213, and Budiansky (the same, 223): those of the mixture itself.
    """
    if law.name == "self_consistent":
        return _stars(*_self_consistent(fractions, parts))
    if law.name == "mori_tanaka":
        return _stars(*(one[law.matrix] for one in parts))
    extreme = np.min if law.name == "hashin_shtrikman_lower" else np.max
    return _stars(*(extreme(one) for one in parts))


def expansion(law, fractions, parts, expansions):
    """The thermal expansion (n,) that goes with the bulk modulus by `law`; expansions (k,).

    The sum of v_i B_i alpha_i, B_i = K_i A_i/K being the share of a constituent in a hydrostatic stress. For two
    constituents that is the exact relation of Levin (Mech. Solids 2 (1967) 58), whatever the law.
    """
    star, _ = media(law, fractions, parts)
    shares = comparison.weights(fractions, parts.bulk, star) * parts.bulk
    return shares @ expansions / shares.sum(axis=1)


def _stars(bulk, shear):
    return 4 / 3 * shear, shear * (9 * bulk + 8 * shear) / (6 * (bulk + 2 * shear))


def _self_consistent(fractions, parts):
    """K0 follows from G0, so that one unknown is left, between Reuss's and Voigt's mean."""

    def bulk(shear):
        return comparison.mean(fractions, parts.bulk, 4 / 3 * shear)

    def answer(shear):
        _, star = _stars(bulk(shear), shear)
        return comparison.mean(fractions, parts.shear, star)

    low, high = comparison.mean(fractions, parts.shear, 0), fractions @ parts.shear
    shear = comparison.matching(answer, low, high)
    return bulk(shear), shear
