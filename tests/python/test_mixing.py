# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing laws against closed forms, exact relations and bounds."""
import itertools
import math

import numpy as np
import pytest

from freecad.fgmesh import core, mixing

CARDS = {
    "YoungsModulus": (70000.0, 380000.0, 110000.0, 205000.0),
    "PoissonRatio": (0.33, 0.22, 0.35, 0.29),
    "Density": (2.7e-9, 3.9e-9, 4.4e-9, 7.9e-9),
    "ThermalConductivity": (204.0, 27.0, 7.2, 45.0),
    "ThermalExpansionCoefficient": (23e-6, 7.4e-6, 8.6e-6, 12e-6),
    "SpecificHeat": (9.0e8, 7.8e8, 5.4e8, 4.6e8),
    "YieldStrength": (95.0, 300.0, 880.0, 250.0),
}
SPHERES = ("hashin_shtrikman_lower", "hashin_shtrikman_upper", "mori_tanaka", "self_consistent")
ELASTIC = ("YoungsModulus", "PoissonRatio")
LAW_OF_EACH = [(name, law) for name in mixing.PROPERTIES for law in mixing.laws_of(name)]
FRACTION = np.linspace(0, 1, 21)
TWO = np.column_stack([1 - FRACTION, FRACTION])


def cards_of(count):
    return {name: values[:count] for name, values in CARDS.items()}


def random_fractions(count, places=200):
    return np.random.default_rng(count).dirichlet(np.ones(count), places)


def random_moduli(count, seed):
    """Bulk and shear moduli (count,), not ordered alike."""
    rng = np.random.default_rng(seed)
    return np.exp(rng.uniform(0, 5, count)), np.exp(rng.uniform(0, 5, count))


def elastic_cards(bulk, shear):
    bulk, shear = np.array(bulk), np.array(shear)
    young = 9 * bulk * shear / (3 * bulk + shear)
    return {"YoungsModulus": young, "PoissonRatio": young / (2 * shear) - 1}


def mixed(name, law, fractions, cards):
    text = f"{law}(150000)" if law == "tamura" else law
    return mixing.mixed(fractions, cards, mixing.read_laws({name: text}), (name,))[name]


def mixed_moduli(law, fractions, bulk, shear):
    """(K, G) of the mixture, through Young's modulus and Poisson's ratio."""
    laws = mixing.read_laws({"YoungsModulus": law})
    values = mixing.mixed(fractions, elastic_cards(bulk, shear), laws)
    young, poisson = (values[name] for name in ELASTIC)
    return young / (3 - 6 * poisson), young / (2 + 2 * poisson)


# What holds for every law


@pytest.mark.parametrize("name, law", LAW_OF_EACH)
@pytest.mark.parametrize("count", [2, 3, 4])
def test_pure_constituents_are_as_their_cards(name, law, count):
    if law == "tamura" and count > 2:
        return
    values = mixed(name, law, np.eye(count), cards_of(count))
    np.testing.assert_allclose(values, CARDS[name][:count], rtol=1e-12)


@pytest.mark.parametrize("name, law", LAW_OF_EACH)
def test_equal_constituents_mix_to_themselves(name, law):
    cards = {key: values[:1] * 2 for key, values in CARDS.items()}
    np.testing.assert_allclose(mixed(name, law, TWO, cards), CARDS[name][0], rtol=1e-12)


@pytest.mark.parametrize("name, law", LAW_OF_EACH)
def test_numbers_of_constituents_mean_nothing(name, law):
    count = 2 if law == "tamura" else 3
    fractions, cards = random_fractions(count), cards_of(count)
    expected = mixed(name, law, fractions, cards)
    for order in itertools.permutations(range(count)):
        turned = {key: np.array(values)[list(order)] for key, values in cards.items()}
        text = f"mori_tanaka({order.index(count - 1) + 1})" if law == "mori_tanaka" else law
        np.testing.assert_allclose(
            mixed(name, text, fractions[:, order], turned), expected, rtol=1e-12, err_msg=f"{order}"
        )


@pytest.mark.parametrize("name, law", LAW_OF_EACH)
def test_a_constituent_in_two_parts_is_one(name, law):
    if law in ("tamura", "mori_tanaka"):
        return  # of two constituents alone; of one matrix
    halves = np.column_stack([TWO[:, 0] / 3, 2 * TWO[:, 0] / 3, TWO[:, 1]])
    cards = {key: (values[0], values[0], values[1]) for key, values in CARDS.items()}
    np.testing.assert_allclose(
        mixed(name, law, halves, cards), mixed(name, law, TWO, cards_of(2)), rtol=1e-12
    )


@pytest.mark.parametrize("name, law", LAW_OF_EACH)
def test_results_scale_with_the_unit(name, law):
    """From N and mm to N and m, say; ratios stay."""
    scale = 1 if name in ("PoissonRatio", "ThermalExpansionCoefficient") else 1e-6
    cards = cards_of(2)
    scaled = {**cards, "YoungsModulus": np.array(cards["YoungsModulus"]) * 1e-6}
    scaled[name] = np.array(cards[name]) * scale
    text = "tamura(0.15)" if law == "tamura" else law
    np.testing.assert_allclose(
        mixed(name, text, TWO, scaled), mixed(name, law, TWO, cards) * scale, rtol=1e-11
    )


def test_no_places_give_no_values():
    laws = mixing.read_laws(dict.fromkeys(ELASTIC, "self_consistent"))
    values = mixing.mixed(np.empty((0, 3)), cards_of(3), laws)
    assert set(values) == set(CARDS) and all(value.shape == (0,) for value in values.values())


# Means


@pytest.mark.parametrize("name", mixing.PROPERTIES)
def test_voigt_is_the_arithmetic_mean_of_the_property(name):
    halves = np.full((1, 4), 0.25)
    assert mixed(name, "voigt", halves, CARDS)[0] == pytest.approx(sum(CARDS[name]) / 4)


@pytest.mark.parametrize("name", ["YoungsModulus", "ThermalConductivity", "YieldStrength"])
def test_reuss_is_the_harmonic_mean_of_the_property(name):
    """For Young's modulus, too, since 1/E = 1/(3G) + 1/(9K) is linear in 1/G and 1/K."""
    a, b, c, d = CARDS[name]
    mean = 4 / (1 / a + 1 / b + 1 / c + 1 / d)
    assert mixed(name, "reuss", np.full((1, 4), 0.25), CARDS)[0] == pytest.approx(mean)


@pytest.mark.parametrize("name", ["ThermalConductivity", "YieldStrength"])
def test_hill_is_half_voigt_and_half_reuss(name):
    cards = {name: (100, 300)}  # means 200 and 150
    assert mixed(name, "hill", [[0.5, 0.5]], cards)[0] == pytest.approx(175)


def test_reuss_and_hill_of_moduli():
    fractions = random_fractions(3)
    bulk, shear = random_moduli(3, 5)
    for found, parts in zip(mixed_moduli("reuss", fractions, bulk, shear), (bulk, shear)):
        np.testing.assert_allclose(found, 1 / (fractions @ (1 / parts)), rtol=1e-12)
    for found, parts in zip(mixed_moduli("hill", fractions, bulk, shear), (bulk, shear)):
        np.testing.assert_allclose(found, (fractions @ parts + 1 / (fractions @ (1 / parts))) / 2, rtol=1e-12)


def test_by_mass():
    """A kg of each at 1 and 3 kg/m^3 fills 3 of 4 parts with the lighter: heat of 2 kg is that of both."""
    cards = {"Density": (1, 3), "SpecificHeat": (2, 4)}
    fractions = [[0.75, 0.25], [0.5, 0.5]]  # 1:1 and 1:3 by mass
    np.testing.assert_allclose(mixed("SpecificHeat", "by_mass", fractions, cards), [3, 3.5])


# Elastic laws


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
    """Hashin and Shtrikman, J. Mech. Phys. Solids 11 (1963) 127, equations 4.1 to 4.4; here 1 is the softer."""
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


# Conductivity and expansion


def test_maxwell():
    """Grains p in a matrix m: Maxwell (1873), article 314."""
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


# Formulas


@pytest.mark.parametrize("count", [2, 3, 4, 12])
def test_formula_of_any_number_of_constituents(count):
    fractions = random_fractions(count)
    values = np.random.default_rng(1).uniform(1, 2, count)
    text = " + ".join(f"v{i}*p{i}" for i in range(1, count + 1))
    found = mixed("Density", text, fractions, {"Density": values})
    np.testing.assert_allclose(found, fractions @ values, rtol=1e-12)


def test_formulas_against_closed_forms():
    (p1, p2), (v1, v2) = CARDS["ThermalConductivity"][:2], TWO.T
    cases = {
        "p1 + (p2 - p1)*v2^2": p1 + (p2 - p1) * v2**2,
        "p1^v1*p2^v2": p1**v1 * p2**v2,
        "1e2*max(v1, v2)+2e-1*pi": 100 * np.maximum(v1, v2) + 0.2 * math.pi,
        "v1 > 0.5 ? p1 : exp(v2)*YoungsModulus2": np.where(v1 > 0.5, p1, np.exp(v2) * 380000),
        "42": np.full(21, 42.0),
    }
    for text, expected in cases.items():
        found = mixed("ThermalConductivity", text, TWO, cards_of(2))
        np.testing.assert_allclose(found, expected, rtol=1e-12, err_msg=text)


def test_formula_may_name_other_properties():
    text = "(v1*Density1*p1 + v2*Density2*p2)/(v1*Density1 + v2*Density2)"
    found, expected = (mixed("SpecificHeat", law, TWO, cards_of(2)) for law in (text, "by_mass"))
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_formula_needs_only_the_values_that_it_names():
    cards = {"YoungsModulus": (100.0, None), "PoissonRatio": (math.nan, 0.25)}
    laws = mixing.read_laws({"YoungsModulus": "p1*(1 - 0.5*v2)", "PoissonRatio": "p2"})
    values = mixing.mixed([[0.5, 0.5]], cards, laws)
    assert values["YoungsModulus"][0] == 75 and values["PoissonRatio"][0] == 0.25


@pytest.mark.parametrize(
    "text, place, told",
    [
        ("v1*x", 3, "'x'"),
        ("theta*v1", 0, "'theta'"),
        ("p1 + d1", 5, "'d1'"),
        ("v1 + s2", 5, "'s2'"),
        ("v1*(p1 + p2", 3, "never closed"),
        ("v1 v2", 3, "'v1' and 'v2'"),
        ("v2(3)", 2, "'v2' is no function"),
        ("p1*v1 + rho2*v2", 8, "'rho2'; a formula here knows v1 v2"),
        ("min(v1, foo(v2))", 8, "'foo'; a formula here knows v1 v2"),
        ("p1 + v3", 5, "'v3' is of constituent 3, but there are only 2"),
        ("p1 + p3*v2", 5, "'p3' is of constituent 3"),
        ("Density5", 0, "'Density5' is of constituent 5"),
        ("p1 + v01", 5, "'v01'"),
        ("p1**v1", 2, "write ^"),
        ("é + v1", 0, "belongs to no formula"),
        ("v1 + ä", 5, "belongs to no formula"),
        ("__import__('os')", 0, "'__import__'"),
    ],
)
def test_faults_of_formulas_are_placed(text, place, told):
    with pytest.raises(core.FormulaError) as caught:
        mixing.read_laws({"YoungsModulus": text}, constituents=2)
    message = str(caught.value)
    assert message.startswith("YoungsModulus: ") and told in message
    assert caught.value.position == place and f"(character {place + 1})" in message
    assert "theta d" not in message and "'d2'" not in message


def test_formula_is_checked_for_the_constituents_there_are():
    laws = mixing.read_laws({"Density": "p1*v1 + p3*v3"})
    with pytest.raises(core.FormulaError, match="'p3' is of constituent 3, but there are only 2"):
        mixing.mixed(TWO, cards_of(2), laws, ("Density",))


@pytest.mark.parametrize(
    "name, text, told",
    [
        (
            "YoungsModulus",
            "p1*(0.5 - v2)",
            "0 where v1 = 0.5, v2 = 0.5, but must be finite and above 0",
        ),
        ("YoungsModulus", "p1/(v1 - 0.5)", "inf where v1 = 0.5, v2 = 0.5"),
        ("Density", "p1*sqrt(0.71 - v2)", "nan where v1 = 0.25, v2 = 0.75"),
        ("PoissonRatio", "0.4 + v2/5", "0.5 where v1 = 0.5, v2 = 0.5, but must be above -1 and below 0.5"),
        ("PoissonRatio", "-2", "-2 where v1 = 1, v2 = 0"),
        ("ThermalExpansionCoefficient", "1/v1", "inf where v1 = 0, v2 = 1, but must be finite"),
    ],
)
def test_results_of_formulas_must_have_a_meaning(name, text, told):
    laws = mixing.read_laws({name: text})
    with pytest.raises(core.InvalidInput) as caught:
        order = np.argsort(TWO[:, 1] if text != "p1/(v1 - 0.5)" else np.abs(TWO[:, 1] - 0.5))
        mixing.mixed(TWO[order], cards_of(2), laws, (name,))
    assert str(caught.value).startswith(f"{name}: the formula {text!r} gives {told}")


# Laws and their texts


def test_defaults():
    laws = mixing.read_laws({"Density": None, "YieldStrength": "  "})
    assert list(laws) == list(mixing.PROPERTIES)
    assert {name: law.name for name, law in laws.items()} == {
        **dict.fromkeys(mixing.PROPERTIES, "voigt"),
        "SpecificHeat": "by_mass",
    }


@pytest.mark.parametrize("text", ["mori_tanaka(2)", " Mori-Tanaka ( 2 ) ", "mori tanaka(2.0)"])
def test_names_of_laws_may_be_written_otherwise(text):
    assert mixing.read_laws({"YoungsModulus": text})["YoungsModulus"] == ("YoungsModulus", "mori_tanaka", 2)


def test_laws_for_menus():
    for name in mixing.PROPERTIES:
        names = mixing.laws_of(name)
        assert names[0] == "voigt" and list(names) == [law for law in mixing.LAWS if law in names]
    assert mixing.laws_of("Density") == ("voigt",)
    assert "tamura" in mixing.laws_of("YoungsModulus") and "tamura" not in mixing.laws_of("PoissonRatio")
    assert set(SPHERES) <= set(mixing.laws_of("ThermalExpansionCoefficient"))
    assert all(kind.description for kind in mixing.LAWS.values())


@pytest.mark.parametrize(
    "texts, told",
    [
        ({"Youngs": "voigt"}, "'Youngs'.*YoungsModulus"),
        ({"Density": 3}, "Density: .* text, not 3"),
        ({"YoungsModulus": "Mori-Tanake"}, "YoungsModulus: .*'Mori-Tanake': did you mean mori_tanaka"),
        ({"YoungsModulus": "banana"}, "YoungsModulus: .*'banana': write voigt, reuss"),
        ({"Density": "reuss"}, "Density: 'reuss' is no law for it: write voigt, or a formula"),
        ({"YieldStrength": "mori_tanaka"}, "YieldStrength: 'mori_tanaka' is no law"),
        ({"ThermalConductivity": "tamura(4)"}, "ThermalConductivity: 'tamura' is no law"),
        ({"YoungsModulus": "voigt(2)"}, "YoungsModulus: .*'voigt\\(2\\)'"),
        ({"YoungsModulus": "tamura"}, "YoungsModulus: 'tamura' lacks.*tamura\\(4500\\)"),
        ({"YoungsModulus": "tamura()"}, "lacks its stress transfer"),
        ({"YoungsModulus": "tamura(-1)"}, "at least 0"),
        ({"YoungsModulus": "tamura(nan)"}, "at least 0"),
        ({"YoungsModulus": "tamura(inf)"}, "at least 0"),
        ({"YoungsModulus": "mori_tanaka(0)"}, "names no matrix.*mori_tanaka\\(1\\)"),
        ({"YoungsModulus": "mori_tanaka(1.5)"}, "names no matrix"),
        ({"YoungsModulus": "mori_tanaka(inf)"}, "names no matrix"),
        ({"YoungsModulus": "mori_tanaka(v1)"}, "names no matrix"),
        ({"YoungsModulus": "mori_tanaka(4)"}, "mori_tanaka\\(4\\) is none of the 3 constituents.*1 to 3"),
        ({"YoungsModulus": "tamura(4500)"}, "for two constituents, not 3"),
    ],
)
def test_texts_that_are_no_law(texts, told):
    with pytest.raises(core.InvalidInput, match=told):
        mixing.read_laws(texts, constituents=3)


@pytest.mark.parametrize("text", ["mori_tanaka(4)", "tamura(4500)"])
def test_laws_are_checked_for_the_constituents_there_are(text):
    laws = mixing.read_laws({"YoungsModulus": text})
    with pytest.raises(core.InvalidInput, match="3"):
        mixing.mixed(random_fractions(3), cards_of(3), laws, ("YoungsModulus",))


# Cards and fractions


@pytest.mark.parametrize(
    "name, law, changed, told",
    [
        (
            "Density",
            "voigt",
            {"Density": (1, None)},
            "constituent 2 has no Density, .*Density by voigt.*add it",
        ),
        ("Density", "voigt", {"Density": None}, "constituent 1 has no Density"),
        ("SpecificHeat", "by_mass", {"Density": (math.nan, 1)}, "constituent 1 has no Density, .*by_mass"),
        ("YoungsModulus", "hill", {"PoissonRatio": (0.3, None)}, "constituent 2 has no PoissonRatio"),
        (
            "YoungsModulus",
            "p1*v2",
            {"YoungsModulus": (None, 1)},
            "constituent 1 has no .*the formula of Young",
        ),
        (
            "ThermalExpansionCoefficient",
            "mori_tanaka",
            {"YoungsModulus": (1, None)},
            "2 has no YoungsModulus",
        ),
        (
            "YoungsModulus",
            "voigt",
            {"YoungsModulus": (1, 0)},
            "YoungsModulus of constituent 2 is 0, .*above 0",
        ),
        ("PoissonRatio", "voigt", {"PoissonRatio": (0.5, 0.1)}, "constituent 1 is 0.5, .*below 0.5"),
        ("PoissonRatio", "voigt", {"PoissonRatio": (0.3, -1)}, "constituent 2 is -1, .*above -1"),
        ("ThermalConductivity", "voigt", {"ThermalConductivity": (-3, 1)}, "constituent 1 is -3"),
        ("Density", "voigt", {"Density": (1, math.inf)}, "constituent 2 is inf"),
        ("Density", "voigt", {"Density": (1, 2, 3)}, "2 constituents, not 3"),
        ("Density", "voigt", {"Density": 4}, "one number for each"),
        ("Density", "voigt", {"Density": ("heavy", 4)}, "one number for each"),
    ],
)
def test_cards_that_do_not_do(name, law, changed, told):
    with pytest.raises(core.InvalidInput, match=told):
        mixed(name, law, TWO, {**cards_of(2), **changed})


def test_what_is_not_wanted_is_not_looked_at():
    cards = {**cards_of(2), "Density": (None, -4)}
    laws = mixing.read_laws({"YoungsModulus": "voigt"})
    assert list(mixing.mixed(TWO, cards, laws, ("YoungsModulus",))) == ["YoungsModulus"]
    with pytest.raises(core.InvalidInput, match="'Colour'"):
        mixing.mixed(TWO, cards, laws, ("Colour",))


@pytest.mark.parametrize(
    "fractions, told",
    [
        ([0.5, 0.5], "shape"),
        ([["a", "b"]], "numbers"),
        ([[0.5, 0.5], [0.7, 0.7]], "place 1 are 0.7, 0.7"),
        ([[1.2, -0.2]], "place 0 are 1.2, -0.2"),
        ([[math.nan, 0.5]], "place 0 are nan"),
    ],
)
def test_fractions_that_are_none(fractions, told):
    with pytest.raises(core.InvalidInput, match=told):
        mixed("Density", "voigt", fractions, cards_of(2))


def test_rounding_of_fractions_does_no_harm():
    rounded = np.array([[1 + 1e-12, -1e-12], [0.3, 0.7 + 1e-12]])
    found = mixed("YoungsModulus", "p1*v1 + p2*sqrt(v2)*sqrt(v2)", rounded, cards_of(2))
    np.testing.assert_allclose(found, [70000, 0.3 * 70000 + 0.7 * 380000], rtol=1e-11)
