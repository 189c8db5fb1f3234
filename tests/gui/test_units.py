# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths in the user's unit schema: fields read and show what FreeCAD's own fields do."""
import pytest

US_CUSTOMARY = 2
"""FreeCAD's number of the schema."""

BAR = """
import freecad.fgmesh as fgmesh
from freecad.fgmesh.model.options import option_values
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Bar")
part.Length, part.Width, part.Height = "1 in", "1 in", "4 in"
document.recompute()
fresh_view(document)
select(part)
"""


@pytest.fixture
def inches(preferences):
    return preferences(Units={"UserSchema": US_CUSTOMARY, "Decimals": 2})


def test_material_of_a_bar_in_inches(drive, inches):
    answer = drive(
        BAR
        + """
command("FGMesh_Material")
table = widget("FGMeshParameters")
rows = {table.item(row, 0).text(): [table.item(row, column).text() for column in (1, 2)] for row in range(table.rowCount())}
picture(f"{pictures}/inches-material.png")
write("FGMeshFrameOrigin", "0, 1 in, 25.4 mm")
press(widget("FGMeshFrameOrigin"), QtCore.Qt.Key_Tab)
settle(0.2)
shown = widget("FGMeshFrameOrigin").text()
write("FGMeshFormula", "clamp(z/4 in, 0, 1)")
wait_until(lambda: "0 to 0.75" in widget("FGMeshFormulaMessage").text())
said = widget("FGMeshFormulaMessage").text()
panel_button("Ok")
return dict(rows=rows, shown=shown, said=said, origin=list(part.FGMFrame.Base), formula=list(part.FGMFractions))
""",
        settings=inches,
    )
    assert "0 to 0.75" in answer["said"]  # an inch above the lower end
    assert answer["rows"]["length"] == ["4 in", "4 in"]
    assert answer["origin"] == pytest.approx([0, 25.4, 25.4])
    assert answer["shown"].split(", ")[1:] == ["1 in", "1 in"]
    assert answer["formula"] == ["clamp(z/4 in, 0, 1)"]


def test_sizes_of_a_mesh_in_inches(drive, inches):
    answer = drive(
        BAR
        + """
fgmesh.attach_material(part, "z/101.6")
select(part)
command("FGMesh_Mesh")
write("FGMeshMaxSize", "0.25")
write("FGMeshMinSize", "1 mm")
write("FGMeshSurfaceDeviation", "0.002")
press(widget("FGMeshSurfaceDeviation"), QtCore.Qt.Key_Tab)
settle(0.2)
picture(f"{pictures}/inches-mesh.png")
write("FGMeshSurfaceDeviation", "")
press(widget("FGMeshSurfaceDeviation"), QtCore.Qt.Key_Tab)
settle(0.3)
left = widget("FGMeshSurfaceDeviation").text()
click("FGMeshStart")
wait_until(lambda: document.getObject("FGMesh") is not None and widget("FGMeshStart").isEnabled(), 60)
values = option_values(document.FGMesh)
panel_button("Close")
select(document.FGMesh)
command("FGMesh_Mesh")
again = widget("FGMeshMaxSize").text()
from freecad.fgmesh.panels.message_label import MessageLabel
label = MessageLabel()
label.complain("min_size is 25.4 mm, and 3 mm^2 is none")
panel_button("Close")
return dict(values=values, left=left, again=again, message=label.text())
""",
        settings=inches,
    )
    assert answer["values"]["MaxSize"] == pytest.approx(6.35)
    assert answer["values"]["MinSize"] == pytest.approx(1.0)
    assert answer["values"]["SurfaceDeviation"] == 0
    assert answer["left"] == ""
    assert answer["again"].split() in (["0.25", '"'], ["0.25", "in"])
    assert answer["message"] == "min_size is 1 in, and 3 mm^2 is none"
