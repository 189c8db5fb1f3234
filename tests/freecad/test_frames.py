# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames from what a user points at, on a solid that is placed inside a placed part."""
import FreeCAD
import pytest

from freecad.fgmesh import core


@pytest.fixture
def frame(build_dir):
    """A function: origin and z axis of the frame that something suggests, in the own coordinates of a solid."""
    from freecad.fgmesh.model.frames import frame_from

    def found(thing, name, solid):
        placement = frame_from(thing, name, solid)
        return tuple(placement.Base), tuple(placement.Rotation.multVec(FreeCAD.Vector(0, 0, 1)))

    return found


@pytest.fixture
def nested(document, placement):
    """A function: a placed primitive inside a placed App::Part."""
    part = document.addObject("App::Part", "Part")
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 6, 7), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 1), 77))

    def make(kind, **sizes):
        thing = document.addObject(kind, "Thing")
        for name, value in sizes.items():
            setattr(thing, name, value)
        thing.Placement = placement
        part.addObject(thing)
        document.recompute()
        return thing

    return make


def named(thing, kind, word="Face"):
    """The first face, or edge, on a surface, or curve, of that kind."""
    parts = thing.Shape.Faces if word == "Face" else thing.Shape.Edges
    carriers = [type(part.Surface if word == "Face" else part.Curve).__name__ for part in parts]
    return f"{word}{carriers.index(kind) + 1}"


def near(found, origin, axis):
    assert found[0] == pytest.approx(origin, abs=1e-9)
    assert found[1] == pytest.approx(axis, abs=1e-9)


def test_plane_gives_its_middle_and_its_outward_normal(nested, frame):
    box = nested("Part::Box", Length=10, Width=20, Height=30)
    found = [frame(box, f"Face{number}", box) for number in range(1, 7)]
    middles = {tuple(round(value, 6) for value in origin + axis) for origin, axis in found}
    assert (0, 10, 15, -1, 0, 0) in middles and (10, 10, 15, 1, 0, 0) in middles
    assert (5, 10, 0, 0, 0, -1) in middles and (5, 10, 30, 0, 0, 1) in middles


@pytest.mark.parametrize(
    "kind, surface", [("Part::Cylinder", "Cylinder"), ("Part::Cone", "Cone"), ("Part::Torus", "Toroid")]
)
def test_round_surfaces_give_their_axis(nested, frame, kind, surface):
    thing = nested(kind)
    origin, axis = frame(thing, named(thing, surface), thing)
    assert origin[:2] == pytest.approx((0, 0), abs=1e-9)
    assert axis == pytest.approx((0, 0, 1), abs=1e-9)


def test_ball_circle_edge_and_vertex(nested, frame):
    ball = nested("Part::Sphere")
    assert frame(ball, "Face1", ball)[0] == pytest.approx((0, 0, 0), abs=1e-9)
    cylinder = nested("Part::Cylinder", Radius=3, Height=8)
    circle = frame(cylinder, named(cylinder, "Circle", "Edge"), cylinder)
    assert circle[0][:2] == pytest.approx((0, 0), abs=1e-9) and abs(circle[1][2]) == pytest.approx(1)
    box = nested("Part::Box", Length=10, Width=20, Height=30)
    edge = box.Shape.Edges[0]
    direction = box.Placement.inverse().Rotation.multVec(edge.tangentAt(edge.FirstParameter))
    assert frame(box, "Edge1", box)[1] == pytest.approx([abs(value) for value in direction], abs=1e-9)
    corner = box.Placement.inverse().multVec(box.Shape.Vertexes[6].Point)
    assert frame(box, "Vertex7", box)[0] == pytest.approx(tuple(corner), abs=1e-9)


def test_something_elsewhere_counts_where_it_is_seen(nested, frame, document):
    box = nested("Part::Box", Length=10, Width=20, Height=30)
    other = document.addObject("Part::Box", "Other")  # outside the part
    other.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    seen = box.getGlobalPlacement().inverse().multVec(other.Shape.Vertexes[0].Point)
    assert frame(other, "Vertex1", box)[0] == pytest.approx(tuple(seen), abs=1e-9)
    system = document.addObject("App::Placement", "System")
    system.Placement = box.getGlobalPlacement().multiply(
        FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation())
    )
    near(frame(system, "", box), (1, 2, 3), (0, 0, 1))


def test_what_suggests_no_frame_is_refused(nested, frame, document):
    box = nested("Part::Box")
    wedge = document.addObject("Part::Feature", "Free")
    import Part

    curve = Part.BSplineCurve()
    curve.interpolate([FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(1, 2, 0), FreeCAD.Vector(3, 1, 1)])
    wedge.Shape = curve.toShape()
    with pytest.raises(core.InvalidInput, match="Edge1 suggests no frame"):
        frame(wedge, "Edge1", box)
