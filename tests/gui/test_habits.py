# SPDX-License-Identifier: GPL-3.0-or-later
"""What users do before they know the workbench: other orders of clicks, names of their own."""

CYLINDER = """
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
fresh_view(document)
select(part)
"""

ANSWER = """
from PySide import QtCore, QtGui

def answer_question(button):
    def look():
        for box in QtGui.QApplication.topLevelWidgets():
            if isinstance(box, QtGui.QMessageBox) and box.isVisible():
                asked.append(box.text())
                return box.button(button).click()
        QtCore.QTimer.singleShot(50, look)

    QtCore.QTimer.singleShot(50, look)

asked = []
"""


def test_meshing_a_solid_without_a_material_offers_one(drive):
    answer = drive(
        CYLINDER
        + ANSWER
        + """
answer_question(QtGui.QMessageBox.No)
command("FGMesh_Mesh")
declined = bool(FreeCADGui.Control.activeDialog())
select(part)
answer_question(QtGui.QMessageBox.Yes)
command("FGMesh_Mesh")
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
panel_button("Ok")
command("FGMesh_Mesh")
opened = widget("FGMeshStart") is not None
panel_button("Close")
return dict(asked=asked, declined=declined, fractions=list(part.FGMFractions), opened=opened)
"""
    )
    assert answer["asked"] == ["Cylinder has no graded material yet. Give it one now?"] * 2
    assert answer["declined"] is False and answer["opened"]
    assert answer["fractions"] == ["clamp((z - start)/length, 0, 1)"]


def test_selection_is_kept_for_the_next_command(drive):
    answer = drive(
        CYLINDER
        + """
import freecad.fgmesh as fgmesh
fgmesh.attach_material(part, "z/60")
selected = []
for name in ("FGMesh_Preview", "FGMesh_Mesh"):
    command(name)
    panel_button("Close")
    selected.append([thing.Name for thing in FreeCADGui.Selection.getSelection()])
command("FGMesh_Material")
panel_button("Cancel")
selected.append([thing.Name for thing in FreeCADGui.Selection.getSelection()])
return dict(selected=selected)
"""
    )
    assert answer["selected"] == [["Cylinder"]] * 3


def test_constituents_of_ones_own_and_of_the_document(drive):
    answer = drive(
        CYLINDER
        + """
import ObjectsFem
own = ObjectsFem.makeMaterialSolid(document, "Mixture")
own.Label = "Zirconia, third batch"
of_a_bin = ObjectsFem.makeMaterialSolid(document, "GradedMaterial_Bin0001")
of_a_bin.Material = {"Name": "GradedMaterial_Bin0001", "Father": "FGMesh"}
command("FGMesh_Material")
box = widget("FGMeshConstituent1")
offered = [box.itemText(row) for row in range(box.count())]
choose("FGMeshConstituent1", "Zirconia, third batch")
write("FGMeshConstituent2", "Alumina")
note = widget("FGMeshConstituentNote").text()
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
panel_button("Ok")
given = list(part.FGMConstituents)
command("FGMesh_Material")
shown = widget("FGMeshConstituent1").currentText()
panel_button("Cancel")
return dict(offered=offered, note=note, given=given, shown=shown)
"""
    )
    assert "Zirconia, third batch" in answer["offered"]
    assert not any("Bin0001" in text or text == "Mixture" for text in answer["offered"])
    assert "called Alumina: a mesh needs none, an analysis does" in answer["note"]
    assert answer["given"] == ["Mixture", "Alumina"]
    assert answer["shown"] == "Zirconia, third batch"
