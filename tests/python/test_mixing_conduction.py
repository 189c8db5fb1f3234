# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing laws of thermal conductivity and expansion against closed forms and exact relations."""
import itertools

import numpy as np
import pytest

from mixtures import (
    SPHERES,
    TWO,
    cards_of,
    elastic_cards,
    mixed,
    mixed_moduli,
    random_fractions,
)


def test_maxwell():
    """Grains p in a matrix m: Maxwell (1873)."""
    m, p, v = 204.0, 27.0, TWO[:, 1]
    expected = m * (2 * m + p + 2 * v * (p - m)) / (2 * m + p - v * (p - m))
    cards = {"ThermalConductivity": (m, p)}
    np.testing.assert_allclose(
        mixed("ThermalConductivity", "mori_tanaka(1)", TWO, cards), expected, rtol=1e-12
    )


@pytest.mark.parametrize("parts", [(204.0, 27.0), (1.0, 1e6), (1e-9, 5.0)])
def test_bruggeman(parts):
    """Two constituents: 2k^2 - bk - k1 k2 = 0 with b = (3 v1 - 1) k1 + (3 v2 - 1) k2 (Bruggeman 1935)."""
    b = (3 * TWO - 1) @ parts
    root = np.sqrt(b**2 + 8 * parts[0] * parts[1])
    # Of the two forms of the root, the one that subtracts nothing.
    expected = np.where(b > 0, (b + root) / 4, 2 * parts[0] * parts[1] / np.where(b > 0, 1, root - b))
    cards = {"ThermalConductivity": parts}
    np.testing.assert_allclose(
        mixed("ThermalConductivity", "self_consistent", TWO, cards), expected, rtol=1e-10
    )


def test_bounds_of_conductivity():
    fractions, cards = random_fractions(4), cards_of(4)
    chain = ["reuss", "hashin_shtrikman_lower", "self_consistent", "hashin_shtrikman_upper", "voigt"]
    values = [mixed("ThermalConductivity", law, fractions, cards) for law in chain]
    assert all((a <= b * (1 + 1e-12)).all() for a, b in itertools.pairwise(values))


@pytest.mark.parametrize("law", [*SPHERES, "mori_tanaka(1)"])
def test_expansion_keeps_levins_relation(law):
    """Levin, Mech. Solids 2 (1967) 58: what the bulk modulus of two constituents is, settles their expansion."""
    bulk, shear, alpha = np.array([70.0, 230.0]), np.array([26.0, 155.0]), np.array([23e-6, 7.4e-6])
    whole, _ = mixed_moduli(law, TWO, bulk, shear)
    slope = (alpha[0] - alpha[1]) / (1 / bulk[0] - 1 / bulk[1])
    expected = TWO @ alpha + slope * (1 / whole - TWO @ (1 / bulk))
    cards = {**elastic_cards(bulk, shear), "ThermalExpansionCoefficient": alpha}
    np.testing.assert_allclose(mixed("ThermalExpansionCoefficient", law, TWO, cards), expected, rtol=1e-11)


@pytest.mark.parametrize("law", SPHERES)
def test_expansion_of_all_alike_is_theirs(law):
    cards = {**cards_of(4), "ThermalExpansionCoefficient": (-1e-6,) * 4}
    values = mixed("ThermalExpansionCoefficient", law, random_fractions(4), cards)
    np.testing.assert_allclose(values, -1e-6, rtol=1e-12)
