# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of a mesh stay: over undo, redo, the report, and saving."""


MESHED = """
import freecad.fgmesh as fgmesh
from freecad.fgmesh.view import mesh_view

def is_coloured(document):
    settle(0.2)
    return getattr(document.FGMesh.ViewObject.Proxy, "look", None) is not None

document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
document.recompute()
fgmesh.attach_material(part, "z/10", constituents=["Steel-Generic", "Aluminum-Generic"])
fresh_view(document)
select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.4")

def mesh_it():
    click("FGMeshStart")
    wait_until(lambda: widget("FGMeshStart").isEnabled() and widget("FGMeshRunMessage").text(), 60)

mesh_it()
seen = {"meshed": is_coloured(document)}
"""


def test_colours_outlast_undo_report_and_saving(drive, tmp_path):
    answer = drive(
        MESHED
        + f"path = {str(tmp_path / 'part.FCStd')!r}\n"
        + """
tets = document.FGMesh.TetCount
write("FGMeshMaterialThreshold", "0.15")
mesh_it()
panel_button("Close")
document.undo()
seen["undone"] = is_coloured(document) and document.FGMesh.TetCount == tets
document.redo()
seen["redone"] = is_coloured(document) and document.FGMesh.TetCount > tets
select(document.FGMesh)
command("FGMesh_Report")
choose("FGMeshLook", "Plain")
seen["plain in the report"] = not is_coloured(document)
panel_button("Close")
seen["report closed"] = is_coloured(document)
document.saveAs(path)
FreeCAD.closeDocument(document.Name)
document = FreeCAD.openDocument(path)
seen["opened"] = is_coloured(document)
picture(f"{pictures}/kept-look.png")
menu = QtGui.QMenu()
document.FGMesh.ViewObject.Proxy.setupContextMenu(document.FGMesh.ViewObject, menu)
(toggle,) = [action for action in menu.actions() if action.isCheckable()]
seen["checked"] = toggle.isChecked()
toggle.trigger()
seen["toggled"] = not is_coloured(document)
document.save()
FreeCAD.closeDocument(document.Name)
document = FreeCAD.openDocument(path)
seen["stays plain"] = not is_coloured(document)
return seen
"""
    )
    answer.pop("output")
    assert [what for what, holds in answer.items() if not holds] == []
