# SPDX-License-Identifier: GPL-3.0-or-later
"""attach_material: what it puts on a solid, and what it refuses."""
import FreeCAD
import numpy as np
import pytest

TYPES = {
    "FGMConstituents": "App::PropertyStringList",
    "FGMFractions": "App::PropertyStringList",
    "FGMFrame": "App::PropertyPlacement",
    "FGMReferences": "App::PropertyLinkSubListHidden",
    "FGMReferenceNames": "App::PropertyStringList",
    "FGMTables": "App::PropertyStringList",
    "FGM_alpha": "App::PropertyFloat",
}


def fgm_properties(solid):
    return {name for name in solid.PropertiesList if name.startswith("FGM")}


def test_properties(box, fgmesh):
    fgmesh.attach_material(box, ["exp(-alpha*d)"], {"alpha": 0.08}, ["Steel-Generic", "Aluminum-Generic"])
    assert {name: box.getTypeIdOfProperty(name) for name in fgm_properties(box)} == TYPES
    assert {box.getGroupOfProperty(name) for name in TYPES} == {"FGM"}
    assert box.FGMConstituents == ["Steel-Generic", "Aluminum-Generic"]
    assert box.FGMFractions == ["exp(-alpha*d)"]
    assert box.FGM_alpha == 0.08
    assert box.FGMFrame.isIdentity()


def test_attaching_again_replaces(box, fgmesh):
    fgmesh.attach_material(
        box, "exp(-a*d)", {"a": 1.0}, frame=FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation())
    )
    box.setExpression("FGM_a", "2 * 3")
    fgmesh.attach_material(box, "exp(-b*d)", {"b": 2.0})
    assert fgm_properties(box) == TYPES.keys() - {"FGM_alpha"} | {"FGM_b"}
    assert box.FGMFractions == ["exp(-b*d)"]
    assert box.FGMFrame.isIdentity()
    assert not box.ExpressionEngine


def test_a_new_number_wins_over_an_old_expression(box, fgmesh):
    fgmesh.attach_material(box, "exp(-a*d)", {"a": 1.0})
    box.setExpression("FGM_a", "2 * 3")
    fgmesh.attach_material(box, "exp(-a*d)", {"a": 5.0})
    box.Document.recompute()
    assert box.FGM_a == 5.0


def test_material_objects_as_constituents(box, fgmesh):
    steel, copper = (
        box.Document.addObject("App::MaterialObjectPython", name) for name in ("GradedSteel", "GradedCopper")
    )
    fgmesh.attach_material(box, "z/30", constituents=[steel, copper])
    assert box.FGMConstituents == ["GradedSteel", "GradedCopper"]


@pytest.mark.parametrize(
    "arguments, told",
    [
        ({"fractions": "exp(-alpha*d"}, None),
        ({"fractions": "exp(-beta*d)"}, "beta"),
        ({"fractions": "__import__('os').getcwd()"}, None),
        ({"fractions": "z/30", "parameters": {"x": 1.0}}, "x"),
        ({"fractions": "z/30", "parameters": {"a": "many"}}, "many"),
        ({"fractions": "z/30", "constituents": ["Steel-Generic"]}, "constituent"),
        ({"fractions": "z/30", "constituents": ["Steel-Generic", 3]}, "3"),
        ({"fractions": "z/30", "frame": (0, 0, 0)}, "Placement"),
        ({"fractions": "d1/30"}, "none is given"),
        ({"fractions": "d1/30", "references": ["Face9"]}, "Box: the reference Face9 is lost"),
        ({"fractions": "s1/30", "references": ["Face1"]}, "write d1"),
        ({"fractions": "d1/30", "references": [3]}, "3"),
        ({"fractions": "d1/30", "references": [("Box", "Face1")]}, "document"),
        ({"fractions": "t1/30"}, "'t1' is the value of table 1, but none is given"),
        ({"fractions": "t1", "tables": ["z,value\n0,1\n"]}, "table t1: the coordinate z needs samples"),
        ({"fractions": "t1", "tables": ["/no/such.csv"]}, "table t1 .*cannot read the file"),
        ({"fractions": "t1", "tables": "z,value\n0,1\n1,2\n"}, "as a list"),
        ({"fractions": [3]}, "text"),
        ({"fractions": []}, None),
    ],
)
def test_refusals_leave_the_solid_alone(box, fgmesh, core, arguments, told):
    for before in (set(), TYPES.keys()):
        with pytest.raises(core.InvalidInput, match=told):
            fgmesh.attach_material(box, **arguments)
        assert fgm_properties(box) == before
        if not before:
            fgmesh.attach_material(box, "exp(-alpha*d)", {"alpha": 0.08})
    assert box.FGMFractions == ["exp(-alpha*d)"]


def test_things_that_are_no_solid(document, fgmesh, core):
    plane = document.addObject("Part::Plane", "Plane")
    document.recompute()
    with pytest.raises(core.InvalidInput, match="Plane"):
        fgmesh.attach_material(plane, "z/30")
    sheet = document.addObject("Spreadsheet::Sheet", "Cells")
    with pytest.raises(core.InvalidInput, match="Cells"):
        fgmesh.attach_material(sheet, "z/30")


def test_one_undo_step(box, fgmesh):
    box.Document.UndoMode = 1
    fgmesh.attach_material(box, "exp(-a*d)", {"a": 1.0})
    fgmesh.attach_material(box, "exp(-b*d)", {"b": 2.0})
    box.Document.undo()
    assert (box.FGMFractions, box.FGM_a, "FGM_b" in box.PropertiesList) == (["exp(-a*d)"], 1.0, False)
    box.Document.undo()
    assert fgm_properties(box) == set()
    box.Document.redo()
    assert (box.FGMFractions, box.FGM_a) == (["exp(-a*d)"], 1.0)


def test_copies_keep_the_material(graded_box):
    copy = graded_box.Document.copyObject(graded_box)
    assert fgm_properties(copy) == fgm_properties(graded_box)
    assert (copy.FGMFractions, copy.FGM_h) == (["z/h"], 30.0)


def test_parameters_follow_spreadsheet_cells(graded_box):
    from freecad.fgmesh.model.graded_solid import material_of

    sheet = graded_box.Document.addObject("Spreadsheet::Sheet", "Cells")
    sheet.set("A1", "60")
    sheet.setAlias("A1", "height")
    graded_box.Document.recompute()
    graded_box.setExpression("FGM_h", "Cells.height")
    graded_box.Document.recompute()
    top = graded_box.Placement.multVec(FreeCAD.Vector(0, 0, 30))
    assert material_of(graded_box).evaluate(np.array([top])) == pytest.approx(np.array([[0.5, 0.5]]))


def test_the_frame_moves_with_the_solid(box, fgmesh):
    """The frame is given in the solid's own coordinates, the shape lies in the document's."""
    from freecad.fgmesh.model.graded_solid import material_of

    frame = FreeCAD.Placement(FreeCAD.Vector(0, 0, 4), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), -90))
    fgmesh.attach_material(box, "z/20", frame=frame)  # the frame's z is the solid's y
    own = np.random.default_rng(1).uniform((0, 0, 0), (10, 20, 30), (50, 3))
    in_document = np.array([box.Placement.multVec(FreeCAD.Vector(*point)) for point in own])
    assert material_of(box).evaluate(in_document)[:, 0] == pytest.approx(own[:, 1] / 20)
