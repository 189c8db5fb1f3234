# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies, placed parts, compounds, links and deleted things, met with the mouse."""


def test_a_body_in_a_placed_part_is_graded_by_clicking_on_it(drive):
    answer = drive(
        """
said = []
document = FreeCAD.newDocument("Part")
container = document.addObject("App::Part", "Assembly")
container.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
body = document.addObject("PartDesign::Body", "Body")
container.addObject(body)
box = body.newObject("PartDesign::AdditiveBox", "Block")
box.Length, box.Width, box.Height = 10, 20, 30
body.Placement.Base = FreeCAD.Vector(0, 0, 50)
document.recompute()
view = fresh_view(document)

def seen(x, y, z):
    return container.Placement.multiply(body.Placement).multVec(FreeCAD.Vector(x, y, z))

click_view(view, seen(5, 10, 30))
clicked = [thing.Name for thing in FreeCADGui.Selection.getSelection()]
command("FGMesh_Material")
click("FGMeshPickFrame")
click_view(view, seen(5, 10, 30))
wait_until(lambda: not widget("FGMeshPickFrame").isChecked())
frame = widget("FGMeshFrameOrigin").text(), widget("FGMeshFrameAxis").text()
write("FGMeshFormula", "-z/30")
wait_until(lambda: widget("FGMeshFormulaMessage").text().startswith("On the solid"))
says = widget("FGMeshFormulaMessage").text()
picture(f"{pictures}/body-in-part.png")
panel_button("Ok")
select(body)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.3")
click("FGMeshStart")
wait_until(lambda: widget("FGMeshStart").isEnabled(), 60)
panel_button("Close")
mesh = document.FGMesh
inside = mesh in container.Group
picture(f"{pictures}/mesh-in-part.png")
container.Placement.Base = FreeCAD.Vector(0, 0, 0)
document.recompute()
moved = mesh.Status
box.Height = 31
document.recompute()
changed = mesh.Status
document.removeObject(container.Name)
body.removeObjectsFromDocument()
document.removeObject("Body")
document.recompute()
gone = document.FGMesh.Status
select(document.FGMesh)
in_dialog(lambda: FreeCADGui.runCommand("FGMesh_Mesh"), lambda dialog: (said.append(dialog.text()), dialog.accept()))
return dict(clicked=clicked, frame=frame, says=says, inside=inside, moved=moved, changed=changed, gone=gone, said=said)
"""
    )
    assert answer["clicked"] in (["Body"], ["Block"], ["Assembly"])
    assert answer["frame"] == ["5, 10, 30", "0, 0, 1"]
    assert answer["says"] == "On the solid: 0 to 1"
    assert answer["inside"]
    assert answer["moved"] == "ok"
    assert answer["changed"].startswith("out of date: the solid has another shape")
    assert answer["gone"] == "out of date: the solid is gone"
    assert len(answer["said"]) == 1 and "lost its solid" in answer["said"][0]


def test_from_face_to_face_by_two_clicks(drive):
    answer = drive(
        """
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
part.Length, part.Width, part.Height = 10, 20, 30
document.recompute()
view = fresh_view(document)
select(part)
command("FGMesh_Material")
choose("FGMeshGrading", "From face A to face B")
click_view(view, FreeCAD.Vector(5, 10, 30))
wait_until(lambda: widget("FGMeshAddReference").text() == "Click on d2 ...")
view.viewBottom()
view.fitAll()
settle(0.5)
click_view(view, FreeCAD.Vector(5, 10, 0))
wait_until(lambda: widget("FGMeshFormulaMessage").text().startswith("On the solid"))
says = widget("FGMeshFormulaMessage").text()
view.viewIsometric()
picture(f"{pictures}/face-to-face.png")
write("FGMeshFormula", "(d1/(d1+d2))^2")
wait_until(lambda: widget("FGMeshFormulaMessage").text().startswith("On the solid"))
panel_button("Ok")
return dict(says=says, references=list(part.FGMReferenceNames), formula=list(part.FGMFractions))
"""
    )
    assert answer["says"] == "On the solid: 0 to 1"
    assert answer["references"] == ["Box.Face6", "Box.Face5"]
    assert answer["formula"] == ["(d1/(d1+d2))^2"]


def test_spreadsheet_copy_link_and_fragments(drive):
    answer = drive(
        """
import freecad.fgmesh as fgmesh

def meshed(thing, threshold="0.3"):
    present = set(document.Objects)
    select(thing)
    command("FGMesh_Mesh")
    write("FGMeshMaterialThreshold", threshold)
    click("FGMeshStart")
    wait_until(lambda: widget("FGMeshStart").isEnabled(), 60)
    said = widget("FGMeshRunMessage").text()
    panel_button("Close")
    new = [one for one in document.Objects if one not in present]
    return new[0] if new else said

document = FreeCAD.newDocument("Part")
sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
sheet.set("A1", "30")
sheet.setAlias("A1", "height")
box = document.addObject("Part::Box", "Box")
box.Length, box.Width, box.Height = 10, 20, 30
document.recompute()
fresh_view(document)
select(box)
command("FGMesh_Material")
write("FGMeshFormula", "z/h")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
click("FGMeshMakeParameter")
write_cell("FGMeshParameters", 2, 1, "Sheet.height")
panel_button("Ok")
mesh = meshed(box)
first = mesh.Status
sheet.set("A1", "31")
document.recompute()
stale = mesh.Status
again = meshed(mesh)
fresh = mesh.Status

copy = document.copyObject(box, False)
link = document.addObject("App::Link", "Link")
link.LinkedObject = box
link.Placement.Base = FreeCAD.Vector(50, 0, 0)
document.recompute()
of_copy = meshed(copy).Status
of_link = meshed(link)
linked = [of_link.Status, min(node.x for node in of_link.FemMesh.Nodes.values())]

other = document.addObject("Part::Box", "Other")
other.Length, other.Width, other.Height = 10, 20, 30
other.Placement.Base = FreeCAD.Vector(5, 0, 0)
document.recompute()
fgmesh.attach_material(other, "1 - z/h", {"h": 30})
from BOPTools import SplitFeatures
fragments = SplitFeatures.makeBooleanFragments(name="Fragments")
fragments.Objects = [box, other]
document.recompute()
of_fragments = meshed(fragments, "0.5")
groups = sorted(name for name in (of_fragments.FemMesh.getGroupName(number) for number in of_fragments.FemMesh.Groups) if name.startswith("Solid") and "Nodes" not in name)
return dict(first=first, stale=stale, fresh=fresh, of_copy=of_copy, linked=linked, fragments=of_fragments.Status, groups=groups)
"""
    )
    assert answer["first"] == "ok"
    assert answer["stale"] == "out of date: FGM_h was 30, is 31"
    assert answer["fresh"] == "ok"
    assert answer["of_copy"] == "ok"
    assert answer["linked"][0] == "ok" and abs(answer["linked"][1] - 50) < 1e-9
    assert answer["fragments"] == "ok"
    assert answer["groups"] == ["Solid1", "Solid2", "Solid3"]
