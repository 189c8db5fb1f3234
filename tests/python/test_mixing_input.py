# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that become mixing laws, and the cards and fractions that they work on: what is taken, what is refused."""
import math

import numpy as np
import pytest

from freecad.fgmesh import core, mixing

from mixtures import SPHERES, TWO, cards_of, mixed, random_fractions


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
