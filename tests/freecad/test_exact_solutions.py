# SPDX-License-Identifier: GPL-3.0-or-later
"""Graded analyses, from document to result objects, against solutions in closed form."""
import importlib.util

import exact_problems
import FreeCAD
import numpy as np
import pytest

from freecad.fgmesh import adapter

pytestmark = pytest.mark.usefixtures("ccx")

SIZE = {
    "patch_test": 0.4,
    "exponential_bar": 0.5,
    "graded_strip": 0.6,
    "thick_cylinder": 0.7,
    "conduction": 0.6,
}
"""MaxSize, mm. The threshold alone makes elements small where the fraction changes fast. Where both constituents differ
much, the softer one carries the strains, and its elements have to be small, too."""


@pytest.mark.parametrize(
    "name, threshold, mode, second_order, gate",
    [
        ("patch_test", 0.1, "bins", False, 2e-3),
        ("patch_test", 0.1, "bins", True, 2e-3),
        ("patch_test", 0.1, "continuous", False, 2e-3),
        ("patch_test", 0.1, "continuous", True, 5e-5),
        ("patch_test", 0.05, "bins", False, 2e-3),
        ("exponential_bar", 0.1, "bins", False, 2e-3),
        ("exponential_bar", 0.1, "bins", True, 2e-3),
        ("exponential_bar", 0.1, "continuous", False, 2e-3),
        ("exponential_bar", 0.1, "continuous", True, 5e-5),
        ("exponential_bar", 0.05, "bins", True, 2e-3),
        ("exponential_bar", 0.05, "continuous", True, 5e-5),
        ("graded_strip", 0.1, "bins", False, 1e-2),  # four nodes bend badly
        ("graded_strip", 0.1, "bins", True, 2e-3),
        ("graded_strip", 0.1, "continuous", True, 5e-4),
        ("thick_cylinder", 0.1, "bins", False, 1e-2),
        ("thick_cylinder", 0.1, "bins", True, 4e-3),
        ("thick_cylinder", 0.1, "continuous", False, 1e-2),
        ("thick_cylinder", 0.1, "continuous", True, 5e-4),
        ("thick_cylinder", 0.05, "continuous", False, 1e-2),
        ("conduction", 0.1, "bins", False, 3e-3),
        ("conduction", 0.1, "bins", True, 3e-3),
    ],
)
def test_exact_solutions(name, threshold, mode, second_order, gate, document, fgmesh):
    options = {"MaterialThreshold": threshold, "SecondOrder": second_order, "MaxSize": SIZE[name]}
    bench, exact = getattr(exact_problems, name)(document, fgmesh, **options)
    result, points = exact_problems.solved(bench, fgmesh, mode)
    assert bench.mesh.Status == "ok" and len(points) == bench.mesh.PointCount
    assert exact_problems.largest_error(bench, result, exact(points)) < gate


def test_heat_through_a_graded_bar(document, fgmesh):
    """A flux q through the end, k = k0 exp(beta x/L): the end is q L (1 - exp(-beta)) / (k0 beta) warmer than the
    other."""
    import ObjectsFem

    bench, _ = exact_problems.conduction(document, fgmesh, MaxSize=0.8)
    hot = bench.constraints.pop(1)
    place = hot.References
    document.removeObject(hot.Name)
    flux = ObjectsFem.makeConstraintHeatflux(document)
    flux.References, flux.ConstraintType, flux.DFlux = place, "DFlux", 1e5  # W/m^2
    bench.constraints.append(flux)
    result, points = exact_problems.solved(bench, fgmesh, "bins")
    conductivity = 10.0  # W/(m K), where E is 1000 MPa
    warmer = 1e5 * 0.010 * (1 - 1 / 8) / (conductivity * np.log(8))
    ends = np.array(result.Temperature)[points[:, 0] > 10 - 1e-6]
    assert ends == pytest.approx(warmer, rel=5e-3)


@pytest.mark.parametrize("mode", ["bins", "continuous"])
def test_a_bar_under_its_graded_weight(mode, document, fgmesh):
    """Density proportional to E, weight along x: the end moves by g c L/b ((e^b - 1)/b - 1), E = E0 e^(b x/L),
    rho = c E, nu = 0. Again on another mesh, with the same constraints."""
    import ObjectsFem

    bench, _ = exact_problems.exponential_bar(document, fgmesh, MaxSize=0.7, SecondOrder=True)
    document.removeObject(bench.constraints.pop(0).Name)
    weight = ObjectsFem.makeConstraintSelfWeight(document)
    adapter.set_weight(weight, (1, 0, 0))
    bench.constraints.append(weight)
    b, length, gravity, ratio = np.log(8), 10.0, 9810.0, 1e-12  # mm/s^2; t/mm^3 a MPa
    exact = gravity * ratio * length**2 / b * ((np.exp(b) - 1) / b - 1)
    result, _ = exact_problems.solved(bench, fgmesh, mode)
    analysis = result.getParentGroup()
    assert max(vector.x for vector in result.DisplacementVectors) == pytest.approx(exact, rel=5e-3)
    bench.mesh.MaxSize = 1.2
    fgmesh.generate(bench.mesh)
    document.recompute()
    (again,) = fgmesh.solve(analysis)
    assert len(again.NodeNumbers) == bench.mesh.PointCount
    assert max(vector.x for vector in again.DisplacementVectors) == pytest.approx(exact, rel=1e-2)


def test_the_cylinder_of_the_examples(example):
    """Probed along its radius, displacements and stresses are those of the exact solution, which the macro draws and
    whose ends are known from elsewhere."""
    macro, home = example("graded_cylinder")
    ends = ((0.727002441, 0.398463817), (37.03324, 175.1489))
    for (r, values, exact), known, allowed in zip(macro.main().values(), ends, (5e-4, 5e-3)):
        assert len(r) > 50 and r[[0, -1]] == pytest.approx([10, 20], abs=1e-3)
        assert exact[[0, -1]] == pytest.approx(known, rel=1e-4)
        assert np.abs(values - exact).max() < allowed * np.abs(exact).max()
    FreeCAD.closeDocument("GradedCylinder")
    assert (home / "graded_cylinder.svg").stat().st_size > 10000


@pytest.fixture
def example(source_dir, document, tmp_path, monkeypatch):
    """A function: (module, home folder) of one of the examples, not run yet."""
    monkeypatch.setenv("HOME", str(tmp_path))

    def load(name):
        spec = importlib.util.spec_from_file_location(
            f"examples.{name}", source_dir / "examples" / f"{name}.py"
        )
        macro = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(macro)
        return macro, tmp_path

    return load


def test_the_beam_of_the_examples(example, document):
    """All four kinds of analysis against the theory of slender beams, with moduli as FreeCAD's cards have them."""
    from freecad.fgmesh.model import constituents

    macro, _ = example("graded_beam")
    deflection, frequencies, factor, bent = macro.main()
    FreeCAD.closeDocument("GradedBeam")

    steel, aluminium = zip(*constituents.values(["Steel-Generic", "Aluminum-Generic"], document).values())
    z = np.linspace(0, macro.HEIGHT, 2001)
    cards = dict(zip(constituents.UNITS, zip(steel, aluminium)))

    def graded(name):
        below, above = cards[name]
        return below + (above - below) * z / macro.HEIGHT

    def over_section(values):
        return ((values[1:] + values[:-1]) / 2 * np.diff(z)).sum() * macro.WIDTH

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
