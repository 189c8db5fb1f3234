# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for every mixing law, and the means, against closed forms."""
import itertools

import numpy as np
import pytest

from freecad.fgmesh import mixing

from mixtures import (
    CARDS,
    ELASTIC,
    LAW_OF_EACH,
    TWO,
    cards_of,
    mixed,
    mixed_moduli,
    random_fractions,
    random_moduli,
)


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
