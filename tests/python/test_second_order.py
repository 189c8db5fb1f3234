# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten-node tetrahedra of the whole mesher, measured by shape functions of our own. Lengths in mm."""
import functools
import math

import numpy as np
import pytest

from freecad.fgmesh import core, io

ON_SURFACE = 1e-7
"""FreeCAD finds the nodes of a face that are this close to it."""

MIDDLE_EDGES = np.array([(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)])


@functools.lru_cache(None)
def shape(name):
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    return {
        "ball": lambda: Part.makeSphere(10),
        "cylinder": lambda: Part.makeCylinder(8, 12),
        "drilled": lambda: Part.makeBox(20, 20, 8).cut(Part.makeCylinder(5, 8, FreeCAD.Vector(8, 10, 0))),
        "tube": lambda: Part.makeCylinder(10, 6).cut(Part.makeCylinder(9.5, 6)),
        # Thin beside its facets: many tetrahedra have two of them on the same smooth face.
        "torus": lambda: Part.makeTorus(10, 2),
        "lens": lambda: Part.makeSphere(20, FreeCAD.Vector(0, 0, -19)).common(
            Part.makeSphere(20, FreeCAD.Vector(0, 0, 19))
        ),
    }[name]()


@functools.lru_cache(None)
def meshed(name, formula="0.5 + x/50", **options):
    brep = shape(name).exportBrepToString().encode()
    settings = {"material_threshold": 0.3, "order": 2, **options}
    return core.generate_mesh(brep, core.Material([formula]), core.MeshingOptions(**settings))


COARSE = {"surface_deviation": 1.0, "max_size": 20.0}
CASES = {
    "ball": {"surface_deviation": 0.2},
    "cylinder": {"surface_deviation": 0.2},
    "drilled": {"stop_after": "initial", **COARSE},
    "tube": {"surface_deviation": 0.1, "max_size": 20.0},
    "torus": COARSE,
    "lens": COARSE,
}


@pytest.fixture(params=CASES)
def case(request):
    return request.param, meshed(request.param, **CASES[request.param])


def slopes(parts):
    """Derivatives (q, 10, 3) of the shape functions at the points (q, 4), along the edges at corner 0."""
    by_part = np.zeros((len(parts), 10, 4))
    for i in range(4):
        by_part[:, i, i] = 4 * parts[:, i] - 1
    for node, (i, j) in enumerate(MIDDLE_EDGES, 4):
        by_part[:, node, i], by_part[:, node, j] = 4 * parts[:, j], 4 * parts[:, i]
    return by_part[:, :, 1:] - by_part[:, :, :1]


def jacobians(result, parts):
    """Determinants (m, q) at the points (q, 4) of each tetrahedron."""
    return np.linalg.det(np.einsum("mni,qnk->mqik", result.points[result.tets], slopes(parts)))


def volume_of(result):
    """By the rule of five points that is exact for cubics (Keast 1986), which the Jacobian is."""
    parts = np.vstack([np.full((1, 4), 1 / 4), np.full((4, 4), 1 / 6) + np.eye(4) / 3])
    weights = np.array([-4 / 5, *[9 / 20] * 4]) / 6
    return (jacobians(result, parts) @ weights).sum()


def test_jacobians_are_positive_everywhere(case):
    _, result = case
    parts = np.random.default_rng(3).dirichlet(np.ones(4), 300)
    edges = [
        np.eye(4)[i] * t + np.eye(4)[j] * (1 - t) for i, j in MIDDLE_EDGES for t in (0, 0.3, 0.5, 0.9, 1)
    ]
    found = jacobians(result, np.vstack([parts, edges]))
    corners = result.points[result.tets[:, :4]]
    straight = np.linalg.det(corners[:, 1:] - corners[:, :1])
    assert (found.min(axis=1) > 0.1 * straight * (1 - 1e-9)).all()


def test_gmsh_finds_no_jacobian_that_is_not_positive(case, least_jacobian, tmp_path):
    _, result = case
    io.write_mesh(result, tmp_path / "mesh.msh")
    assert least_jacobian(tmp_path / "mesh.msh") > 0


def test_corners_are_those_of_the_straight_mesh(case):
    name, result = case
    straight = meshed(name, **{**CASES[name], "order": 1})
    n = len(straight.points)
    assert straight.tets.shape[1] == 4 and len(straight.straightened) == 0
    for array, columns in ("tets", 4), ("triangles", 3), ("edges", 2):
        assert np.array_equal(getattr(result, array)[:, :columns], getattr(straight, array)), array
    for array in ("points", "carriers", "fractions"):
        assert np.array_equal(getattr(result, array)[:n], getattr(straight, array)), array
    for array in ("variation", "dihedral_min", "above_threshold", "tet_solids", "triangle_faces"):
        assert np.array_equal(getattr(result, array), getattr(straight, array)), array
    assert result.carriers.shape == (len(result.points), 2)
    assert np.array_equal(np.unique(result.tets[:, 4:]), np.arange(n, len(result.points)))


def test_each_edge_has_one_node_near_its_middle(case):
    _, result = case
    ends = np.sort(result.tets[:, MIDDLE_EDGES].reshape(-1, 2), axis=1)
    node = result.tets[:, 4:].ravel()
    edges, first = np.unique(ends, axis=0, return_index=True)
    assert len(edges) == len(np.unique(node)) == len(np.unique(np.column_stack([ends, node]), axis=0))
    node_of = {tuple(edge): node[i] for edge, i in zip(edges.tolist(), first)}
    for rows, corners in (result.triangles, 3), (result.edges, 2):
        for row in rows:
            middle = row[corners:].tolist()
            pairs = MIDDLE_EDGES[: len(middle)]
            assert [node_of[tuple(sorted(row[pair]))] for pair in pairs] == middle
    inside = result.carriers[node[first], 0] == 3
    inside &= ~np.isin(node[first], result.straightened)
    halfway = result.points[edges].mean(axis=1)
    assert np.array_equal(result.points[node[first]][inside], halfway[inside])


def test_nodes_lie_on_the_entities_that_carry_them(case):
    import Part

    name, result = case
    kinds = {0: shape(name).Vertexes, 1: shape(name).Edges, 2: shape(name).Faces}
    on_boundary = np.unique(np.hstack([result.triangles.ravel(), result.edges.ravel()]))
    carried = np.setdiff1d(on_boundary, result.straightened)
    assert (result.carriers[carried, 0] < 3).all()
    for i in np.random.default_rng(4).permutation(carried)[:150]:
        dimension, number = result.carriers[i]
        vertex = Part.Vertex(*map(float, result.points[i]))
        assert kinds[dimension][number - 1].distToShape(vertex)[0] < ON_SURFACE


def test_all_nodes_are_on_the_true_ball_and_cylinder():
    ball, cylinder = (meshed(name, surface_deviation=0.05) for name in ("ball", "cylinder"))
    assert len(ball.straightened) == len(cylinder.straightened) == 0
    assert np.abs(np.linalg.norm(ball.points[np.unique(ball.triangles)], axis=1) - 10).max() < ON_SURFACE
    x, y, z = cylinder.points[np.unique(cylinder.triangles)].T
    side, ends = np.abs(np.hypot(x, y) - 8), np.minimum(np.abs(z), np.abs(z - 12))
    assert np.minimum(side, ends).max() < ON_SURFACE
    rims = cylinder.points[np.unique(cylinder.edges)]
    assert np.abs(np.hypot(rims[:, 0], rims[:, 1]) - 8).max() < ON_SURFACE


def test_volume_is_that_of_the_curved_tetrahedra(case):
    name, result = case
    assert result.volume == pytest.approx(volume_of(result), rel=1e-12)
    straight = meshed(name, **{**CASES[name], "order": 1})
    assert abs(result.volume - shape(name).Volume) < 0.5 * abs(straight.volume - shape(name).Volume)


def test_volume_converges_faster_than_that_of_straight_tetrahedra():
    exact = 4 / 3 * math.pi * 1000
    for deviation in (0.2, 0.05):
        curved, straight = (meshed("ball", surface_deviation=deviation, order=order) for order in (2, 1))
        # Errors of the straight mesh go with the square of the size, of the curved one with its fourth power.
        relative = abs(straight.volume / exact - 1)
        assert abs(curved.volume / exact - 1) < 0.2 * relative**2
        assert curved.deviation_max < 0.02 * straight.deviation_max


def test_what_is_straightened_is_counted_and_told():
    result = meshed("torus", stop_after="initial", **COARSE)
    count = len(result.straightened)
    assert count > 10
    corners = len(np.unique(result.tets[:, :4]))
    middle = np.unique(result.triangles[:, 3:])
    assert middle.min() >= corners
    told = f"{count} of {len(middle)} middle nodes of boundary edges stay off"
    assert any(told in message for message in result.messages)
    assert result.status == "ok"
    report = core.report(result)
    assert (report["order"], report["points"], report["straightened"]) == (2, len(result.points), count)
    boundary = np.unique(result.triangles)
    x, y, z = result.points[boundary].T
    off = np.abs(np.hypot(np.hypot(x, y) - 10, z) - 2) > ON_SURFACE
    assert np.array_equal(boundary[off], result.straightened)
    assert (result.carriers[result.straightened] == [3, 1]).all()


def test_fractions_are_those_of_the_formula(case):
    _, result = case
    expected = core.Material(["0.5 + x/50"]).evaluate(result.points)
    np.testing.assert_allclose(result.fractions, expected, atol=1e-14)


def test_a_material_that_is_undefined_in_a_hole():
    """Nodes that could not follow the wall stay in the hole, between their neighbours of the solid."""
    brep = shape("tube").exportBrepToString().encode()
    material = core.Material(["0.2*sqrt(r - 9.4999)"])
    options = core.MeshingOptions(order=2, stop_after="initial", **COARSE)
    result = core.generate_mesh(brep, material, options)
    undefined = np.isnan(material.evaluate(result.points)[:, 0])
    assert undefined.any() and np.isin(np.flatnonzero(undefined), result.straightened).all()
    assert (result.fractions >= 0).all() and (result.fractions <= 1).all()


def test_two_runs_give_the_same_bytes():
    brep = shape("torus").exportBrepToString().encode()
    options = core.MeshingOptions(order=2, material_threshold=0.3, **COARSE)
    first, second = (core.generate_mesh(brep, core.Material(["0.5 + x/50"]), options) for _ in range(2))
    for name in ("points", "carriers", "tets", "triangles", "edges", "fractions", "straightened"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes(), name
