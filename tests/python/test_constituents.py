# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of more than two constituents."""
import json
from itertools import combinations

import meshio
import numpy as np
import pytest

from freecad.fgmesh import core, worker

FORMULAS = ["0.5*x/10", "0.3*exp(-y/8)"]


def fractions_at(points):
    """(n, 3), written anew."""
    first, second = 0.05 * points[:, 0], 0.3 * np.exp(-points[:, 1] / 8)
    return np.column_stack([first, second, 1 - first - second])


def variation(points, tets):
    """The largest distance of two corners' vectors of all fractions: the paper's equations 2.2 and 2.3."""
    whole = fractions_at(points)[tets[:, :4]]
    pairs = combinations(range(4), 2)
    return np.max([np.linalg.norm(whole[:, i] - whole[:, j], axis=1) for i, j in pairs], axis=0)


@pytest.mark.parametrize("order", [1, 2])
def test_the_whole_composition_keeps_the_threshold(shapes, order):
    options = core.MeshingOptions(material_threshold=0.1, order=order)
    result = core.generate_mesh(shapes / "box.brep", core.Material(FORMULAS), options)
    assert result.status == "ok"
    assert result.fractions.shape == (len(result.points), 3)
    np.testing.assert_allclose(result.fractions, fractions_at(result.points), atol=1e-12)
    np.testing.assert_allclose(result.fractions.sum(axis=1), 1, atol=1e-15)
    np.testing.assert_allclose(result.variation, variation(result.points, result.tets), atol=1e-12)
    assert 0.09 < result.variation.max() <= 0.1


def test_a_constituent_that_is_nowhere_counts_as_the_paper_has_it(shapes):
    """(f, 0, 1 - f) changes by the square root of two times the change of f."""
    half = core.MeshingOptions(material_threshold=0.1 * np.sqrt(2))
    with_it = core.generate_mesh(shapes / "box.brep", core.Material(["x/10", "0"]), half)
    without = core.generate_mesh(shapes / "box.brep", core.Material(["x/10"]))
    assert np.ptp(with_it.fractions[with_it.tets, 0], axis=1).max() <= 0.1
    assert len(with_it.tets) == pytest.approx(len(without.tets), rel=0.1)
    assert with_it.element_ratio == pytest.approx(without.element_ratio, rel=0.1)


def test_the_child_process_gives_the_same(shapes):
    material = core.Material(FORMULAS)
    here, there = (run(shapes / "box.brep", material) for run in (core.generate_mesh, worker.generate_mesh))
    for name in ("points", "tets", "fractions", "variation"):
        assert np.array_equal(getattr(here, name), getattr(there, name)), name


def test_the_estimate_is_near(shapes):
    options = core.MeshingOptions(material_threshold=0.05)
    expected = core.estimate(shapes / "box.brep", core.Material(FORMULAS), options).tets
    result = core.generate_mesh(shapes / "box.brep", core.Material(FORMULAS), options)
    assert expected == pytest.approx(len(result.tets), rel=0.4)


def test_solids_may_have_different_numbers_of_constituents():
    import FreeCAD  # must come before Part
    import Part

    boxes = [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(10, 0, 0))]
    two, three = core.Material(["z/10"]), core.Material(["0.1", "0.2 + x/100"])
    result = core.generate_mesh(Part.makeCompound(boxes).exportBrepToString(), [two, three])
    assert result.fractions.shape[1] == 3 and result.tet_fractions.shape[1:] == (4, 3)
    z, x = (result.points[result.tets][..., axis] for axis in (2, 0))
    first = result.tet_solids == 1
    assert first.any() and not first.all()
    np.testing.assert_allclose(result.tet_fractions[first, :, 0], z[first] / 10, atol=1e-12)
    assert (result.tet_fractions[first, :, 2] == 0).all()
    np.testing.assert_allclose(result.tet_fractions[~first, :, 1], 0.2 + x[~first] / 100, atol=1e-12)
    np.testing.assert_allclose(result.tet_fractions.sum(axis=2), 1, atol=1e-15)


def test_on_the_command_line(fgmesh, shapes, tmp_path):
    done = fgmesh(
        shapes / "box.brep",
        *(word for formula in FORMULAS for word in ("--fraction", formula)),
        *("-o", "out.vtu", "--report", "out.json"),
    )
    assert done.returncode == 0, done.stderr
    data = meshio.read(tmp_path / "out.vtu")
    written = np.column_stack([data.point_data[f"fraction_{number}"] for number in (1, 2, 3)])
    np.testing.assert_allclose(written, fractions_at(data.points), atol=1e-12)
    figures = json.loads((tmp_path / "out.json").read_text())["stages"][-1]["variation"]
    (tets,) = (block.data for block in data.cells if block.type == "tetra")
    assert figures["max"] == pytest.approx(variation(data.points, tets).max(), abs=1e-12)


def test_the_wrong_formula_is_told_and_shown():
    with pytest.raises(core.FormulaError, match="formula 2: .*'w'") as caught:
        core.Material(["x", "y + w"])
    assert (caught.value.formula, caught.value.position) == (1, 4)


def test_a_constituent_below_zero_is_told(shapes):
    with pytest.raises(core.InvalidInput, match="volume fraction of constituent 2 is -.*outside"):
        core.generate_mesh(shapes / "box.brep", core.Material(["0.1", "-x"]))
