# SPDX-License-Identifier: GPL-3.0-or-later
"""Small dihedral angles: those that the shape forces, told apart from the others."""
import json
import math

import numpy as np
import pytest

from freecad.fgmesh import core
from freecad.fgmesh.cli.summary import summary


def part():
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    return Part


def extruded(*edges):
    return part().Face(part().Wire(edges)).extrude(vector(0, 0, 4))


def vector(*xyz):
    import FreeCAD

    return FreeCAD.Vector(*xyz)


def prism(degrees):
    """Of a right triangle with this angle at the origin: at the edge along z there."""
    corners = [vector(0, 0, 0), vector(10, 0, 0), vector(10, 10 * math.tan(math.radians(degrees)), 0)]
    return extruded(*(part().makeLine(corners[i - 1], corners[i]) for i in range(3)))


def cusp():
    """Between a plane and a cylinder that touch along the z axis."""
    radius, reach = 20.0, 10.0
    height = radius - math.sqrt(radius**2 - reach**2)
    middle = vector(reach / 2, radius - math.sqrt(radius**2 - reach**2 / 4), 0)
    arc = part().Arc(vector(0, 0, 0), middle, vector(reach, height, 0)).toShape()
    ends = [vector(reach, height, 0), vector(reach, 0, 0), vector(0, 0, 0)]
    return extruded(arc, *(part().makeLine(*pair) for pair in zip(ends, ends[1:])))


def chisel():
    """A pyramid over a base of 0.24 x 10 mm: all its edges are blunt, but not the corners of two of its faces."""
    tip = vector(0, 0, 10)
    base = [vector(x, y, 0) for x, y in ((-0.12, -5), (0.12, -5), (0.12, 5), (-0.12, 5))]
    outlines = [base, *([base[i - 1], base[i], tip] for i in range(4))]
    faces = [part().Face(part().makePolygon([*points, points[0]])) for points in outlines]
    return part().Solid(part().Shell(faces))


def meshed(shape, **options):
    asked = core.MeshingOptions(material_threshold=0.5, **options)
    return core.generate_mesh(shape.exportBrepToString().encode(), core.Material(["0.5"]), asked)


def edge_on_z_axis(shape):
    (number,) = (n for n, e in enumerate(shape.Edges, 1) if math.hypot(*tuple(e.CenterOfMass)[:2]) < 1e-9)
    return f"Edge{number}"


def assert_counts_are_true(result):
    small = np.flatnonzero(result.dihedral_min < 5)
    assert sorted([*result.forced_angles, *result.small_angles]) == list(small)
    report = core.report(result)
    assert (report["forced_angles"], report["small_angles"], report["angle_goal"]) == (
        len(result.forced_angles),
        len(result.small_angles),
        5,
    )
    json.dumps(report)


@pytest.mark.parametrize(
    "shape", [lambda: part().makeBox(10, 10, 10), lambda: prism(20)], ids=["box", "prism"]
)
def test_blunt_shapes_force_none(shape):
    result = meshed(shape())
    assert result.dihedral_min.min() >= 5
    assert len(result.forced_angles) == len(result.small_angles) == 0
    assert not [message for message in result.messages if "dihedral" in message]
    assert "small angles" not in summary(result)
    assert_counts_are_true(result)


def test_an_edge_of_just_five_degrees_forces_none():
    shape = prism(5)
    for turn in range(3):  # rounding errors of many kinds
        result = meshed(shape, stop_after="initial")
        assert result.dihedral_min.min() == pytest.approx(5, rel=1e-9)
        assert len(result.forced_angles) == len(result.small_angles) == 0
        assert not [message for message in result.messages if "dihedral" in message]
        shape.rotate(vector(1, 2, 3), vector(3, 1 + turn, 2), 40)


SHARP = {
    "prism": (lambda: prism(3), 3, lambda x: x * math.tan(math.radians(3))),
    "cusp": (cusp, 0, lambda x: 20 - np.sqrt(400 - x**2)),
}
"""Shape, angle at its edge in degrees, and its thickness at a distance from there."""


@pytest.mark.parametrize("shape, degrees, thickness", SHARP.values(), ids=SHARP)
def test_a_sharp_edge_forces_small_angles(shape, degrees, thickness):
    shape = shape()
    result = meshed(shape, min_size=0.01, stop_after="initial")
    edge = edge_on_z_axis(shape)
    at_edge = np.hypot(*result.points[:, :2].T) < 1e-7
    touching = at_edge[result.tets].any(axis=1)
    assert touching[result.forced_angles].sum() > 0
    assert not touching[result.small_angles].any()
    # Elsewhere the shape forces an angle where it is thinner than the smallest size.
    centres = result.points[result.tets[result.small_angles]].mean(axis=1)
    assert (thickness(centres[:, 0]) > 0.0099).all()
    (message,) = (message for message in result.messages if "the shape forces" in message)
    assert f"the faces at {edge} meet at {degrees} degrees at (" in message
    assert message.startswith(f"{len(result.forced_angles)} of {len(result.tets)} ")
    assert f"{len(result.forced_angles)} tets forced by the shape" in summary(result)
    assert_counts_are_true(result)


def test_a_sharp_corner_of_a_face_forces_small_angles():
    # Else walls are refined until no angle is small; and later stages have ways around a corner.
    result = meshed(chisel(), min_size=0.6, stop_after="initial")
    angle = 2 * math.degrees(math.atan(0.12 / math.hypot(10, 5)))
    (message,) = (message for message in result.messages if "the shape forces" in message)
    assert "two edges of Face" in message and f" meet at {angle:.3g} degrees at (0, 0, 10) mm" in message
    at_tip = np.linalg.norm(result.points - [0, 0, 10], axis=1) < 1e-7
    assert at_tip[result.tets[result.forced_angles]].any()
    assert_counts_are_true(result)


def test_a_thin_wall_forces_small_angles_where_elements_may_not_be_as_small():
    wall = part().makeBox(10, 10, 0.05)
    result = meshed(wall, min_size=0.1, max_size=3, stop_after="initial")
    assert len(result.forced_angles) > 100 and len(result.small_angles) == 0
    assert "the shape forces: walls are thinner than MinSize, 0.1 mm" in " ".join(result.messages)
    assert_counts_are_true(result)
    fine = meshed(wall, min_size=0.04, max_size=3, stop_after="initial")
    assert len(fine.forced_angles) == 0
    assert_counts_are_true(fine)
