# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of a graded material, used with mouse and keys."""
import re

CYLINDER = """
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
fresh_view(document)
select(part)
steps_before = document.UndoCount
"""


def test_ready_grading_becomes_the_material_in_one_undo_step(drive):
    answer = drive(
        CYLINDER
        + """
command("FGMesh_Material")
write("FGMeshConstituent1", "Steel-Generic")
write("FGMeshConstituent2", "Aluminum-Generic")
choose("FGMeshGrading", "Power law along z")
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
picture(f"{pictures}/material-panel.png")
unchanged = document.UndoCount - steps_before, hasattr(part, "FGMFractions")
panel_button("Ok")
given = [list(part.FGMFractions), list(part.FGMConstituents), part.FGM_length, part.FGM_n, part.FGM_start]
undo = document.UndoCount - steps_before, list(document.UndoNames)[:1]
document.undo()
undone = hasattr(part, "FGMFractions") and bool(part.FGMFractions)
document.redo()
return dict(unchanged=unchanged, given=given, undo=undo, undone=undone, again=list(part.FGMFractions))
"""
    )
    assert answer["unchanged"] == [0, False]
    assert answer["given"][0] == ["clamp((z - start)/length, 0, 1)^n"]
    assert answer["given"][1] == ["Steel-Generic", "Aluminum-Generic"]
    assert answer["given"][2:] == [60, 2, 0]
    assert answer["undo"] == [1, ["Set graded material"]]
    assert answer["undone"] is False
    assert answer["again"] == answer["given"][0]


def test_a_solid_without_material_begins_with_a_linear_grading_and_keeps_no_parameter_unused(drive):
    answer = drive(
        CYLINDER
        + """
command("FGMesh_Material")
shown = widget("FGMeshFormula").formula(), widget("FGMeshGrading").currentText()
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
panel_button("Ok")
ready = list(part.FGMFractions), part.FGM_start, part.FGM_length
document.undo()
command("FGMesh_Material")
write("FGMeshFormula", "z/length")
panel_button("Ok")
return dict(shown=shown, ready=ready, names=[name for name in part.PropertiesList if name.startswith("FGM_")])
"""
    )
    assert answer["shown"] == ["clamp((z - start)/length, 0, 1)", "Linear along z"]
    assert answer["ready"] == [[answer["shown"][0]], 0, 60]
    assert answer["names"] == ["FGM_length"]


def test_errors_are_marked_at_their_place_and_unknown_names_become_parameters(drive):
    answer = drive(
        CYLINDER
        + """
command("FGMesh_Material")
write("FGMeshFormula", "exp(-alpha*z)")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
marked = widget("FGMeshFormula").marked()
picture(f"{pictures}/material-error.png")
click("FGMeshMakeParameter")
write_cell("FGMeshParameters", 2, 1, "3/Height")
says = "On the solid: 0.04979 to 1"
wait_until(lambda: widget("FGMeshFormulaMessage").text() == says)
write("FGMeshFormula", "2*exp(-alpha*z)")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "warning")
warns = widget("FGMeshFormulaMessage").text()
write("FGMeshFormula", "exp(-alpha*z")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
panel_button("Ok")
refused = FreeCADGui.Control.activeDialog() is not False, hasattr(part, "FGMFractions"), document.UndoCount - steps_before
write("FGMeshFormula", "exp(-alpha*z)")
panel_button("Ok")
part.Height = 30
document.recompute()
return dict(marked=marked, warns=warns, refused=refused, alpha=part.FGM_alpha)
"""
    )
    assert answer["marked"] == "alpha"
    assert answer["warns"].startswith("On the solid: 0.09957 to 2") and "between 0 and 1" in answer["warns"]
    assert answer["refused"] == [True, False, 0]
    assert abs(answer["alpha"] - 0.1) < 1e-12


WRONG = {
    "FGMeshFormula": {
        "": "Write a formula",
        "z/": "formula",
        "z/60)": "closes nothing",
        "z + wall": "unknown name 'wall'",
        "d3": "d3",
        "exp": "exp",
        "sqrt(-1)": "not defined",
        "(" * 300 + "z" + ")" * 300: "deep",
        "z/60 # ; import os": "formula",
        "z²": "formula",
        "2": "between 0 and 1",
    },
    "FGMeshFrameOrigin": {"1, 2": "three numbers", "a, b, c": "three numbers", "nan, 0, 0": "three numbers"},
    "FGMeshFrameAxis": {"0, 0, 0": "three zeros", "up": "three numbers", "inf, 0, 1": "three numbers"},
    "value": {
        "": "has no value",
        "many": "neither a number",
        "Height +": "neither",
        "1e999": "finite",
    },
    "name": {
        "": "no name",
        "x": "'x'",
        "exp": "'exp'",
        "my length": "my length",
        "other": "Two parameters",
        "d1": "d1",
    },
}
"""Field: {what is written: part of what must be said}."""


def test_wrong_input_in_every_field_of_the_material_panel(drive):
    answer = drive(
        CYLINDER
        + f"WRONG = {WRONG!r}\n"
        + """
command("FGMesh_Material")
write("FGMeshFormula", "z/length")
click("FGMeshAddParameter")
write_cell("FGMeshParameters", 2, 0, "other")
told = {}

def look(key):
    settle(0.25)
    message = widget("FGMeshFormulaMessage")
    said = [message.kind, message.text()]
    if message.kind == "error":
        panel_button("Ok")
        said.append(FreeCADGui.Control.activeDialog() is not False and document.UndoCount == steps_before)
        assert said[-1], (key, said)
    told[key] = said

def write_frame(name, text):
    write(name, text)
    press(widget(name), QtCore.Qt.Key_Tab)

for text in WRONG["FGMeshFormula"]:
    write("FGMeshFormula", text)
    look("FGMeshFormula/" + text)
write("FGMeshFormula", "z/length")
kept = {}
for name, good in (("FGMeshFrameOrigin", "0, 0, 0"), ("FGMeshFrameAxis", "0, 0, 1")):
    for text in WRONG[name]:
        write_frame(name, text)
        look(name + "/" + text)
        kept[name + "/" + text] = widget(name).text()
    write_frame(name, good)
for column, field, good in ((1, "value", "60"), (0, "name", "length")):
    for text in WRONG[field]:
        write_cell("FGMeshParameters", 1, column, text)
        look(field + "/" + text)
        kept[field + "/" + text] = widget("FGMeshParameters").item(1, column).text()
    write_cell("FGMeshParameters", 1, column, good)
write("FGMeshConstituent1", "Steel-Generic")
settle(0.2)
panel_button("Ok")
lacking = widget("FGMeshFormulaMessage").kind, widget("FGMeshFormulaMessage").text()
write("FGMeshConstituent2", "Unobtainium")
settle(0.2)
unknown = widget("FGMeshConstituentNote").isVisible(), widget("FGMeshConstituentNote").text()
write("FGMeshConstituent2", "Aluminum-Generic")
settle(0.2)
good = widget("FGMeshFormulaMessage").text()
panel_button("Ok")
return dict(told=told, kept=kept, lacking=lacking, unknown=unknown, good=good, fractions=list(part.FGMFractions), rows=part.FGM_length)
"""
    )
    wrong = []
    for field, texts in WRONG.items():
        for text, part in texts.items():
            key = f"{field}/{text}"
            kind, said, *refused = answer["told"][key]
            wrong += [(key[:80], said)] if part not in said else []
            assert kind == (
                "" if text == "" and "Formula" in field else "warning" if text == "2" else "error"
            ), (key[:80], said)
            assert refused in ([], [True]), key[:80]
    assert not wrong
    assert answer["kept"] == {key: key.split("/", 1)[1] for key in answer["kept"]}
    assert answer["lacking"] == ["error", "Constituent 2 has no material: choose one, or clear the others"]
    assert answer["unknown"][0] and "Unobtainium" in answer["unknown"][1]
    assert answer["good"] == "On the solid: 0 to 1"
    assert answer["fractions"] == ["z/length"] and answer["rows"] == 60


def test_cancel_leaves_nothing_behind(drive):
    answer = drive(
        CYLINDER
        + """
from pivy import coin  # which knows the class of the scene
gui = FreeCADGui.getDocument(document.Name)
nodes = gui.activeView().getSceneGraph().getNumChildren()
document.saveAs(pictures + "/cancelled.FCStd")
FreeCADGui.SendMsgToActiveView("Save")  # which, other than saveAs, counts as saved in the GUI
assert not gui.Modified
command("FGMesh_Material")
choose("FGMeshGrading", "Radial")
choose("FGMeshSectionAxis", "Y")
settle(0.5)
panel_button("Cancel")
left = gui.activeView().getSceneGraph().getNumChildren() - nodes
names = [name for name in part.PropertiesList if name.startswith("FGM")]
return dict(left=left, names=names, steps=document.UndoCount - steps_before, modified=gui.Modified)
"""
    )
    del answer["output"]
    assert answer == {"left": 0, "names": [], "steps": 0, "modified": False}


def test_three_constituents_by_mouse(drive):
    answer = drive(
        CYLINDER
        + """
command("FGMesh_Material")
for number, name in enumerate(("Steel-Generic", "Aluminum-Generic"), 1):
    write(f"FGMeshConstituent{number}", name)
write("FGMeshFormula", "0.5*z/length")
click("FGMeshAddConstituent")
write("FGMeshConstituent3", "Copper-Generic")
wait_until(lambda: widget("FGMeshFormulaMessage").text().startswith("Write a formula"))
choose("FGMeshGrading", "Radial")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "warning")
warns = widget("FGMeshFormulaMessage").text()
write("FGMeshFormula2", "0.5*r/radius2 + w")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
marked = widget("FGMeshFormula").marked(), widget("FGMeshFormula2").marked()
write("FGMeshFormula2", "0.5*r/radius2")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "")
says = widget("FGMeshFormulaMessage").text()
shown = [widget("FGMeshQuantity").itemText(row) for row in range(3)]
choose("FGMeshQuantity", "fraction of Copper-Generic")
picture(f"{pictures}/material-three.png")
panel_button("Ok")
given = list(part.FGMFractions), list(part.FGMConstituents), part.FGM_length, part.FGM_radius2
command("FGMesh_Material")
again = [widget(name).formula() for name in ("FGMeshFormula", "FGMeshFormula2")]
click("FGMeshRemoveConstituent")
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 0.5")
left = widget("FGMeshConstituent2").currentText(), widget("FGMeshRemoveConstituent").isEnabled()
panel_button("Cancel")
select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.2")
click("FGMeshStart")
wait_until(lambda: document.getObject("FGMesh") is not None and widget("FGMeshStart").isEnabled(), 120)
click("FGMeshOpenReport")
wait_until(lambda: is_shown("FGMeshStages"))
looks = [widget("FGMeshLook").itemText(row) for row in range(widget("FGMeshLook").count())]
choose("FGMeshLook", "fraction of Copper-Generic")
picture(f"{pictures}/report-three.png")
choose("FGMeshLook", "Largest variation")
panel_button("Close")
return dict(warns=warns, marked=marked, says=says, shown=shown, given=given, again=again, left=left, looks=looks,
            status=document.FGMesh.Status)
"""
    )
    names = ["Steel-Generic", "Aluminum-Generic", "Copper-Generic"]
    # Nothing says how near to the axis the samples come.
    number = r"[\d.]+"
    expected = rf"On the solid: 0 to 0.5, {number} to 1, -0.5 to {number}; a volume fraction must stay .*"
    assert re.fullmatch(expected, answer["warns"])
    assert answer["marked"] == ["", "w"]
    assert re.fullmatch(rf"On the solid: 0 to 0.5, {number} to 0.5, 0 to {number}", answer["says"])
    assert answer["shown"] == [f"fraction of {name}" for name in names]
    assert answer["given"] == [["0.5*z/length", "0.5*r/radius2"], names, 60, 20]
    assert answer["again"] == answer["given"][0]
    assert answer["left"] == ["Aluminum-Generic", False]
    assert answer["looks"] == [*answer["shown"], "Plain", "Smallest angles", "Largest variation"]
    assert answer["status"] == "ok"


def test_tables_are_chosen_from_files_and_stay_without_them(drive, tmp_path):
    """Added, wrong, removed and added again by the mouse; the macro replays after the files are gone."""
    (tmp_path / "depth.csv").write_text("z, value\n0, 0.1\n20, 0.2\n60, 0.7\n")
    (tmp_path / "ring.csv").write_text("r;z;value\n0;0;0.1\n0;60;0.1\n20;0;0\n20;60;0.3\n")
    (tmp_path / "wrong.csv").write_text("z, value\n0, 0.1\n0, 0.7\n")
    answer = drive(
        CYLINDER
        + f"""
folder = {str(tmp_path)!r}
def add_table(name):
    def fill(dialog):
        write(_inside(dialog, "fileNameEdit"), f"{{folder}}/{{name}}")
        press(_inside(dialog, "fileNameEdit"), QtCore.Qt.Key_Return)
    in_dialog(lambda: click("FGMeshAddTable"), fill)
def rows():
    return [widget("FGMeshTables").item(row).text() for row in range(widget("FGMeshTables").count())]
def says():
    return widget("FGMeshFormulaMessage").text()
from driver import _inside
from PySide import QtCore
import os
macro = record_macro("tables.FCMacro")
command("FGMesh_Material")
write("FGMeshConstituent1", "Steel-Generic")
write("FGMeshConstituent2", "Aluminum-Generic")
write("FGMeshFormula", "t1")
missing = says()
add_table("depth.csv")
wait_until(lambda: says() == "On the solid: 0.1 to 0.7")
add_table("ring.csv")
write("FGMeshFormula", "t1 + t2")
wait_until(lambda: says().startswith("On the solid: 0.1 to"))
both = rows(), says()
add_table("wrong.csv")
wrong = says(), len(rows())
picture(f"{{pictures}}/material-tables.png")
widget("FGMeshTables").setCurrentRow(0)
click("FGMeshRemoveTable")
wait_until(lambda: "value of table 2" in says())
left = rows()
write("FGMeshFormula", "t1")
wait_until(lambda: says() == "On the solid: 0 to 0.3")
panel_button("Ok")
stop_recording()
given = list(part.FGMTables), list(part.FGMFractions)
for name in ("depth.csv", "ring.csv", "wrong.csv"):
    os.remove(f"{{folder}}/{{name}}")
command("FGMesh_Material")
again = rows()
wait_until(lambda: says() == "On the solid: 0 to 0.3")
panel_button("Cancel")
document.undo()
undone = hasattr(part, "FGMTables")
with open(macro, encoding="utf-8") as file:
    exec(file.read())
replayed = list(part.FGMTables)
return dict(missing=missing, both=both, wrong=wrong, left=left, given=given, again=again, undone=undone, replayed=replayed)
"""
    )
    assert "'t1' is the value of table 1, but none is given" in answer["missing"]
    assert answer["both"][0] == [
        "t1   depth.csv: z (3), 0.1 to 0.7",
        "t2   ring.csv: r × z (2 × 2), 0 to 0.3",
    ]
    assert (
        "wrong.csv" in answer["wrong"][0] and "line 3: z = 0 stands in line 2 already" in answer["wrong"][0]
    )
    assert answer["wrong"][1] == 2
    assert answer["left"] == ["t1   ring.csv: r × z (2 × 2), 0 to 0.3"]
    ring = "r;z;value\n0;0;0.1\n0;60;0.1\n20;0;0\n20;60;0.3\n"
    assert answer["given"] == [[ring], ["t1"]]
    assert answer["again"] == ["t1   r × z (2 × 2), 0 to 0.3"]
    assert answer["undone"] is False
    assert answer["replayed"] == [ring]
