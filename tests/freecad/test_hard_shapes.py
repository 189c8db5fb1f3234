# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids with what makes meshers fail, against closed forms and against FreeCAD's own account of them."""
import math
import re

import FreeCAD
import numpy as np
import Part
import pytest

from FreeCAD import Vector

X, Z = Vector(1, 0, 0), Vector(0, 0, 1)


def extruded(wire, height):
    return Part.Face(Part.Wire(wire)).extrude(height * Z)


def curve(kind, *points):
    made = kind()
    made.setPoles([Vector(*point) for point in points]) if kind is Part.BezierCurve else made.interpolate(
        [Vector(*point) for point in points]
    )
    return made.toShape()


def ball():
    return Part.makeSphere(10)


def torus():
    return Part.makeTorus(10, 3)


def cone():
    return Part.makeCone(5, 0, 12)


def needle():
    """A cone whose tip is too sharp for samples to hold its volume as well as those of other parts."""
    return Part.makeCone(0.5, 0, 20)


def ball_in_a_box():
    return Part.makeBox(20, 20, 20).cut(Part.makeSphere(6, Vector(10, 10, 10)))


def knife():
    """A wedge of 8 degrees."""
    tip = [Vector(), Vector(10, 0, 0), Vector(10, 10 * math.tan(math.radians(8)), 0), Vector()]
    return extruded(Part.makePolygon(tip).Edges, 5)


def sliver():
    """A wedge of one degree: no angle but those at its edge, and where it is thinner than MinSize, is forced."""
    tip = [Vector(), Vector(10, 0, 0), Vector(10, 10 * math.tan(math.radians(1)), 0), Vector()]
    return extruded(Part.makePolygon(tip).Edges, 5)


def thin_tube():
    return Part.makeCylinder(10, 20).cut(Part.makeCylinder(9.8, 20))


def shell_of_a_ball():
    return Part.makeSphere(10).cut(Part.makeSphere(9.5))


def slender_rod():
    return Part.makeCylinder(1, 60)


def teardrop():
    """One closed spline with a sharp corner, where both the seam of the wall and the rims' ends are."""
    return extruded([curve(Part.BezierCurve, (0, 0), (30, 10), (30, -10), (0, 0))], 8)


def naca(x):
    """Half the thickness of an airfoil of chord 1."""
    return 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)


def airfoil():
    """As thin as wanted towards the trailing edge, on two sides of one face."""

    stations = [0.5 * (1 + math.cos(math.pi * i / 12)) for i in range(13)]
    upper = [(50 * x, 50 * naca(x)) for x in stations]
    return extruded([curve(Part.BSplineCurve, *upper, *((x, -y) for x, y in reversed(upper[:-1])))], 40)


def blade():
    """Its trailing edge is a strip a few ten-millionths of the part wide, at the end of a wedge of 17 degrees."""

    def section(chord, height):
        stations = [0.5 * (1 + math.cos(math.pi * i / 12)) for i in range(13)]
        upper = [(chord * x, chord * naca(x) + 6e-5 * x, height) for x in stations]
        outline = curve(Part.BSplineCurve, *upper, *((x, -y, z) for x, y, z in reversed(upper[:-1])))
        ends = [vertex.Point for vertex in outline.Vertexes]
        return Part.Wire([outline, Part.makeLine(ends[1], ends[0])])

    return Part.makeLoft([section(200, 0), section(100, 300)], True)


def narrow_rings():
    """A wavy wall of rings, each a four-hundredth as wide as long."""
    wall = [Vector(20 + 2 * math.sin(i / 8), 0, 0.2 * i) for i in range(6)]
    outline = [Vector(10, 0, 0), *wall, Vector(10, 0, 1), Vector(10, 0, 0)]
    return Part.Face(Part.makePolygon(outline)).revolve(Vector(), Z, 360)


def nearly_horn():
    """A torus whose hole is a hundredth of its wall."""
    return Part.makeTorus(10.1, 10)


def coil():
    """One turn of a spring, whose wall is a single span of a spline."""
    sweep = Part.BRepOffsetAPI.MakePipeShell(Part.makeHelix(8, 8, 10))
    sweep.setFrenetMode(True)
    sweep.add(Part.Wire(Part.makeCircle(1.5, Vector(10, 0, 0), Vector(0, 20 * math.pi, 8))))
    sweep.build()
    sweep.makeSolid()
    return sweep.shape()


def crossing_bores():
    """Bores that cut each other, so that a wall lies between edges that run around it."""
    bores = [Part.makeCylinder(2, 30, Vector(-15, 0, 12), X), Part.makeCylinder(1.5, 50, Vector(0, 3, 0))]
    return Part.makeCylinder(8, 50).cut(bores)


def grazing_bore():
    """A cross bore that breaks out of the shaft on either side of a bridge, 0.02 mm thick and thinner towards its
    ends."""
    return Part.makeCylinder(8, 50).cut(Part.makeCylinder(2, 60, Vector(-30, 5.98, 25), X))


def loft():
    square = Part.makePolygon([Vector(x, y) for x, y in ((-6, -6), (6, -6), (6, 6), (-6, 6), (-6, -6))])
    sections = [Part.Wire(Part.makeCircle(4, Vector(0, 0, 15))), square]
    return Part.makeLoft(sections, True)


def small_fillet():
    box = Part.makeBox(30, 20, 10)
    return box.makeFillet(0.1, [box.Edges[0]])


def narrow_strip():
    """Two fillets leave a strip between them that is a two-thousandth as wide as long."""
    box = Part.makeBox(10, 40, 10)
    along = [edge for edge in box.Edges if edge.BoundBox.YLength > 39 and edge.BoundBox.ZMin > 9]
    return box.makeFillet(4.99, along)


def small_hole():
    return Part.makeBox(40, 40, 10).cut(Part.makeCylinder(0.05, 10, Vector(20, 20)))


def thread():
    profile = [
        Vector(5, 0, -0.6),
        Vector(5, 0, 0.6),
        Vector(4.2, 0, 0.2),
        Vector(4.2, 0, -0.2),
        Vector(5, 0, -0.6),
    ]
    sweep = Part.BRepOffsetAPI.MakePipeShell(Part.makeHelix(2, 6, 5))
    sweep.setFrenetMode(True)
    sweep.add(Part.makePolygon(profile))
    sweep.build()
    sweep.makeSolid()
    groove = sweep.shape()
    groove.translate(Vector(0, 0, 4))
    return Part.makeCylinder(4.9, 14).cut(groove)


def area_within(profile):
    """Of one closed curve, by a polygon; FreeCAD integrates over a wavy spline with too few points."""
    x, y, _ = np.array([tuple(point) for point in profile.discretize(5000)]).T
    return abs(np.sum(x * np.roll(y, 1) - y * np.roll(x, 1))) / 2


VOLUMES = {
    ball: 4000 / 3 * math.pi,
    torus: 2 * math.pi**2 * 10 * 3**2,
    cone: 100 * math.pi,
    needle: 5 / 3 * math.pi,
    ball_in_a_box: 8000 - 288 * math.pi,
    knife: 250 * math.tan(math.radians(8)),
    sliver: 250 * math.tan(math.radians(1)),
    thin_tube: 20 * math.pi * (10**2 - 9.8**2),
    shell_of_a_ball: 4 / 3 * math.pi * (10**3 - 9.5**3),
    slender_rod: 60 * math.pi,
    teardrop: 0.15 * 600 * 8,
    airfoil: 40 * area_within(next(edge for edge in airfoil().Edges if edge.isClosed())),
    narrow_rings: None,
    nearly_horn: 2 * math.pi**2 * 10.1 * 10**2,
    coil: math.pi * 1.5**2 * math.hypot(20 * math.pi, 8),
    crossing_bores: None,
    grazing_bore: None,
    loft: None,
    small_fillet: 6000 - (1 - math.pi / 4) * 0.1**2 * 10,
    narrow_strip: 4000 - (2 - math.pi / 2) * 4.99**2 * 40,
    small_hole: 16000 - math.pi * 0.05**2 * 10,
    thread: None,
}
"""mm^3; None where only FreeCAD knows."""


@pytest.mark.parametrize("make", VOLUMES)
def test_mesh_is_the_solid(make, core):
    shape = make()
    volume = VOLUMES[make] or shape.Volume
    assert shape.isValid() and shape.ShapeType in ("Solid", "Compound") and len(shape.Solids) == 1
    assert make is airfoil or shape.Volume == pytest.approx(volume, rel=1e-6)
    options = core.MeshingOptions(material_threshold=0.4)
    result = core.generate_mesh(shape.exportBrepToString(), core.Material([ramp(shape)]), options)
    assert result.status == "ok", result.messages
    assert result.volume == pytest.approx(volume, rel=5e-3)
    assert result.deviation_max <= result.surface_deviation
    assert euler_characteristic(result.triangles) == euler_characteristic_of_solid(shape)
    assert set(result.triangle_faces) == set(range(1, len(shape.Faces) + 1))
    assert distance_to_faces(result, shape) < 1e-6
    assert np.delete(result.dihedral_min, result.forced_angles).min() >= 5


def ramp(shape):
    box = shape.BoundBox
    return f"0.1 + 0.8*(z - ({box.ZMin!r}))/{box.ZLength!r}"


def euler_characteristic(triangles):
    ends = np.sort(np.vstack([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
    return len(np.unique(triangles)) - len(np.unique(ends, axis=0)) + len(triangles)


def euler_characteristic_of_solid(shape):
    """Of the cells of its boundary; a face with inner wires counts as many less, poles are no edges."""
    edges = sum(not edge.Degenerated for edge in shape.Edges)
    seamless = sum(len(face.Wires) - 1 for face in shape.Faces)
    return len(shape.Vertexes) - edges + len(shape.Faces) - seamless


def distance_to_faces(result, shape):
    """The largest of a vertex of a boundary triangle, mm; of some, since FreeCAD is slow at it."""
    some = np.random.default_rng(1).choice(len(result.triangles), 60)
    corners = result.points[result.triangles[some, 0]]
    return max(
        shape.Faces[number - 1].distToShape(Part.Vertex(FreeCAD.Vector(*corner)))[0]
        for number, corner in zip(result.triangle_faces[some].tolist(), corners.tolist())
    )


def stepped_box(height):
    low = Part.makeBox(10, 10, 5)
    return low.fuse(Part.makeBox(5, 10, 5 + height)).removeSplitter()


def filleted_box(radius):
    box = Part.makeBox(20, 20, 20)
    return box.makeFillet(radius, [box.Edges[0], box.Edges[2]])


def meshed(shape, core, **options):
    result = core.generate_mesh(
        shape.exportBrepToString(), core.Material(["0.5"]), core.MeshingOptions(**options)
    )
    assert result.status == "ok", result.messages
    assert result.deviation_max <= result.surface_deviation
    assert euler_characteristic(result.triangles) == 2
    return result


@pytest.mark.parametrize("make, lost", [(stepped_box, 1), (filleted_box, 2)])
def test_features_below_min_size_are_bridged(make, lost, core):
    shape, plain = make(0.002), Part.makeBox(10, 10, 5)
    result = meshed(shape, core)
    missing = set(range(1, len(shape.Faces) + 1)) - set(result.triangle_faces)
    assert len(missing) == lost
    (message,) = result.messages
    assert "smaller than MinSize" in message and "bridged" in message and f"Face{min(missing)}" in message
    assert result.volume == pytest.approx(shape.Volume, rel=1e-3)
    assert result.dihedral_min.min() >= 10
    assert len(result.tets) < 2 * len(meshed(plain, core).tets)


def test_features_above_min_size_are_kept(core):
    shape = stepped_box(0.002)
    result = meshed(shape, core, min_size=0.001, max_size=5)
    assert set(result.triangle_faces) == set(range(1, len(shape.Faces) + 1))
    assert not any("bridged" in message for message in result.messages)
    assert result.volume == pytest.approx(shape.Volume, rel=1e-9)


def test_a_strip_at_the_end_of_a_wedge_is_bridged(core):
    """Samples of such a strip lie inside it, and those of its two borders are at other places."""
    shape = blade()
    strip = min(shape.Faces, key=lambda face: face.Area)
    result = meshed(shape, core)
    assert {1, 2, 3, 4} - set(result.triangle_faces) == {
        1 + [face.isSame(strip) for face in shape.Faces].index(True)
    }
    root = max((face for face in shape.Faces if face.BoundBox.ZMax < 1), key=lambda face: face.Area)
    area = area_within(max(root.Edges, key=lambda edge: edge.Length))
    assert result.volume == pytest.approx(300 * area * (1 + 1 / 2 + 1 / 4) / 3, rel=5e-3)
    assert result.dihedral_min.min() >= 10


def test_a_thin_bent_wall_is_no_feature_to_bridge(core):
    """The normals of its two sides differ as those of a wedge do, where they are not taken at one place."""
    shape = bent_plate(0.003)
    options = core.MeshingOptions(stop_after="initial")
    result = core.generate_mesh(shape.exportBrepToString(), core.Material(["0.5"]), options)
    assert set(result.triangle_faces) == set(range(1, 7))


@pytest.mark.parametrize("thickness", [0.05, 0.005])
def test_thin_walls_are_no_features_to_bridge(thickness, core):
    shape = Part.makeBox(10, 10, thickness)
    result = core.generate_mesh(shape.exportBrepToString(), core.Material(["0.5"]))
    assert result.volume == pytest.approx(shape.Volume, rel=1e-9)
    assert set(result.triangle_faces) == set(range(1, 7))


def test_a_wall_is_fine_where_it_is_thinnest(core):
    """Between a ball and a side of its box it is a thousandth of the box, at one place only."""
    shape = Part.makeBox(10, 10, 10).cut(Part.makeSphere(3, Vector(5, 5, 3.01)))
    options = core.MeshingOptions(stop_after="initial")
    result = core.generate_mesh(shape.exportBrepToString(), core.Material(["0.5"]), options)
    assert result.dihedral_min.min() >= 5
    assert len(result.tets) < 5000


def bent_plate(thickness):
    """Of 10 x 10 mm, nearly, and a radius of 100 mm."""
    turn = 6  # degrees
    return Part.makeCylinder(100, 10, Vector(), Z, turn).cut(
        Part.makeCylinder(100 - thickness, 10, Vector(), Z, turn)
    )


def plate_with_holes(*corners):
    """Of 20 x 20 x 5 mm, with square holes of 5 mm at these corners."""
    holes = [Part.makeBox(5, 5, 5, Vector(x, y, 0)) for x, y in corners]
    return Part.makeBox(20, 20, 5).cut(holes)


def boxes(*corners):
    """Cubes of 10 mm at these corners."""
    return Part.Compound([Part.makeBox(10, 10, 10, Vector(*corner)) for corner in corners])


@pytest.mark.parametrize(
    "make, volume",
    [
        (lambda: plate_with_holes((5, 5), (10, 10)), 2000 - 250),
        (lambda: plate_with_holes((5, 5), (10, 10), (0, 10)), 2000 - 375),
        (lambda: boxes((0, 0, 0), (10, 10, 0)), 2000),
        (lambda: boxes((0, 0, 0), (10, 10, 10)), 2000),
        (lambda: boxes((0, 0, 0), (10, 4, 10)), 2000),
    ],
    ids=[
        "holes at an edge",
        "holes at two edges",
        "boxes at an edge",
        "boxes at a corner",
        "boxes at part of an edge",
    ],
)
def test_solids_may_touch_themselves_and_others_at_edges_and_corners(make, volume, core):
    shape = make()
    options = core.MeshingOptions(material_threshold=0.2, max_size=4)
    result = core.generate_mesh(shape.exportBrepToString(), core.Material([ramp(shape)]), options)
    assert result.status == "ok", result.messages
    assert result.volume == pytest.approx(volume, rel=1e-9)
    assert len(np.unique(result.points, axis=0)) == len(result.points)
    assert result.dihedral_min.min() >= 5


def test_solids_may_touch_along_curves_on_both_sides(core):
    """A shaft that fits a ring like a tangent, and a block that cuts into the ring: samples touch in many places."""
    shaft = Part.makeCylinder(7, 10, Vector(0, 0, -5))
    block = Part.makeBox(4, 4, 4, Vector(13, -2, -2))
    shape = Part.Compound([Part.makeTorus(10, 3), shaft, block])
    result = core.generate_mesh(shape.exportBrepToString(), core.Material(["0.5"]))
    volume = 180 * math.pi**2 + 490 * math.pi + block.cut(Part.makeTorus(10, 3)).Volume
    assert result.status == "ok", result.messages
    assert result.volume == pytest.approx(volume, rel=5e-3)
    assert result.dihedral_min.min() >= 10


def hook(depth):
    """Of square wire of 2 mm, whose end runs into its shank along an edge of both, by `depth`."""
    path = [(0, 0, 0), (20, 0, 0), (20, 20, 0), (20, 20, 6), (4, 20, 6), (4, 20, 2.01), (4, 1.01, 2.01)]
    sweep = Part.BRepOffsetAPI.MakePipeShell(Part.makePolygon([Vector(*point) for point in path]))
    sweep.setTransitionMode(1)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
    sweep.add(Part.makePolygon([Vector(0, y, z) for y, z in corners]))
    sweep.build()
    sweep.makeSolid()

    def lowered(point):
        step = (0.01 + depth) * (1.005 < point.z < 3.02)
        return point - Vector(0, step * (abs(point.y - 1.01) < 1e-6), step)

    def moved(face):
        points = [lowered(vertex.Point) for vertex in face.OuterWire.OrderedVertexes]
        return Part.Face(Part.makePolygon([*points, points[0]]))

    return Part.Solid(Part.makeShell([moved(face) for face in sweep.shape().Faces]))


def test_faces_that_cross_near_their_borders_are_named(core):
    """OpenCASCADE's check of a shape alone does not see it."""
    shape = hook(0.01)
    assert shape.isValid() and len(shape.Solids) == 1
    with pytest.raises(core.GeometryError, match="parts of the shape cross or touch each other: ") as refusal:
        meshed(shape, core)
    named = re.findall(r"Face(\d+) and Face(\d+)", str(refusal.value))
    assert named
    for one, other in ((shape.Faces[int(a) - 1], shape.Faces[int(b) - 1]) for a, b in named):
        assert one.distToShape(other)[0] < 1e-7
        assert not any(mine.isSame(theirs) for mine in one.Vertexes for theirs in other.Vertexes)
    meshed(hook(-0.01), core)


def test_a_wall_that_thins_to_nothing_is_refused(core):
    """A hole that touches a side of its box, and one that passes through it."""
    box = Part.makeBox(10, 10, 10)
    touching = box.cut(Part.makeCylinder(3, 10, Vector(3, 5, 0)))
    with pytest.raises(
        core.GeometryError, match=r"Face\d and Face\d touch each other along Edge\d+ like tangents"
    ):
        meshed(touching, core)
    through = box.cut(Part.makeCylinder(3, 10, Vector(2.5, 5, 0)))
    result = core.generate_mesh(through.exportBrepToString(), core.Material(["0.5"]))
    assert result.status == "ok" and result.dihedral_min.min() >= 5
