# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing laws that are formulas of the user's."""
import math

import numpy as np
import pytest

from freecad.fgmesh import core, mixing

from mixtures import CARDS, TWO, cards_of, mixed, random_fractions


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
