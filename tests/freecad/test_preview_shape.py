# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids as triangles to be coloured, and their sections: closed, where the solid is, as large as it is."""
import math
import time
from types import SimpleNamespace

import numpy as np
import pytest


@pytest.fixture
def parts(build_dir, placement):
    """A function: an object with the shape of this name."""
    import FreeCAD
    import Part

    box = Part.makeBox(10, 20, 30)
    shapes = {
        "box": lambda: box,
        "sphere": lambda: Part.makeSphere(10),
        "torus": lambda: Part.makeTorus(10, 3),
        "cone": lambda: Part.makeCone(10, 0, 20),
        "plate": lambda: _plate(Part, FreeCAD),
        "ball in box": lambda: Part.makeCompound(
            [Part.makeBox(30, 30, 30), Part.makeSphere(5, FreeCAD.Vector(15, 15, 15))]
        ),
        "neighbours": lambda: Part.makeCompound([box, Part.makeBox(10, 20, 30, FreeCAD.Vector(10, 0, 0))]),
        "hollow": lambda: Part.makeBox(30, 30, 30).cut(Part.makeSphere(5, FreeCAD.Vector(15, 15, 15))),
    }

    def make(name, placed=True):
        shape = shapes[name]()
        shape.Placement = placement if placed else FreeCAD.Placement()
        return SimpleNamespace(Shape=shape, Label=name)

    return make


def _plate(Part, FreeCAD):
    """A thin plate with 100 holes: 106 faces."""
    outline = Part.makePlane(110, 110).OuterWire
    places = [FreeCAD.Vector(10 + 10 * i, 10 + 10 * j, 0) for i in range(10) for j in range(10)]
    holes = [Part.Wire(Part.makeCircle(3, place)) for place in places]
    return Part.Face([outline, *holes], "Part::FaceMakerBullseye").extrude(FreeCAD.Vector(0, 0, 4))


NAMES = ["box", "sphere", "torus", "cone", "plate", "ball in box", "neighbours", "hollow"]


@pytest.fixture
def model(build_dir):
    from freecad.fgmesh.model import preview_shape
    from freecad.fgmesh.surfaces import section

    return SimpleNamespace(surface_of=preview_shape.surface_of, cut=section.cut)


def open_edges(points, solids, triangles):
    """Directed edges without a partner in the other direction, and those that are there twice."""
    _, numbers = np.unique(np.column_stack([points, solids]) + 0.0, axis=0, return_inverse=True)
    corners = numbers.reshape(-1)[triangles]
    a, b, c = corners.T
    corners = corners[(a != b) & (b != c) & (c != a)]
    edges = corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    keys, counts = np.unique(edges @ [len(points), 1], return_counts=True)
    backs = np.unique(edges @ [1, len(points)])
    return len(np.setxor1d(keys, backs)) + (counts > 1).sum()


def area_vectors(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.cross(b - a, c - a) / 2


def volume(points, triangles):
    return (points[triangles[:, 0]] * area_vectors(points, triangles)).sum() / 3


def longest_edge(points, triangles):
    corners = points[triangles]
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max()


def whole(surface, section):
    """Points, solids and triangles of what a section has left, caps included."""
    points = np.concatenate([surface.points, section.points])
    solids = np.concatenate([surface.solids, section.solids])
    caps = [triangles for _, triangles in section.caps]
    return points, solids, np.concatenate([section.triangles, *caps])


def cap_area(surface, section):
    points = np.concatenate([surface.points, section.points])
    return sum(np.linalg.norm(area_vectors(points, caps), axis=1).sum() for _, caps in section.caps)


@pytest.mark.parametrize("name", NAMES)
def test_surface_is_closed_and_fine(model, parts, name):
    thing = parts(name)
    surface = model.surface_of(thing)
    assert open_edges(surface.points, surface.solids, surface.triangles) == 0
    assert volume(surface.points, surface.triangles) == pytest.approx(thing.Shape.Volume, rel=0.01)
    assert (
        longest_edge(surface.points, surface.triangles) <= 1.0001 * thing.Shape.BoundBox.DiagonalLength / 50
    )
    assert len(surface.triangles) < 200_000


@pytest.mark.parametrize("name", NAMES)
def test_points_lie_on_their_own_solid(model, parts, name):
    import Part

    thing = parts(name)
    surface = model.surface_of(thing)
    assert set(surface.solids) == set(range(len(thing.Shape.Solids)))
    for number in np.random.default_rng(1).integers(0, len(surface.points), 40):
        shells = Part.Compound(thing.Shape.Solids[surface.solids[number]].Shells)
        distance = Part.Vertex(*surface.points[number]).distToShape(shells)[0]
        assert distance < 0.01 * surface.diagonal


def test_normals_are_those_of_the_sphere(model, parts):
    surface = model.surface_of(parts("sphere", placed=False))
    assert np.abs(surface.normals - surface.points / 10).max() < 0.1
    assert np.linalg.norm(surface.normals, axis=1) == pytest.approx(1)


def test_edges_are_those_of_the_box(model, parts):
    surface = model.surface_of(parts("box"))
    ends = surface.points[surface.edges]
    assert np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum() == pytest.approx(4 * (10 + 20 + 30))


def test_cap_of_triangles(model, parts):
    """More triangles than allowed are not made: edges grow instead."""
    from freecad.fgmesh.model.preview_shape import surface_of

    surface = surface_of(parts("plate"), most=20_000)
    assert len(surface.triangles) <= 20_000
    assert open_edges(surface.points, surface.solids, surface.triangles) == 0


def test_no_solid_is_refused(model, core):
    import Part

    with pytest.raises(core.InvalidInput, match="Face has no solid"):
        model.surface_of(SimpleNamespace(Shape=Part.makePlane(1, 1), Label="Face"))
    with pytest.raises(core.InvalidInput, match="Nothing has no solid"):
        model.surface_of(SimpleNamespace(Shape=Part.Shape(), Label="Nothing"))


def test_shape_of_the_document_gets_no_triangles(model, box):
    before = box.Shape.exportBrepToString()
    model.surface_of(box)
    assert box.Shape.exportBrepToString() == before


@pytest.mark.parametrize("name", NAMES)
def test_sections_are_closed_and_as_large_as_the_solid(model, parts, name):
    import FreeCAD
    import Part

    thing = parts(name)
    surface = model.surface_of(thing)
    box = thing.Shape.BoundBox
    random = np.random.default_rng(2)
    for normal in (*np.eye(3), *random.normal(size=(3, 3))):
        origin = np.array(box.Center) + 0.1 * surface.diagonal * random.uniform(-1, 1, 3)
        section = model.cut(surface, origin, normal, surface.diagonal / 60)
        points, solids, triangles = whole(surface, section)
        assert open_edges(points, solids, triangles) == 0
        # The exact answer is OpenCASCADE's: what a large block behind the plane has in common with each solid.
        turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, -1), FreeCAD.Vector(*normal))
        block = Part.makeBox(500, 500, 500, FreeCAD.Vector(-250, -250, 0))
        block.Placement = FreeCAD.Placement(FreeCAD.Vector(*origin), turn)
        exact = sum(solid.common(block).Volume for solid in thing.Shape.Solids)
        assert volume(points, triangles) == pytest.approx(exact, rel=0.01)
        used = points[np.unique(triangles)]
        assert ((used - origin) @ normal / np.linalg.norm(normal)).max() < 1e-6 * surface.diagonal
        caps = np.concatenate([caps for _, caps in section.caps])
        assert longest_edge(points, caps) < 2.5 * surface.diagonal / 60
        assert (area_vectors(points, caps) @ normal).min() > -1e-9


@pytest.mark.parametrize(
    "name, origin, normal, area",
    [
        ("box", (5, 10, 15), (0, 0, 1), 200),
        ("box", (5, 10, 15), (0, -2, 0), 300),
        ("box", (5, 10, 15), (3, 0, 1), 20 * 10 * math.hypot(1, 3)),
        ("box", (0, 0, 0), (1, -1, 0), 30 * math.hypot(10, 10)),  # through an edge
        ("sphere", (0, 0, 6), (0, 0, 1), math.pi * 64),
        ("sphere", (0, 0, 0), (1, 2, 3), math.pi * 100),
        ("torus", (0, 0, 0), (0, 0, 1), math.pi * (13**2 - 7**2)),
        ("torus", (0, 0, 0), (0, 1, 0), 2 * math.pi * 9),
        ("cone", (0, 0, 0), (0, 1, 0), 200),  # through the tip
        ("hollow", (15, 15, 15), (0, 0, 1), 900 - math.pi * 25),
        ("ball in box", (15, 15, 15), (0, 0, 1), 900 + math.pi * 25),
        ("neighbours", (0, 0, 10), (0, 0, 1), 400),
        ("plate", (55, 55, 2), (0, 0, 1), 110**2 - 100 * math.pi * 9),
        ("plate", (55, 60, 2), (0, 1, 0), 4 * (110 - 10 * 6)),
    ],
)
def test_area_of_section(model, parts, name, origin, normal, area):
    surface = model.surface_of(parts(name, placed=False))
    section = model.cut(surface, origin, normal, surface.diagonal / 60)
    assert cap_area(surface, section) == pytest.approx(area, rel=0.01 if name != "box" else 1e-9)


@pytest.mark.parametrize("height, left", [(30, 6000), (0, 0), (-1, 0), (31, 6000)])
def test_plane_beside_the_solid(model, parts, height, left):
    surface = model.surface_of(parts("box", placed=False))
    section = model.cut(surface, (0, 0, height), (0, 0, 1), 1)
    assert volume(*whole(surface, section)[::2]) == pytest.approx(left)


def test_plane_between_solids_removes_one(model, parts):
    surface = model.surface_of(parts("neighbours", placed=False))
    section = model.cut(surface, (10, 0, 0), (1, 0, 0), 1)
    points, solids, triangles = whole(surface, section)
    assert volume(points, triangles) == pytest.approx(6000)
    assert set(solids[triangles].ravel()) == {0}


def test_caps_know_their_solids(model, parts):
    surface = model.surface_of(parts("ball in box", placed=False))
    section = model.cut(surface, (15, 15, 15), (0, 0, 1), 1)
    points, solids, _ = whole(surface, section)
    areas = {
        number: np.linalg.norm(area_vectors(points, caps), axis=1).sum() for number, caps in section.caps
    }
    assert areas == {0: pytest.approx(900), 1: pytest.approx(math.pi * 25, rel=0.02)}
    assert all((solids[caps] == number).all() for number, caps in section.caps)


def test_section_follows_the_mouse(model, parts):
    surface = model.surface_of(parts("plate"))
    spans = []
    for turn in range(7):
        start = time.perf_counter()
        model.cut(surface, surface.points.mean(axis=0), (1, turn / 7, 0.3), surface.diagonal / 60)
        spans.append(time.perf_counter() - start)
    assert sorted(spans)[3] < 0.3  # ten times what a quiet machine needs
