# SPDX-License-Identifier: GPL-3.0-or-later
"""Graded analyses, from document to result objects, against solutions in closed form."""
import exact_problems
import numpy as np
import pytest

SIZE = {"patch_test": 0.6, "exponential_bar": 0.5, "graded_strip": 0.6, "thick_cylinder": 0.8}
"""MaxSize, mm. The threshold alone makes elements small where the fraction changes fast. Where both constituents differ
much, the softer one carries the strains, and its elements have to be small, too."""


@pytest.fixture
def solved(document, fgmesh):
    """A function: (result object, its nodes (n, 3), the exact values there) of a problem."""

    def solve(name, mode, bins=100, kind="static", **options):
        bench, exact = getattr(exact_problems, name)(document, fgmesh, **options)
        fgmesh.generate(bench.mesh)
        assert bench.mesh.Status == "ok"
        analysis = fgmesh.make_analysis(bench.mesh, mode=mode, bins=bins)
        analysis.addObjects(bench.constraints)
        (solver,) = (one for one in analysis.Group if hasattr(one, "AnalysisType"))
        solver.AnalysisType = kind
        document.recompute()
        (result,) = fgmesh.solve(analysis)
        nodes = bench.mesh.FemMesh.Nodes
        points = np.array([tuple(nodes[node]) for node in result.NodeNumbers])
        assert len(points) == bench.mesh.PointCount
        return result, points, exact(points)

    return solve


def displacement_error(result, exact):
    """The largest at a node, of the largest displacement; where `exact` is known."""
    known = np.isfinite(exact[:, 0])
    found = np.array([tuple(vector) for vector in result.DisplacementVectors])[known]
    exact = exact[known]
    return np.linalg.norm(found - exact, axis=1).max() / np.linalg.norm(exact, axis=1).max()


@pytest.mark.parametrize(
    "name, mode, second_order, gate",
    [
        ("patch_test", "bins", False, 2e-3),
        ("patch_test", "continuous", True, 5e-5),
        ("exponential_bar", "bins", False, 2e-3),
        ("exponential_bar", "bins", True, 2e-3),
        ("exponential_bar", "continuous", False, 2e-3),
        ("exponential_bar", "continuous", True, 5e-5),
        ("graded_strip", "bins", False, 1e-2),
        ("graded_strip", "continuous", True, 5e-4),
        ("thick_cylinder", "bins", False, 1e-2),
        ("thick_cylinder", "continuous", True, 5e-4),
    ],
)
def test_displacements(name, mode, second_order, gate, solved):
    result, _, exact = solved(name, mode, SecondOrder=second_order, MaxSize=SIZE[name])
    assert displacement_error(result, exact) < gate


def test_conduction(solved):
    """Temperatures, which need a thermomechanical analysis: in bins."""
    result, points, exact = solved("conduction", "bins", kind="thermomech", MaxSize=0.6)
    assert np.array(result.Temperature) == pytest.approx(exact, abs=0.3)
    assert exact[np.abs(points[:, 0] - 5).argmin()] == pytest.approx(73.88, abs=5)
