# SPDX-License-Identifier: GPL-3.0-or-later
"""Graded PartDesign bodies with patterns, chamfers and walls: the law of the body holds all over what it becomes."""
import FreeCAD
import numpy as np
import pytest
from FreeCAD import Placement, Rotation, Vector

SLOPE = 25.0
LAW = "clamp(0.5+(x+2*y)/h, 0, 1)"


def axis(body, role):
    return next(feature for feature in body.Origin.OriginFeatures if feature.Role == role), [""]


def linear(body, pad):
    return "LinearPattern", dict(Originals=[pad], Direction=axis(body, "X_Axis"), Length=16, Occurrences=3)


def polar(body, pad):
    return "PolarPattern", dict(Originals=[pad], Axis=axis(body, "Z_Axis"), Angle=360, Occurrences=4)


def mirrored(body, pad):
    return "Mirrored", dict(Originals=[pad], MirrorPlane=axis(body, "XZ_Plane"))


def chamfer(_, pad):
    return "Chamfer", dict(Base=(pad, ["Edge1"]), Size=1)


def fillet(_, pad):
    return "Fillet", dict(Base=(pad, ["Edge1"]), Radius=1)


def thickness(_, pad):
    return "Thickness", dict(Base=(pad, ["Face6"]), Value=1)


@pytest.fixture
def add(body):
    """A function: gives the body a feature and makes that its tip."""

    def add(what):
        kind, values = what(body, body.Tip)
        feature = body.newObject(f"PartDesign::{kind}", kind)
        for name, value in values.items():
            setattr(feature, name, value)
        body.Tip = feature
        body.Document.recompute()
        assert feature.isValid()

    return add


def meshed(fgmesh, thing):
    mesh = fgmesh.make_mesh(thing.Document, thing)
    mesh.MaterialThreshold = 0.4
    return mesh, fgmesh.generate(mesh)


def check(result, place, chosen=slice(None)):
    """Compares the fractions with the closed form in the coordinates of a body that stands at `place`."""
    points = result.points[result.tets[chosen]].reshape(-1, 3)
    local = np.array([place.inverse().multVec(Vector(*point)) for point in points])
    expected = np.clip(0.5 + (local[:, 0] + 2 * local[:, 1]) / SLOPE, 0, 1)
    assert np.allclose(result.tet_fractions[chosen, :, 0].ravel(), expected, atol=1e-8)


def volume(result):
    corners = result.points[result.tets[:, :4]]
    return abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6


# The pad is 10 x 10 x 6 mm from the origin on: copies that lie over it, meet it, or touch it.
@pytest.mark.parametrize(
    "what, expected",
    [
        (linear, 1560.0),
        (polar, 2400.0),
        (mirrored, 1200.0),
        (chamfer, 597.0),
        (fillet, None),
        (thickness, None),
    ],
)
def test_the_law_of_a_body_holds_in_patterns_and_dressings(fgmesh, body, add, what, expected):
    fgmesh.attach_material(body, LAW, {"h": SLOPE})
    add(what)
    mesh, result = meshed(fgmesh, body)
    assert mesh.Status == "ok"
    assert volume(result) == pytest.approx(expected or body.Shape.Volume, rel=5e-3)
    check(result, body.Placement)
    body.Tip.Label = "Renamed"
    assert mesh.Status == "ok"


def test_copies_of_a_patterned_body(fgmesh, document, body, add):
    import Draft

    fgmesh.attach_material(body, LAW, {"h": SLOPE})
    add(linear)
    move = Placement(Vector(60, 0, 9), Rotation(Vector(0, 1, 0), 35))
    link = document.addObject("App::Link", "Link")
    link.LinkedObject, link.ElementCount = body, 2
    document.recompute()
    link.ElementList[1].Placement = move
    turn = Placement(Vector(), Rotation(Vector(0, 0, 1), 180), Vector(90, 0, 0))
    array = Draft.make_polar_array(body, 2, 360, Vector(90, 0, 0))
    clone = Draft.make_clone(body)
    clone.Placement = move
    document.recompute()
    for thing, places in (
        (link, [Placement(), move]),
        (array, [body.Placement, turn.multiply(body.Placement)]),
        (clone, [move]),
    ):
        mesh, result = meshed(fgmesh, thing)
        assert mesh.Status == "ok"
        for number, place in enumerate(places, 1):
            check(result, place, result.tet_solids == number)


def test_a_material_on_a_feature_is_not_that_of_the_body(fgmesh, core, document, body, add):
    """The feature is one of the steps to the body: a copy of it would need its own frame."""
    pad = fgmesh.attach_material(body.Tip, LAW, {"h": SLOPE})
    add(linear)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = body
    document.recompute()
    for thing in body, link:
        with pytest.raises(
            core.InvalidInput, match=f"{thing.Label} does not take over the material of {pad.Label}"
        ):
            fgmesh.make_mesh(document, thing)
    # The cure.
    fgmesh.attach_material(body, LAW, {"h": SLOPE})
    mesh, result = meshed(fgmesh, body)
    assert mesh.Status == "ok"
    check(result, body.Placement)
