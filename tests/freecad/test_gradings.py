# SPDX-License-Identifier: GPL-3.0-or-later
"""Ready gradings on a placed solid: from 0 to 1 over it, wherever its frame stands."""
import math

import FreeCAD
import pytest

from freecad.fgmesh import core


@pytest.fixture
def cylinder(document, placement):
    """A placed cylinder of radius 5 mm from z = 0 to 30 mm along its own axis."""
    cylinder = document.addObject("Part::Cylinder", "Cylinder")
    cylinder.Radius, cylinder.Height = 5, 30
    cylinder.Placement = placement
    document.recompute()
    return cylinder


def fractions_at(cylinder, name, points, frame=None, references=()):
    """The fraction of a ready grading at points in the cylinder's own coordinates."""
    from freecad.fgmesh.model import gradings
    from freecad.fgmesh.model.material_draft import MaterialDraft

    (grading,) = [one for one in gradings.GRADINGS if one.name == name]
    frame = frame or FreeCAD.Placement()
    parameters = gradings.fitted(grading, cylinder.Shape, cylinder.Placement.multiply(frame))
    texts = {name: repr(value) for name, value in parameters.items()}
    draft = MaterialDraft([], [grading.formula], texts, frame, list(references))
    placed = [tuple(cylinder.Placement.multVec(FreeCAD.Vector(*point))) for point in points]
    return core.read_references(draft.material(cylinder)).evaluate(placed)[:, 0]


BOTTOM, MIDDLE, TOP = (0, 0, 0), (0, 0, 15), (0, 0, 30)


@pytest.mark.parametrize(
    "name, points, expected",
    [
        ("Linear along z", [BOTTOM, MIDDLE, TOP], [0, 0.5, 1]),
        ("Linear along x", [(-5, 0, 3), (0, 1, 3), (5, 0, 3)], [0, 0.5, 1]),
        ("Linear along y", [(0, -5, 3), (1, 0, 3), (0, 5, 3)], [0, 0.5, 1]),
        ("Power law along z", [BOTTOM, MIDDLE, TOP], [0, 0.25, 1]),
        ("Exponential along z", [BOTTOM, (0, 0, 10), TOP], [1, math.exp(-1), math.exp(-3)]),
        ("Exponential about a point", [BOTTOM], [1]),
        ("Radial", [MIDDLE, (2.5, 0, 7), (0, 5, 7)], [0, 0.5, 1]),
        ("Spherical", [BOTTOM, (3, 4, 30)], [0, 1]),
        (
            "Sigmoid layer across z",
            [BOTTOM, MIDDLE, TOP],
            [1 / (1 + math.exp(5)), 0.5, 1 / (1 + math.exp(-5))],
        ),
    ],
)
def test_fits_the_solid(cylinder, name, points, expected):
    assert fractions_at(cylinder, name, points) == pytest.approx(expected, abs=1e-5)


def test_fits_the_solid_in_a_frame_of_its_own(cylinder):
    # z of the frame along the solid's -z, from its upper end.
    frame = FreeCAD.Placement(FreeCAD.Vector(0, 0, 30), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 180))
    found = fractions_at(cylinder, "Linear along z", [BOTTOM, MIDDLE, TOP], frame)
    assert found == pytest.approx([1, 0.5, 0], abs=1e-5)


def test_from_face_to_face(cylinder):
    kinds = [type(face.Surface).__name__ for face in cylinder.Shape.Faces]
    names = [f"Face{number}" for number, kind in enumerate(kinds, 1) if kind == "Plane"]
    links = [(cylinder, name) for name in names]
    top_first = fractions_at(cylinder, "From face A to face B", [(1, 1, 6)], references=links)[0]
    assert sorted([top_first, 1 - top_first]) == pytest.approx([0.2, 0.8], abs=1e-9)
    layer = fractions_at(cylinder, "Layer below a face", [BOTTOM, TOP], references=links[:1])
    assert max(layer) == pytest.approx(1) and min(layer) == pytest.approx(math.exp(-10), rel=1e-6)


def test_every_grading_names_what_it_needs(cylinder):
    from freecad.fgmesh.model import gradings

    links = [(cylinder, "Face1"), (cylinder, "Face2")]
    for grading in gradings.GRADINGS:
        fractions_at(cylinder, grading.name, [MIDDLE], references=links[: grading.references])


@pytest.mark.parametrize(
    "size, name",
    [
        ((1, 2, 3), "Linear along z"),
        ((3, 2, 1), "Linear along x"),
        ((2, 3, 1), "Linear along y"),
        ((2, 2, 2), "Linear along z"),
    ],
)
def test_the_first_one_runs_along_the_longest_axis_of_the_frame(document, placement, size, name):
    from freecad.fgmesh.model import gradings

    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = size
    box.Placement = placement
    document.recompute()
    assert gradings.to_begin_with(box.Shape, box.Placement).name == name


def _turned(degrees):
    return FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), degrees))


def _ball():
    import Part

    return Part.makeSphere(10, FreeCAD.Vector(6, 2, 3)), 10, [(-5, 15), (-10, 10), (-10, 10)], 15


def _cap():
    """What lies above z = 5 of a ball about (1, 2, 3): its rim is the widest."""
    import Part

    ball = Part.makeSphere(10, FreeCAD.Vector(1, 2, 3))
    wide = math.sqrt(75)
    return (
        ball.common(Part.makeBox(40, 40, 40, FreeCAD.Vector(-19, -18, 8))),
        wide,
        [(-wide, wide), (-wide, wide), (5, 10)],
        10,
    )


def _torus():
    import Part

    torus = Part.makeTorus(10, 3, FreeCAD.Vector(1, 2, 3))
    return torus, 13, [(-13, 13), (-13, 13), (-3, 3)], 13


@pytest.mark.parametrize("make", [_ball, _cap, _torus])
@pytest.mark.parametrize("degrees", [0, 90])
def test_reach_of_round_shapes(build_dir, make, degrees):
    """In a frame at (1, 2, 3), whose z axis is that of the shape or its x axis."""
    from freecad.fgmesh.model import gradings

    shape, r_max, (x, y, z), d_max = make()
    found = gradings.extent(shape, _turned(degrees))
    expected = [x, y, z] if degrees == 0 else [(-z[1], -z[0]), y, x]
    for axis in range(3):
        assert (found.low[axis], found.high[axis]) == pytest.approx(expected[axis], abs=0.06)
    assert found.d_max == pytest.approx(d_max, rel=5e-3)
    if degrees == 0 and make is not _ball:
        assert found.r_max == pytest.approx(r_max, rel=5e-3)
