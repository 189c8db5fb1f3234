# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas that measure distances to faces, edges, vertices and solids of the document."""
import FreeCAD
import numpy as np
import pytest


@pytest.fixture
def ends(box):
    """Names of the faces at the two ends of the box's height of 30 mm: z = 0 and z = 30 in its own frame."""
    local = box.Shape.copy()
    local.Placement = FreeCAD.Placement()
    heights = [face.CenterOfMass.z for face in local.Faces]
    return f"Face{heights.index(min(heights)) + 1}", f"Face{heights.index(max(heights)) + 1}"


@pytest.fixture
def from_end_to_end(box, fgmesh, ends):
    return fgmesh.attach_material(box, "(d1/(d1+d2))^n", {"n": 2}, references=ends)


@pytest.fixture
def ball(document):
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 5
    document.recompute()
    return ball


def value(solid, own_point):
    """The fraction at a point in the solid's own coordinates."""
    from freecad.fgmesh.model.graded_solid import material_of

    from freecad.fgmesh import core

    return core.read_references(material_of(solid)).evaluate(
        [solid.Placement.multVec(FreeCAD.Vector(*own_point))]
    )[0, 0]


def test_from_face_to_face(from_end_to_end):
    for z in np.linspace(0, 30, 7):
        assert value(from_end_to_end, (3, 4, z)) == pytest.approx((z / 30) ** 2, abs=1e-12)


def test_the_document_stays_computable(from_end_to_end):
    """A link of a solid to its own face must not count as a cycle."""
    box = from_end_to_end
    box.Height = 60
    box.Document.recompute()
    assert "Touched" not in box.State and box.isValid()
    assert value(box, (3, 4, 30)) == pytest.approx(0.25)


def test_meshing(from_end_to_end, coarse_mesh):
    mesh = coarse_mesh(from_end_to_end)
    assert mesh.Status == "ok"
    nodes = mesh.FemMesh.Nodes
    inverse = from_end_to_end.Placement.inverse()
    for number in list(nodes)[:: len(nodes) // 20]:
        height = inverse.multVec(nodes[number]).z
        assert mesh.Fractions[number - 1] == pytest.approx((height / 30) ** 2, abs=1e-9)


def test_another_object_in_another_part(document, box, ball, fgmesh):
    part = document.addObject("App::Part", "Part")
    part.addObject(ball)
    ball.Placement.Base = FreeCAD.Vector(1, 2, 3)
    part.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    fgmesh.attach_material(box, "s1/1000", references=[ball])
    centre = FreeCAD.Vector(101, 2, 3)
    corner = box.Placement.multVec(FreeCAD.Vector(0, 0, 0))
    assert value(box, (0, 0, 0)) == pytest.approx(((corner - centre).Length - 5) / 1000, abs=1e-12)


def test_forms_of_a_reference(box, ball, fgmesh):
    fgmesh.attach_material(
        box,
        "d1/99",
        references=["Face1", (ball, "Face1"), (box, ("Edge1", "Vertex2")), ball, (ball, "Solid1")],
    )
    assert box.FGMReferenceNames == [
        "Box.Face1",
        "Ball.Face1",
        "Box.Edge1",
        "Box.Vertex2",
        "Ball",
        "Ball.Solid1",
    ]
    fgmesh.attach_material(box, "d1/99", references="Face1")
    assert box.FGMReferenceNames == ["Box.Face1"]


def test_copies_measure_to_themselves(from_end_to_end):
    copy = from_end_to_end.Document.copyObject(from_end_to_end)
    copy.Placement = FreeCAD.Placement(FreeCAD.Vector(500, 0, 0), FreeCAD.Rotation())
    copy.Document.recompute()
    assert value(copy, (3, 4, 15)) == pytest.approx(0.25)


def test_a_deleted_object_is_named(box, ball, fgmesh, core):
    fgmesh.attach_material(box, "d2/100", references=[(ball, "Face1"), "Face1"])
    box.Document.removeObject("Ball")
    with pytest.raises(core.InvalidInput, match=r"Box has lost the reference d1 \(Ball.Face1\)"):
        value(box, (0, 0, 0))


def test_a_lost_face_is_named_and_the_mesh_stays(document, fgmesh, core, coarse_mesh):
    import Part

    feature = document.addObject("Part::Feature", "Feature")
    feature.Shape = Part.makeBox(10, 20, 30)
    fgmesh.attach_material(feature, "d1/100", references=["Face6"])
    mesh = coarse_mesh(feature)
    count = mesh.TetCount
    feature.Shape = Part.makeSphere(10)
    with pytest.raises(core.InvalidInput, match="Feature: the reference Face6 is lost"):
        fgmesh.generate(mesh)
    assert mesh.TetCount == mesh.FemMesh.VolumeCount == count
    assert feature.FGMReferenceNames == ["Feature.Face6"]


def test_references_mark_the_mesh(from_end_to_end, coarse_mesh, ball, fgmesh):
    box, document = from_end_to_end, from_end_to_end.Document
    fgmesh.attach_material(box, "d1/100", references=[ball])
    mesh = coarse_mesh(box)
    document.recompute()
    assert mesh.Status == "ok"
    for change in (lambda: setattr(ball, "Radius", 6), lambda: setattr(ball.Placement, "Base", (1, 0, 0))):
        change()
        document.recompute()
        mesh.touch()
        document.recompute()
        assert "the reference Ball was changed" in mesh.Status
        fgmesh.generate(mesh)
        assert mesh.Status == "ok"
    fgmesh.attach_material(box, "d1/100", references=["Face1"])
    document.recompute()
    assert "other references" in mesh.Status


def test_saved_and_opened(from_end_to_end, tmp_path):
    path = str(tmp_path / "graded.FCStd")
    from_end_to_end.Document.saveCopy(path)
    opened = FreeCAD.openDocument(path)
    try:
        assert value(opened.Box, (3, 4, 15)) == pytest.approx(0.25)
        opened.recompute()
        assert "Touched" not in opened.Box.State
    finally:
        FreeCAD.closeDocument(opened.Name)


def test_a_link_measures_to_its_own_faces(box, document, fgmesh, core):
    """The link of a graded box, moved: the same fractions at the same places of the box."""
    from freecad.fgmesh.model.graded_solid import material_of

    fgmesh.attach_material(box, "d1/(d1 + d2) * s", {"s": 0.5}, references=["Face1", "Face2"])
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = box
    link.Placement = FreeCAD.Placement(
        FreeCAD.Vector(40, 50, 60), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 50)
    )
    document.recompute()
    inside = FreeCAD.Vector(3, 7, 11)
    values = [
        core.read_references(material_of(thing)).evaluate([tuple(thing.Placement.multVec(inside))])[0, 0]
        for thing in (box, link)
    ]
    assert values[0] == pytest.approx(0.15, abs=1e-9) or values[0] == pytest.approx(0.35, abs=1e-9)
    assert values[1] == pytest.approx(values[0], abs=1e-9)
