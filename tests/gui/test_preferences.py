# SPDX-License-Identifier: GPL-3.0-or-later
"""The preference page of the workbench, in FreeCAD's own dialog."""


def test_defaults_are_changed_by_edit_preferences(drive):
    answer = drive(
        """
import freecad.fgmesh as fgmesh
seen = {}

def fill(dialog):
    show_preference_page(dialog, "FGMesh")
    seen["before"] = [widget("MaterialThreshold").value(), widget("SecondOrder").isChecked()]
    seen["special"] = [widget("TimeLimit").text(), widget("MemoryLimit").text()]
    picture(f"{pictures}/preferences.png")
    write("MaterialThreshold", "0.25")
    click("SecondOrder")
    write("TimeLimit", "90")
    click("PreviewAtStart")
    click(dialog_button(dialog, "Ok"))

def look_again(dialog):
    show_preference_page(dialog, "FGMesh")
    seen["stored"] = [widget("MaterialThreshold").value(), widget("SecondOrder").isChecked(), widget("TimeLimit").value()]
    dialog.reject()

in_dialog(lambda: FreeCADGui.runCommand("Std_DlgPreferences"), fill)
in_dialog(lambda: FreeCADGui.runCommand("Std_DlgPreferences"), look_again)

document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
document.recompute()
fgmesh.attach_material(part, "z/10")
select(part)
command("FGMesh_Material")
seen["preview"] = widget("FGMeshPreview").isChecked()
panel_button("Cancel")
select(part)
command("FGMesh_Mesh")
seen["panel"] = [widget("FGMeshMaterialThreshold").value(), widget("FGMeshSecondOrder").isChecked()]
panel_button("Close")
return seen
"""
    )
    assert answer["before"] == [0.1, False]
    assert answer["special"] == ["none", "nine tenths of what is free"]
    assert answer["stored"] == [0.25, True, 90]
    assert answer["preview"] is False
    assert answer["panel"] == [0.25, True]
    assert "Cannot find icon" not in answer["output"]
