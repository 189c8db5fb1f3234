# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that would take long is warned of, and what helps is a click away."""


def test_too_many_tetrahedra_come_with_remedies(drive):
    answer = drive(
        """
import freecad.fgmesh as fgmesh
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
document.recompute()
fgmesh.attach_material(part, "z/10")
fresh_view(document)
select(part)
command("FGMesh_Mesh")

def buttons():
    names = [one.objectName() for one in FreeCADGui.getMainWindow().findChildren(QtGui.QPushButton)]
    return [name[len("FGMeshRemedy"):] for name in names if name.startswith("FGMeshRemedy")]

wait_until(lambda: "tetrahedra" in widget("FGMeshExpectation").text(), 60)
few = [widget("FGMeshExpectation").kind, buttons(), widget("FGMeshMaxSize").text()]
write("FGMeshMaterialThreshold", "0.01")
wait_until(lambda: "takes about" in widget("FGMeshExpectation").text(), 60)
wait_until(lambda: {"MaterialThreshold", "Anisotropy"} <= set(buttons()), 60)
settle(1)
picture(f"{pictures}/remedies.png")
many = [widget("FGMeshExpectation").kind, widget("FGMeshExpectation").text(), buttons()]
click("FGMeshRemedyMaterialThreshold")
wait_until(lambda: "tetrahedra" in widget("FGMeshExpectation").text(), 60)
after = [widget("FGMeshMaterialThreshold").value(), widget("FGMeshExpectation").kind]
panel_button("Close")
return dict(few=few, many=many, after=after)
"""
    )
    assert answer["few"] == ["", [], ""]  # and the size is automatic
    kind, text, offered = answer["many"]
    assert kind == "warning" and (" min" in text or " h" in text)
    assert "MaterialThreshold" in offered and "Anisotropy" in offered
    assert answer["after"] == [0.03, ""]
