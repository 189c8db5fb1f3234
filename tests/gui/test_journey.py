# SPDX-License-Identifier: GPL-3.0-or-later
"""A designer's way from an open part to a finished mesh and back, by mouse and keys; the recorded macro replays it."""

JOURNEY = """
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
fresh_view(document)
steps_before = document.UndoCount
recorded = record_macro("way.FCMacro")

select(part)
command("FGMesh_Material")
choose("FGMeshGrading", "Power law along z")
wait_until(lambda: widget("FGMeshFormulaMessage").text().startswith("On the solid"))
panel_button("Ok")
command("FGMesh_Mesh")  # the part is selected still
write("FGMeshMaterialThreshold", "0.2")
write("FGMeshSurfaceDeviation", "0.1 mm")
click("FGMeshStart")
wait_until(lambda: widget("FGMeshStart").isEnabled(), 60)
said = widget("FGMeshRunMessage").text()
picture(f"{pictures}/mesh-panel.png")
panel_button("Close")
stop_recording()

mesh = document.FGMesh
made = dict(status=mesh.Status, tets=mesh.TetCount, threshold=mesh.MaterialThreshold, deviation=mesh.SurfaceDeviation.Value)
"""


def test_from_part_to_mesh_with_undo_redo_save_reopen_and_replay(drive, tmp_path):
    folder = str(tmp_path)
    answer = drive(
        f"folder = {folder!r}\n"
        + JOURNEY
        + """
names = list(document.UndoNames)[: document.UndoCount - steps_before]
document.undo()
undone = [thing.Name for thing in document.Objects], part.Visibility
document.undo()
bare = bool(getattr(part, "FGMFractions", None))
document.redo()
document.redo()
document.recompute()
mesh = document.FGMesh
redone = mesh.Status, mesh.TetCount, mesh.FemMesh.VolumeCount

document.saveAs(folder + "/way.FCStd")
FreeCAD.closeDocument(document.Name)
document = FreeCAD.openDocument(folder + "/way.FCStd")
reopened = document.FGMesh.Status, document.FGMesh.TetCount, document.FGMesh.FemMesh.VolumeCount
FreeCAD.closeDocument(document.Name)

# The recorded lines on a fresh part of the same name.
document = FreeCAD.newDocument("Again")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
macro = open(recorded).read()
exec(compile(macro, recorded, "exec"), {})  # as FreeCAD runs macros
replayed = document.FGMesh.Status, document.FGMesh.TetCount
return dict(said=said, made=made, names=names, undone=undone, bare=bare, redone=redone, reopened=reopened,
            macro=macro, replayed=replayed)
"""
    )
    made = answer["made"]
    assert made["status"] == "ok" and made["tets"] > 500
    assert (made["threshold"], made["deviation"]) == (0.2, 0.1)
    assert f"{made['tets']:,} tetrahedra" in answer["said"]
    assert answer["names"] == ["Mesh graded solid", "Set graded material"]
    assert answer["undone"] == [["Cylinder"], True]
    assert answer["bare"] is False
    assert answer["redone"] == ["ok", made["tets"], made["tets"]]
    assert answer["reopened"] == ["ok", made["tets"], made["tets"]]
    lines = [line for line in answer["macro"].split("\n") if line and not line.startswith("#")]
    assert any("attach_material(" in line for line in lines) and any(
        "generate(mesh)" in line for line in lines
    )
    assert answer["replayed"] == ["ok", made["tets"]]


def test_cancel_is_quick_and_leaves_the_document_as_it_was(drive):
    answer = drive(
        """
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Sphere", "Ball")
part.Radius = 50
document.recompute()
import freecad.fgmesh as fgmesh
fgmesh.attach_material(part, "exp(-0.08*d)")
fresh_view(document)
steps, names = document.UndoCount, [thing.Name for thing in document.Objects]
select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.01")
click("FGMeshStart")
wait_until(lambda: "refinement" in widget("FGMeshLog").toPlainText())
settle(1.0)
# FreeCAD stays usable: something else is done meanwhile.
other = document.addObject("Part::Box", "Meanwhile")
document.recompute()
volume = other.Shape.Volume
document.removeObject(other.Name)
live = [name for name in ("FGMeshStart", "FGMeshCancel", "FGMeshMaterialThreshold") if widget(name).isEnabled()]
picture(f"{pictures}/mesh-running.png")
click("FGMeshCancel")
took = wait_until(lambda: widget("FGMeshStart").isEnabled())
said = widget("FGMeshRunMessage").text()
left = [thing.Name for thing in document.Objects] == names
panel_button("Close")
return dict(took=took, said=said, left=left, volume=volume, live=live)
"""
    )
    assert answer["took"] < 2
    assert answer["said"].startswith("Nothing was changed: the run was cancelled")
    assert answer["left"]
    assert abs(answer["volume"] - 1000) < 1e-9
    assert answer["live"] == ["FGMeshCancel"]


def test_closing_the_panel_or_the_document_ends_the_run(drive):
    answer = drive(
        """
import os, subprocess
import freecad.fgmesh as fgmesh

def children():
    return subprocess.run(["pgrep", "-P", str(os.getpid()), "-f", "fgmesh/worker/__main__.py"], capture_output=True).stdout.split()

def start(name):
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Sphere", "Ball")
    part.Radius = 50
    document.recompute()
    fgmesh.attach_material(part, "exp(-0.08*d)")
    select(part)
    command("FGMesh_Mesh")
    write("FGMeshMaterialThreshold", "0.01")
    click("FGMeshStart")
    wait_until(lambda: "refinement" in widget("FGMeshLog").toPlainText())
    return document

start("First")
panel_button("Close")
settle(0.5)
after_close = len(children())
document = start("Second")
FreeCAD.closeDocument(document.Name)
settle(1.0)
if FreeCADGui.Control.activeDialog():
    click("FGMeshCancel")
    panel_button("Close")
settle(0.5)
return dict(after_close=after_close, after_document=len(children()))
"""
    )
    assert answer["after_close"] == 0
    assert answer["after_document"] == 0


def test_wrong_input_in_every_field_of_the_mesh_panel(drive):
    answer = drive(
        """
import freecad.fgmesh as fgmesh
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
document.recompute()
fgmesh.attach_material(part, "z/10")
select(part)
command("FGMesh_Mesh")
told = {}
for name in ("SurfaceDeviation", "MinSize", "MaxSize"):
    for text in ("much", "-1", "3 kg", "3 mm^2", "nan"):
        write("FGMesh" + name, text)
        settle(0.1)
        told[name + " " + text] = [widget("FGMeshRunMessage").kind, widget("FGMeshRunMessage").text(), widget("FGMeshStart").isEnabled()]
    write("FGMesh" + name, "")
settle(0.1)
good = [widget("FGMeshRunMessage").kind, widget("FGMeshStart").isEnabled()]
write("FGMeshMinSize", "2 cm")
write("FGMeshMaxSize", "1 mm")
settle(0.1)
told["MinSize above MaxSize"] = [widget("FGMeshRunMessage").kind, widget("FGMeshRunMessage").text(), widget("FGMeshStart").isEnabled()]
panel_button("Close")
return dict(told=told, good=good, names=[thing.Name for thing in document.Objects])
"""
    )
    for what, (kind, text, enabled) in answer["told"].items():
        assert kind == "error" and not enabled, what
        assert any(
            word in text.replace("_", "").lower() for word in ("surfacedeviation", "minsize", "maxsize")
        ), text
    assert answer["good"] == ["", True]
    assert answer["names"] == ["Box"]
