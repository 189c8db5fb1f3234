# SPDX-License-Identifier: GPL-3.0-or-later
"""What is expected of a mesh, before it is made: compared with the meshes themselves."""
import threading
import time

import numpy as np
import pytest

from freecad.fgmesh import core, worker

WITHIN = 0.3
"""What the expected number of tetrahedra may be off."""


def shape(name):
    import FreeCAD  # noqa: F401  must come before Part
    import Part
    from FreeCAD import Vector

    return {
        "box": lambda: Part.makeBox(10, 10, 10),
        "ball": lambda: Part.makeSphere(50),
        "cylinder": lambda: Part.makeCylinder(20, 60),
        "lens": lambda: Part.makeSphere(20).common(Part.makeSphere(20, Vector(25, 0, 0))),
        "two": lambda: Part.makeCompound(
            [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(10, 0, 0))]
        ),
        "bored": lambda: Part.makeBox(60, 40, 30).cut(Part.makeCylinder(8, 30, Vector(40, 20, 0))),
    }[name]().exportBrepToString()


CASES = [
    ("box", ["0.05 + 0.09*x"], {"material_threshold": 0.1}),
    ("box", ["0.05 + 0.09*x"], {"material_threshold": 0.1, "stop_after": "initial"}),
    ("box", ["sqrt(d/18)"], {"material_threshold": 0.05}),
    ("box", ["x < 5 ? 0.2 : 0.8"], {}),
    ("ball", ["exp(-0.08*d)"], {}),
    ("ball", ["exp(-0.08*d)"], {"stop_after": "material"}),
    ("cylinder", ["(z/60)^3"], {"material_threshold": 0.2}),
    ("cylinder", ["(z/60)^3"], {"surface_deviation": 0.4}),
    ("cylinder", ["0.5"], {"max_size": 4}),
    ("cylinder", ["0.5"], {"max_size": 2.2, "surface_deviation": 0.2, "stop_after": "initial"}),
    ("lens", ["0.5"], {}),
    ("two", ["x/20"], {"material_threshold": 0.1}),
    ("two", ["0.5", "exp((x-20)/4)"], {"material_threshold": 0.1}),
    ("bored", ["x/60"], {"material_threshold": 0.1, "surface_deviation": 0.2}),
]


def materials(formulas):
    made = [core.Material([formula]) for formula in formulas]
    return made if len(made) > 1 else made[0]


@pytest.mark.parametrize(("name", "formulas", "asked"), CASES)
def test_expected_and_true_numbers(name, formulas, asked):
    brep, options = shape(name), core.MeshingOptions(**asked)
    true = worker.generate_mesh(brep, materials(formulas), options)
    expected = core.estimate(brep, materials(formulas), options)
    assert expected.tets == pytest.approx(len(true.tets), rel=WITHIN)
    assert expected.memory_mb == pytest.approx(true.peak_memory_mb, rel=WITHIN)


def test_many_tetrahedra_follow_the_integral():
    """N threshold^3 / integral |grad f|^3 is a constant of the method: 7 where f is linear and meshes are fine."""
    brep, ramp = shape("box"), core.Material(["x/10"])
    for threshold in (0.02, 0.01, 0.005):
        options = core.MeshingOptions(material_threshold=threshold, stop_after="material")
        ratio = core.estimate(brep, ramp, options).tets * threshold**3
        assert ratio == pytest.approx(7, rel=0.1)


@pytest.mark.parametrize(
    "formula", ["x/10", "exp(-d)", "0.5 + 0.5*tanh((x + y - 10)/0.2)", "0.5 + 0.4*sin(3*x)", "(x/10)^0.2"]
)
@pytest.mark.parametrize("stop_after", ["material", "geometry"])
def test_a_lower_threshold_needs_more(formula, stop_after):
    brep, material = shape("box"), core.Material([formula])
    counts = [
        core.estimate(brep, material, core.MeshingOptions(material_threshold=t, stop_after=stop_after)).tets
        for t in (1, 0.5, 0.2, 0.1, 0.05, 0.02)
    ]
    assert counts == sorted(counts)
    assert counts[-1] > counts[0]


def test_less_deviation_and_smaller_elements_need_more():
    brep, even = shape("cylinder"), core.Material(["0.5"])

    def expected(**asked):
        return core.estimate(brep, even, core.MeshingOptions(**asked)).tets

    by_deviation = [expected(surface_deviation=deviation) for deviation in (1, 0.3, 0.1, 0.03, 0.01)]
    assert by_deviation == sorted(by_deviation) and by_deviation[-1] > 3 * by_deviation[0]
    by_size = [expected(max_size=size, surface_deviation=1) for size in (8, 4, 2, 1, 0.5)]
    assert by_size == sorted(by_size)
    assert by_size[-1] == pytest.approx(8 * by_size[-2], rel=0.2)


def test_steep_layers_are_found():
    """A layer in x, far thinner than the initial elements, varies like a ramp over its width: many times the
    elements of the solid without it."""
    brep, options = shape("box"), core.MeshingOptions(stop_after="material")
    bare = core.estimate(brep, core.Material(["0.5"]), options).tets
    counts = [
        core.estimate(brep, core.Material([f"clamp((x - 4.93)/{width}, 0, 1)"]), options).tets
        for width in (0.8, 0.4, 0.2)
    ]
    # Between parallel planes the integral of |grad f|^3 is the area over the squared width.
    for count, width in zip(counts, (0.8, 0.4, 0.2)):
        assert count == pytest.approx(bare + 6.8e3 * 100 / width**2, rel=0.25)


@pytest.mark.parametrize(
    "formula",
    [
        "x < 3.3 ? 0 : 1",
        "step(5, x)",
        "sqrt(d/20)",
        "(d/20)^0.01",
        "sqrt(abs(x - 5)/5)",
        "0.5 + 0.5*sin(1000*x)*cos(999*y)",
        "0.5 + 0.5*tanh(1e6*(x - 5))",
        "0.5 + 0.1*sin(1/(x + 1e-9))",
        "floor(7*x)/70",
    ],
)
def test_wild_functions_end_with_a_number(formula):
    expected = core.estimate(shape("box"), core.Material([formula]), core.MeshingOptions())
    assert 100 < expected.tets < 1e12 and np.isfinite(expected.memory_mb)


def test_a_jump_costs_nothing():
    """No element is below the threshold across a jump however small it is, so none is spent on it."""
    brep = shape("box")
    even, jump = (core.estimate(brep, core.Material([f])).tets for f in ("0.5", "x < 5 ? 0.2 : 0.8"))
    assert jump == pytest.approx(even, rel=0.01)


def test_references_are_read():
    brep = shape("box")
    near = core.Material(["d1/10"], references=core.references(brep, ["Face1"], read=False))
    ramp = core.Material(["x/10"])
    options = core.MeshingOptions(material_threshold=0.05)
    expected = core.estimate(brep, ramp, options).tets
    assert core.estimate(brep, near, options).tets == pytest.approx(expected, rel=0.05)
    assert worker.estimate(brep, near, options).tets == pytest.approx(expected, rel=0.05)


def test_a_child_process_estimates_the_same():
    brep, material = shape("ball"), core.Material(["exp(-0.08*d)"])
    here, control = core.estimate(brep, material), core.RunControl()
    with worker.start_estimate(brep, material, core.MeshingOptions(), control) as run:
        assert run.wait(60)
        there = run.result()
    assert (there.tets, there.memory_mb) == (here.tets, here.memory_mb)
    assert control.progress().stage == "estimate"


def test_refusals(shapes):
    ramp = core.Material(["x/10"])
    box = shapes / "box.brep"
    for estimate in (core.estimate, worker.estimate):
        with pytest.raises(core.InvalidInput, match="material_threshold"):
            estimate(box, ramp, core.MeshingOptions(material_threshold=0))
        with pytest.raises(core.InvalidInput, match=r"outside \[0, 1\]"):
            estimate(box, core.Material(["x"]))
        with pytest.raises(core.InvalidInput, match="2 materials for 1 solid"):
            estimate(box, [ramp, ramp])
        with pytest.raises(core.GeometryError, match="open"):
            estimate(shapes / "open.brep", ramp)


def test_cancel():
    control = core.RunControl()
    control.cancel()
    with pytest.raises(core.Cancelled):
        core.estimate(shape("box"), core.Material(["x/10"]), control=control)


def test_other_threads_go_on():
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    options = core.MeshingOptions(material_threshold=0.01)
    core.estimate(shape("ball"), core.Material(["exp(-0.08*d)"]), options)
    done.set()
    thread.join()
    assert np.diff(ticks).max() < 0.3 * (ticks[-1] - ticks[0])
