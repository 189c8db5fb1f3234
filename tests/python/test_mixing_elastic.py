# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic mixing laws against closed forms, exact relations and bounds."""
import itertools

import numpy as np
import pytest

from freecad.fgmesh import mixing

from mixtures import (
    ELASTIC,
    SPHERES,
    TWO,
    cards_of,
    elastic_cards,
    mixed,
    mixed_moduli,
    random_fractions,
    random_moduli,
)


@pytest.mark.parametrize("count", [2, 3, 4])
@pytest.mark.parametrize("seed", range(5))
def test_bounds_are_in_order(count, seed):
    """Of any mixture, the stiffest in bulk not being the stiffest in shear (Walpole 1966)."""
    fractions, parts = random_fractions(count), random_moduli(count, seed)
    chain = [mixed_moduli(law, fractions, *parts) for law in ("reuss", *SPHERES[:2])]
    chain.append([fractions @ one for one in parts])
    for lower, upper in itertools.pairwise(chain):
        for a, b in zip(lower, upper):
            assert (a <= b * (1 + 1e-12)).all()


@pytest.mark.parametrize("count", [2, 3, 4])
@pytest.mark.parametrize("law", ["self_consistent", "mori_tanaka(1)", "mori_tanaka(2)"])
def test_estimates_lie_within_the_bounds(law, count):
    fractions, parts = random_fractions(count), random_moduli(count, 7)
    lower, found, upper = (mixed_moduli(one, fractions, *parts) for one in (*SPHERES[:1], law, SPHERES[1]))
    for a, b, c in zip(lower, found, upper):
        assert (a <= b * (1 + 1e-12)).all() and (b <= c * (1 + 1e-12)).all()


def test_hashin_shtrikman_of_two_constituents():
    """Hashin and Shtrikman, J. Mech. Phys. Solids 11 (1963) 127; here 1 is the softer."""
    (k1, k2), (g1, g2) = (30.0, 200.0), (12.0, 90.0)
    v1, v2 = TWO.T

    def bound(ka, ga, va, kb, gb, vb):
        bulk = ka + vb / (1 / (kb - ka) + 3 * va / (3 * ka + 4 * ga))
        shear = ga + vb / (1 / (gb - ga) + 6 * (ka + 2 * ga) * va / (5 * ga * (3 * ka + 4 * ga)))
        return bulk, shear

    for law, expected in zip(SPHERES, (bound(k1, g1, v1, k2, g2, v2), bound(k2, g2, v2, k1, g1, v1))):
        found = mixed_moduli(law, TWO, (k1, k2), (g1, g2))
        np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_mori_tanaka_from_the_dilute_concentrations_of_eshelby():
    """Benveniste, Mech. Mater. 6 (1987) 147: the strain in a grain alone in the matrix (Eshelby 1957), over its mean."""
    fractions = random_fractions(3)
    bulk, shear = random_moduli(3, 3)
    for matrix in range(3):
        k, g = bulk[matrix], shear[matrix]
        dilatation, distortion = 3 * k / (3 * k + 4 * g), 6 * (k + 2 * g) / (5 * (3 * k + 4 * g))
        expected = []
        for parts, factor in ((bulk, dilatation), (shear, distortion)):
            dilute = 1 / (1 + factor * (parts / parts[matrix] - 1))
            expected.append(fractions @ (dilute * parts) / (fractions @ dilute))
        found = mixed_moduli(f"mori_tanaka({matrix + 1})", fractions, bulk, shear)
        np.testing.assert_allclose(found, expected, rtol=1e-11)


@pytest.mark.parametrize("name", ["YoungsModulus", "PoissonRatio", "ThermalConductivity"])
def test_mori_tanaka_is_a_bound_where_the_matrix_is_extreme(name):
    """Weng, Int. J. Eng. Sci. 28 (1990) 1111. Constituents that are in the same order in all."""
    cards = {**elastic_cards((10, 200, 40), (5, 90, 21)), "ThermalConductivity": (1, 30, 4)}
    fractions = random_fractions(3)
    for number, bound in ((1, "lower"), (2, "upper")):
        np.testing.assert_allclose(
            mixed(name, f"mori_tanaka({number})", fractions, cards),
            mixed(name, f"hashin_shtrikman_{bound}", fractions, cards),
            rtol=1e-12,
        )


def test_the_matrix_is_the_last_unless_named():
    cards, fractions = cards_of(3), random_fractions(3)
    last, third = (
        mixed("YoungsModulus", text, fractions, cards) for text in ("mori_tanaka", "mori_tanaka(3)")
    )
    assert np.array_equal(last, third)


@pytest.mark.parametrize("law", SPHERES)
def test_constituents_of_one_shear_modulus(law):
    """Then the bulk modulus is known whatever the microgeometry: Hill, J. Mech. Phys. Solids 11 (1963) 357."""
    fractions, bulk, shear = random_fractions(3), np.array([3.0, 80.0, 20.0]), 11.0
    found = mixed_moduli(law, fractions, bulk, [shear] * 3)
    exact = 1 / (fractions @ (1 / (bulk + 4 / 3 * shear))) - 4 / 3 * shear
    np.testing.assert_allclose(found[0], exact, rtol=1e-11)
    np.testing.assert_allclose(found[1], shear, rtol=1e-12)


@pytest.mark.parametrize("count", [2, 3, 4])
@pytest.mark.parametrize("seed", range(3))
def test_self_consistent_keeps_its_equations(count, seed):
    """Budiansky, J. Mech. Phys. Solids 13 (1965) 223: strains of the grains have the strain of all as their mean."""
    fractions, (bulk, shear) = random_fractions(count), random_moduli(count, seed)
    k, g = mixed_moduli("self_consistent", fractions, bulk, shear)
    poisson = (3 * k - 2 * g) / (6 * k + 2 * g)
    a = (1 + poisson) / (3 * (1 - poisson))
    b = 2 * (4 - 5 * poisson) / (15 * (1 - poisson))
    for factor, parts, whole in ((a, bulk, k), (b, shear, g)):
        strains = 1 / (1 + factor[:, None] * (parts / whole[:, None] - 1))
        np.testing.assert_allclose((fractions * strains).sum(axis=1), 1, rtol=1e-11)


def test_self_consistent_with_pores():
    """Incompressible with pores of the fraction c: G/G1 = 3(1 - 2c)/(3 - c) (Budiansky 1965), and
    K = 4G(1 - c)/(3c), both from his equations with K1 without bound and K2 = G2 = 0."""
    c = np.array([0.01, 0.1, 0.25, 0.4, 0.49])
    fractions = np.column_stack([1 - c, c])
    bulk, shear = mixed_moduli("self_consistent", fractions, (1e8, 1e-9), (1.0, 1e-9))
    exact = 3 * (1 - 2 * c) / (3 - c)
    np.testing.assert_allclose(shear, exact, rtol=1e-5)
    np.testing.assert_allclose(bulk, 4 * exact * (1 - c) / (3 * c), rtol=1e-5)


@pytest.mark.parametrize("poisson", [-0.5, 0.0, 0.2, 0.4])
def test_self_consistent_loses_its_stiffness_at_half_pores(poisson):
    """As G vanishes, 4G(1 - c)/(3c) is K for any solid, and thus c = 1/2 the end for any (Budiansky 1965)."""
    cards = {"YoungsModulus": (1.0, 1e-12), "PoissonRatio": (poisson, 0.2)}
    c = np.array([0.49, 0.5, 0.51, 0.9])
    young = mixed("YoungsModulus", "self_consistent", np.column_stack([1 - c, c]), cards)
    assert young[0] > 1e-3 and young[1] < 1e-5 and (young[2:] < 1e-10).all()
    assert (np.diff(young) < 0).all()


def test_self_consistent_with_rigid_grains():
    """In an incompressible medium G/G1 = 1/(1 - 5c/2): Hill, J. Mech. Phys. Solids 13 (1965) 213."""
    c = np.array([0.0, 0.1, 0.2, 0.3, 0.38])
    _, shear = mixed_moduli("self_consistent", np.column_stack([c, 1 - c]), (1e10, 1e8), (1e10, 1.0))
    np.testing.assert_allclose(shear, 1 / (1 - 2.5 * c), rtol=1e-5)


def test_poisson_ratio_comes_from_the_law_of_youngs_modulus():
    fractions, cards = random_fractions(3), cards_of(3)
    for law in ("reuss", "hill", *SPHERES):
        alone = mixing.mixed(fractions, cards, mixing.read_laws({"YoungsModulus": law}), ELASTIC)
        both = mixing.mixed(fractions, cards, mixing.read_laws(dict.fromkeys(ELASTIC, law)), ELASTIC)
        assert all(np.array_equal(alone[name], both[name]) for name in ELASTIC)
    for law in ("voigt", "p1", None):
        values = mixing.mixed(fractions, cards, mixing.read_laws({"YoungsModulus": law}), ELASTIC)
        np.testing.assert_allclose(values["PoissonRatio"], fractions @ cards["PoissonRatio"])
    for law, other in itertools.permutations(SPHERES, 2):
        laws = mixing.read_laws({"YoungsModulus": law, "PoissonRatio": other})
        values = mixing.mixed(fractions, cards, laws, ELASTIC)
        assert np.array_equal(values["YoungsModulus"], mixed("YoungsModulus", law, fractions, cards))
        assert np.array_equal(values["PoissonRatio"], mixed("PoissonRatio", other, fractions, cards))


def test_tamura_shares_stress_and_strain():
    """q is what stress one constituent has more than the other for each strain that it has less: for e1 = 1,
    s1 - s2 = q(e2 - 1), and E is the mean stress over the mean strain (Tamura, Tomota and Ozawa 1973)."""
    e1, e2, q = 70000.0, 380000.0, 4500.0
    strain = (e1 + q) / (e2 + q)  # of the second, from e1 - e2*strain = q*(strain - 1)
    v1, v2 = TWO.T
    expected = (v1 * e1 + v2 * e2 * strain) / (v1 + v2 * strain)
    found = mixed("YoungsModulus", "tamura(4500)", TWO, {"YoungsModulus": (e1, e2)})
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_tamura_lies_between_reuss_and_voigt():
    cards = cards_of(2)
    for text, limit, rtol in (("tamura(0)", "reuss", 1e-12), ("tamura( 1e20 )", "voigt", 1e-9)):
        found, expected = (mixed("YoungsModulus", law, TWO, cards) for law in (text, limit))
        np.testing.assert_allclose(found, expected, rtol=rtol)
