# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole mesher through freecad.fgmesh.core: every figure it reports is computed again from the arrays,
shapes are FreeCAD's, surfaces known in closed form. Lengths in mm, angles in degrees."""
import functools
import itertools
import math
import threading
import time

import numpy as np
import pytest

from freecad.fgmesh import core

EDGES = list(itertools.combinations(range(4), 2))
SIDES = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]

ON_SURFACE = 1e-7
"""FreeCAD finds the nodes of a face that are this close to it."""

LARGEST_DELAY = 2.0
"""Of the end of a run after cancel(), seconds: what users are promised."""


CASES = {
    "box": ("box", "y/20", {"material_threshold": 0.2}),
    "ball": ("ball", "exp(-0.1*d)", {"material_threshold": 0.1, "surface_deviation": 0.05}),
    "cylinder": ("cylinder", "(z/12)^2", {"material_threshold": 0.2, "surface_deviation": 0.02}),
    "drilled": ("drilled", "0.5 + 0.5*tanh((x-8)/5)", {"material_threshold": 0.2}),
    "jump": ("box", "step(7.5, y)", {"material_threshold": 0.2}),
}


@pytest.fixture(params=CASES)
def case(request, meshed):
    name, formula, options = CASES[request.param]
    return name, formula, meshed(name, formula, **options)


def corners(result):
    """Positions (m, 4, 3) of the corners of the tetrahedra."""
    return result.points[result.tets]


def volumes(result):
    p = corners(result)
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def dihedral_angles(result):
    """All six angles (m, 6): at each edge the angle between what is left of the other two corners when the
    direction of the edge is taken out."""
    p = corners(result)
    angles = []
    for i, j in EDGES:
        k, l = (v for v in range(4) if v not in (i, j))
        along = p[:, j] - p[:, i]
        along /= np.linalg.norm(along, axis=1)[:, None]
        across = []
        for v in (k, l):
            way = p[:, v] - p[:, i]
            way -= (way * along).sum(axis=1)[:, None] * along
            across.append(way / np.linalg.norm(way, axis=1)[:, None])
        angles.append(np.degrees(np.arccos(np.clip((across[0] * across[1]).sum(axis=1), -1, 1))))
    return np.stack(angles, axis=1)


def boundary_faces(result):
    """Faces (b, 3) that one tetrahedron alone has, outward."""
    sides = result.tets[:, SIDES].reshape(-1, 3)
    _, first, counts = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    assert counts.max() <= 2
    return sides[first[counts == 1]]


def rotated(triangles):
    """Each triangle from its lowest vertex on: equal rows mean the same triangle looking the same way."""
    start = np.argmin(triangles, axis=1)
    return np.take_along_axis(triangles, (start[:, None] + np.arange(3)) % 3, axis=1)


def test_arrays_fit_together(case):
    _, _, result = case
    n, m, t = len(result.points), len(result.tets), len(result.triangles)
    assert result.carriers.shape == (n, 2) and result.fractions.shape == (n, 2)
    assert result.tet_solids.shape == result.variation.shape == result.dihedral_min.shape == (m,)
    assert result.triangle_faces.shape == (t,) and len(result.edges) == len(result.edge_edges)
    assert np.array_equal(np.unique(result.tets), np.arange(n)), "a stray point, or one that is not there"
    assert (result.tet_solids == 1).all()
    assert len(np.unique(result.points, axis=0)) == n
    assert (volumes(result) > 0).all()


def test_boundary_is_closed_labelled_and_outward(case):
    _, _, result = case
    expected, found = rotated(boundary_faces(result)), rotated(result.triangles)
    order = np.lexsort(expected.T), np.lexsort(found.T)
    assert np.array_equal(expected[order[0]], found[order[1]])
    halves = np.vstack([found[:, [0, 1]], found[:, [1, 2]], found[:, [2, 0]]])
    assert len(np.unique(halves, axis=0)) == len(halves)
    assert {*map(tuple, halves)} == {*map(tuple, halves[:, ::-1])}
    p = result.points[found]
    enclosed = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6
    assert enclosed == pytest.approx(volumes(result).sum(), rel=1e-9)
    assert {*map(tuple, np.sort(result.edges, axis=1))} <= {*map(tuple, np.sort(halves, axis=1))}


def test_material_figures_are_those_of_the_arrays(case):
    _, formula, result = case
    fractions = core.Material([formula]).evaluate(result.points)
    np.testing.assert_allclose(result.fractions, np.clip(fractions, 0, 1), atol=1e-14)
    variation = np.ptp(result.fractions[result.tets, 0], axis=1)
    np.testing.assert_array_equal(result.variation, variation)
    above = np.flatnonzero(variation > result.material_threshold)
    np.testing.assert_array_equal(result.above_threshold, above)
    if len(above):
        assert result.status == "threshold_not_met"
    else:
        assert result.status == (
            "deviation_not_met" if result.deviation_max > result.surface_deviation else "ok"
        )
    stage = result.stages[-1]
    assert stage.above_threshold == len(above)
    assert stage.variation_min == variation.min() and stage.variation_max == variation.max()
    assert stage.variation_mean == pytest.approx(variation.mean(), rel=1e-12)
    histogram = stage.variation_histogram
    clipped = np.minimum(variation, histogram.high)
    expected, edges = np.histogram(clipped, len(histogram.counts), (histogram.low, histogram.high))
    # Values at an edge of two bins may fall on either side by rounding.
    shy = np.abs(clipped[:, None] - edges).min(axis=1) < 1e-12
    assert np.abs(np.array(histogram.counts) - expected).sum() <= 2 * shy.sum()
    assert sum(histogram.counts) == len(variation)


def test_angles_are_those_of_the_arrays(case):
    _, _, result = case
    angles, stage = dihedral_angles(result), result.stages[-1]
    np.testing.assert_allclose(result.dihedral_min, angles.min(axis=1), atol=1e-8)
    assert stage.dihedral_min == pytest.approx(angles.min(), abs=1e-8)
    assert stage.dihedral_max == pytest.approx(angles.max(), abs=1e-8)
    histogram = stage.dihedral_histogram
    expected, edges = np.histogram(angles, len(histogram.counts), (histogram.low, histogram.high))
    shy = (np.abs(angles.ravel()[:, None] - edges).min(axis=1) < 1e-8).sum()
    assert np.abs(np.array(histogram.counts) - expected).sum() <= 2 * shy
    assert sum(histogram.counts) == angles.size
    assert angles.min() >= 10 and angles.max() <= 164


def test_report_tells_the_same(case):
    _, formula, result = case
    report = core.report(result)
    assert [stage["name"] for stage in report["stages"]] == ["initial", "material", "geometry"]
    last = report["stages"][-1]
    assert (last["points"], last["facets"], last["tets"]) == (
        len(result.points),
        len(result.triangles),
        len(result.tets),
    )
    assert report["volume"] == pytest.approx(volumes(result).sum(), rel=1e-12)
    assert report["threshold"] == result.material_threshold
    gradient = core.Material([formula]).gradients(corners(result).mean(axis=1))[:, 0]
    integral = (np.linalg.norm(gradient, axis=1) ** 3 * volumes(result)).sum()
    expected = len(result.tets) * result.material_threshold**3 / integral if integral else 0.0
    assert report["element_ratio"] == pytest.approx(expected, rel=1e-9)
    assert sum(stage["seconds"] for stage in report["stages"]) > 0
    if result.status != "ok":
        assert str(len(result.above_threshold)) in report["messages"][-1]


def test_element_ratio_is_that_of_the_integral_over_the_true_ball(meshed):
    name, formula, options = CASES["ball"]
    result = meshed(name, formula, **{**options, "stop_after": "material"})
    d = (np.arange(100_000) + 0.5) * 10 / 100_000
    integral = (4 * math.pi * d**2 * (0.1 * np.exp(-0.1 * d)) ** 3).sum() * 10 / 100_000
    # The mesh lacks what lies between its chords and the ball.
    assert result.element_ratio == pytest.approx(len(result.tets) * 1e-3 / integral, rel=0.03)
    assert 3 < result.element_ratio <= 16


def test_boundary_points_are_on_the_true_ball_and_cylinder(meshed):
    ball = meshed(*CASES["ball"][:2], **CASES["ball"][2])
    on_boundary = np.unique(ball.triangles)
    off = np.abs(np.linalg.norm(ball.points[on_boundary], axis=1) - 10)
    assert off.max() < ON_SURFACE
    cylinder = meshed(*CASES["cylinder"][:2], **CASES["cylinder"][2])
    x, y, z = cylinder.points[np.unique(cylinder.triangles)].T
    side, ends = np.abs(np.hypot(x, y) - 8), np.minimum(np.abs(z), np.abs(z - 12))
    assert np.minimum(side, ends).max() < ON_SURFACE
    rims = cylinder.points[np.unique(cylinder.edges)]
    on_rim = np.abs(np.hypot(rims[:, 0], rims[:, 1]) - 8) < ON_SURFACE
    # The seam, too, is an edge of the B-Rep; mesh edges need not follow it.
    assert on_rim.all()


def test_points_lie_on_the_entities_that_carry_them(case, brep):
    import FreeCAD  # noqa: F401
    import Part

    name, _, result = case
    shape = Part.Shape()
    shape.importBrepFromString(brep(name).decode())
    kinds = {0: shape.Vertexes, 1: shape.Edges, 2: shape.Faces}
    chosen = np.random.default_rng(5).permutation(np.flatnonzero(result.carriers[:, 1:].ravel() > 0))
    asked = [i for i in chosen if result.carriers[i, 0] < 3][:150]
    assert len(asked) > 20
    for i in asked:
        dimension, number = result.carriers[i]
        entity = kinds[dimension][number - 1]
        distance = entity.distToShape(Part.Vertex(*map(float, result.points[i])))[0]
        assert (
            distance < ON_SURFACE
        ), f"point {i} is {distance} mm off entity {number} of dimension {dimension}"


def test_triangles_lie_on_the_faces_they_name(case, brep):
    import FreeCAD  # noqa: F401
    import Part

    name, _, result = case
    shape = Part.Shape()
    shape.importBrepFromString(brep(name).decode())
    assert set(result.triangle_faces) == set(range(1, len(shape.Faces) + 1))
    chosen = np.random.default_rng(6).permutation(len(result.triangles))[:100]
    centres = result.points[result.triangles[chosen]].mean(axis=1)
    for centre, face in zip(centres, result.triangle_faces[chosen]):
        distance = shape.Faces[face - 1].distToShape(Part.Vertex(*map(float, centre)))[0]
        assert distance <= result.deviation_max + ON_SURFACE
    assert result.deviation_max <= result.surface_deviation


def test_volume_converges_with_the_deviation(meshed):
    exact = 4 / 3 * math.pi * 1000
    errors = []
    for deviation in (0.1, 0.025, 0.00625):
        result = meshed("ball", "0.5 + x/40", material_threshold=0.5, surface_deviation=deviation)
        assert result.shape_volume == pytest.approx(exact, rel=1e-6)
        errors.append(exact - volumes(result).sum())
        # Chords of a ball lie inside it; facets whose centres are within the deviation lose less than that.
        assert 0 < errors[-1] < 4 * math.pi * 100 * deviation
    assert errors[1] < 0.3 * errors[0] and errors[2] < 0.3 * errors[1]


@pytest.fixture(scope="module")
def drilled_plate():
    """Mesh a plate with a hole and its formula, both scaled."""
    import FreeCAD
    import Part

    def run(scale, threshold=0.05):
        part = Part.makeBox(20 * scale, 12 * scale, 8 * scale)
        part = part.cut(Part.makeCylinder(3 * scale, 8 * scale, FreeCAD.Vector(8, 6, 0) * scale))
        material = core.Material(["exp(-0.1*d/s)"], parameters={"s": scale})
        options = core.MeshingOptions(material_threshold=threshold)
        return core.generate_mesh(part.exportBrepToString().encode(), material, options)

    return functools.lru_cache(run)


@pytest.mark.parametrize("scale", [1 / 4, 1024])
def test_the_same_part_in_another_size_gets_the_same_tetrahedra(drilled_plate, scale):
    # Powers of two, so that rounding is the same too. In much smaller parts tolerances of the shape tell.
    one, other = drilled_plate(1), drilled_plate(scale)
    assert np.array_equal(one.tets, other.tets)
    assert np.array_equal(one.points * scale, other.points)
    assert np.array_equal(one.fractions, other.fractions)


@pytest.mark.parametrize("scale", [0.001, 1000])
def test_figures_do_not_depend_on_the_size_of_the_part(drilled_plate, scale):
    one, other = drilled_plate(1), drilled_plate(scale)
    assert other.status == one.status == "ok"
    # Rounding tips decisions, so the meshes are not the same to the last tetrahedron.
    assert len(other.tets) == pytest.approx(len(one.tets), rel=0.1)
    assert other.element_ratio == pytest.approx(one.element_ratio, rel=0.1)
    assert other.volume == pytest.approx(one.volume * scale**3, rel=1e-3)
    assert other.surface_deviation == pytest.approx(one.surface_deviation * scale, rel=1e-6)


@pytest.mark.parametrize("threshold", [0.1, 0.07, 0.05])
def test_deviation_is_kept_at_the_wall_of_a_hole(drilled_plate, threshold):
    # A hollow wall: new vertices move into the solid, where coarse tetrahedra are in the way.
    result = drilled_plate(1, threshold)
    wall = np.hypot(*(result.points - [8, 6, 0])[:, :2].T) < 3 + ON_SURFACE
    facets = result.triangles[wall[result.triangles].all(axis=1)]
    centres = result.points[facets].mean(axis=1)
    off = 3 - np.hypot(centres[:, 0] - 8, centres[:, 1] - 6)
    assert len(facets) > 50
    assert off.max() <= result.surface_deviation, f"{(off > result.surface_deviation).sum()} facets"
    assert result.deviation_max <= result.surface_deviation


def test_a_deviation_that_cannot_be_kept_is_told(meshed):
    result = meshed("cylinder", "z/12", material_threshold=0.5, surface_deviation=0.002, min_size=3.0)
    assert result.deviation_max > result.surface_deviation == 0.002
    assert result.status == "deviation_not_met"
    assert any("MinSize, now 3 mm" in message for message in result.messages)


def test_two_runs_give_the_same_bytes(brep):
    def run():
        options = core.MeshingOptions(material_threshold=0.2)
        return core.generate_mesh(brep("drilled"), core.Material(["0.5 + 0.5*tanh((x-8)/5)"]), options)

    first, second = run(), run()
    for name in ("points", "carriers", "tets", "triangles", "triangle_faces", "edges", "fractions"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes(), name


def test_jump_leaves_exactly_the_tetrahedra_across_it_above(meshed):
    result = meshed(*CASES["jump"][:2], **CASES["jump"][2])
    y = result.points[result.tets][:, :, 1]
    crossing = np.flatnonzero((y.min(axis=1) < 7.5) & (y.max(axis=1) >= 7.5))
    assert result.status == "threshold_not_met"
    np.testing.assert_array_equal(result.above_threshold, crossing)


ENDLESS = {
    "initial": ("ball", "0.5", {"max_size": 0.05}),
    "material": ("box", "y/20", {"material_threshold": 0.002}),
    "geometry": (
        "ball",
        "x/40 + 0.5",
        {"material_threshold": 0.5, "surface_deviation": 2e-6, "min_size": 1e-6},
    ),
}
"""By stage: a run in which it lasts far longer than the test."""


@pytest.mark.parametrize("stage", ENDLESS)
@pytest.mark.parametrize("wait", [0, 1])
def test_cancel_ends_a_run_soon(brep, stage, wait):
    name, formula, options = ENDLESS[stage]
    control, caught = core.RunControl(), []

    def run():
        try:
            core.generate_mesh(brep(name), core.Material([formula]), core.MeshingOptions(**options), control)
        except core.Error as error:
            caught.append(error)

    worker = threading.Thread(target=run)
    worker.start()
    end = time.monotonic() + 30
    while control.progress().stage != stage and time.monotonic() < end and worker.is_alive():
        time.sleep(0.002)
    assert control.progress().stage == stage
    time.sleep(wait)
    begin = time.monotonic()
    control.cancel()
    worker.join(30)
    assert time.monotonic() - begin < LARGEST_DELAY
    assert isinstance(caught[0], core.Cancelled) and stage in str(caught[0])


def test_progress_goes_forward(brep):
    control, seen = core.RunControl(), []
    worker = threading.Thread(
        target=core.generate_mesh,
        args=(brep("ball"), core.Material(["exp(-0.1*d)"]), core.MeshingOptions(), control),
    )
    worker.start()
    while worker.is_alive():
        progress = control.progress()
        seen.append((progress.stage, progress.fraction))
        time.sleep(0.005)
    order = ["", "reading", "initial", "material", "geometry", "certificate"]
    places = [order.index(stage) for stage, _ in seen]
    assert places == sorted(places) and order.index("material") in places
    for stage in order[1:]:
        fractions = [fraction for name, fraction in seen if name == stage]
        # Stage and fraction are read one after the other: the first may still be the last stage's.
        assert fractions[1:] == sorted(fractions[1:]), stage
        assert all(0 <= fraction <= 1 for fraction in fractions)
