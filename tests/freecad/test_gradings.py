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
