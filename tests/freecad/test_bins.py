# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements grouped by their properties."""
import numpy as np
import pytest

RANDOM = np.random.default_rng(5)
RAMP = {"YoungsModulus": np.exp(np.linspace(0, np.log(8), 4001))}


@pytest.fixture
def bins(build_dir):
    from freecad.fgmesh.fem.bins import bins

    return bins


def errors(properties, found):
    return {
        name: np.abs(values - found.values[name][found.numbers]) / np.abs(found.values[name][found.numbers])
        for name, values in properties.items()
    }


@pytest.mark.parametrize("count", [1, 2, 3, 7, 20, 50])
def test_a_ramp_is_cut_into_equal_ratios(count, bins):
    """8 = q^count: an element is at most sqrt(q) off the middle of its bin."""
    found = bins(RAMP, count)
    assert len(found.values["YoungsModulus"]) == count
    assert found.error == pytest.approx(8 ** (0.5 / count) - 1, rel=0.02)
    assert errors(RAMP, found)["YoungsModulus"].max() <= found.error * (1 + 1e-9)


@pytest.mark.parametrize("allowed", [0.3, 0.05, 0.004])
def test_as_many_as_the_allowed_error_needs(allowed, bins):
    properties = {
        "YoungsModulus": np.exp(RANDOM.uniform(0, 2, 5000)),
        "Density": RANDOM.uniform(1, 1.02, 5000),
        "PoissonRatio": np.full(5000, 0.3),
    }
    found = bins(properties, 1, allowed)
    assert all(error.max() <= allowed * (1 + 1e-9) for error in errors(properties, found).values())
    assert found.error <= allowed * (1 + 1e-9)
    needed = 2 / (2 * np.log1p(allowed)) * max(1, np.log(1.02) / (2 * np.log1p(allowed)))
    assert len(found.values["Density"]) <= 3 * needed + 2


def test_an_even_material_is_one_bin(bins):
    found = bins({"YoungsModulus": np.full(9, 70.0), "PoissonRatio": np.zeros(9)}, 20)
    assert (len(found.values["PoissonRatio"]), found.error) == (1, 0)
    assert found.values["YoungsModulus"] == pytest.approx([70])


def test_expansion_may_be_negative_or_zero(bins):
    values = np.linspace(-1e-6, 2e-6, 301)
    found = bins({"ThermalExpansionCoefficient": values}, 3)
    assert found.values["ThermalExpansionCoefficient"] == pytest.approx([-0.5e-6, 0.5e-6, 1.5e-6], abs=2e-8)
    assert found.error == pytest.approx(0.25, rel=0.02)


def test_every_element_has_its_bin_in_order(bins):
    found = bins(RAMP, 10)
    assert (np.diff(found.numbers) >= 0).all()
    assert (np.bincount(found.numbers) > 0).all()


@pytest.mark.parametrize("count", [0, -3, 2001, None])
def test_numbers_of_bins_that_make_no_sense(count, bins, core):
    with pytest.raises(core.InvalidInput, match="from 1 to 2000"):
        bins(RAMP, count)


@pytest.mark.parametrize(
    "allowed, words", [(1.5, "between 0 and 1"), (-0.1, "between 0 and 1"), (1e-5, "more than 2000")]
)
def test_allowed_errors_that_make_no_sense(allowed, words, bins, core):
    properties = {"YoungsModulus": np.exp(RANDOM.uniform(0, 2, 200000))}
    with pytest.raises(core.InvalidInput, match=words):
        bins(properties, 20, allowed)
