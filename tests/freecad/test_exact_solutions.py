# SPDX-License-Identifier: GPL-3.0-or-later
"""Graded analyses, from document to result objects, against solutions in closed form."""
import importlib.util

import exact_problems
import FreeCAD
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
    result, _, exact = solved("conduction", "bins", kind="thermomech", MaxSize=0.6)
    assert np.array(result.Temperature) == pytest.approx(exact, abs=0.3)


def test_the_beam_of_the_examples(source_dir, document, fgmesh, tmp_path, monkeypatch):
    """All four kinds of analysis against the theory of slender beams, with moduli as FreeCAD's cards have them."""
    from freecad.fgmesh.model import constituents

    monkeypatch.setenv("HOME", str(tmp_path))
    spec = importlib.util.spec_from_file_location(
        "examples.graded_beam", source_dir / "examples" / "graded_beam.py"
    )
    macro = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(macro)
    deflection, frequencies, factor, bent = macro.main()
    FreeCAD.closeDocument("GradedBeam")

    steel, aluminium = zip(*constituents.values(["Steel-Generic", "Aluminum-Generic"], document).values())
    z = np.linspace(0, macro.HEIGHT, 2001)
    cards = dict(zip(constituents.UNITS, zip(steel, aluminium)))

    def graded(name):
        below, above = cards[name]
        return below + (above - below) * z / macro.HEIGHT

    def over_section(values):
        return np.trapz(values, z) * macro.WIDTH

    modulus, length = graded("YoungsModulus"), macro.LENGTH
    i0, i1, i2 = (over_section(modulus * z**n) for n in range(3))
    stiffness = i2 - i1**2 / i0
    assert deflection == pytest.approx(-macro.LOAD * length**3 / (3 * stiffness), rel=0.02)
    first = 1.8751**2 / (2 * np.pi) * np.sqrt(stiffness / over_section(graded("Density")) / length**4)
    assert frequencies[0] == pytest.approx(first, rel=0.02)
    assert factor * macro.WIDTH * macro.HEIGHT == pytest.approx(
        np.pi**2 * stiffness / (4 * length**2), rel=0.02
    )
    free = modulus * graded("ThermalExpansionCoefficient") * macro.WARMER
    curvature = (over_section(free * z) * i0 - over_section(free) * i1) / (i0 * i2 - i1**2)
    assert bent == pytest.approx(-curvature * length**2 / 2, rel=0.03)
