# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/, taken on the way that docs/workbench.md walks. scripts/update-pictures puts them there."""
import numpy as np
import pytest

WIDTH, HEIGHT = 1280, 1000

WALK = """
import FreeCAD as App
import Part

def pipe(outer, inner, low, high):
    return Part.makeCylinder(outer, high - low, App.Vector(0, 0, low)).cut(Part.makeCylinder(inner, high - low, App.Vector(0, 0, low)))

def take(name):
    picture(f"{folder}/{name}.png")

document = FreeCAD.newDocument("Nozzle")
part = document.addObject("Part::Feature", "Nozzle")
neck = Part.makeCone(20, 32, 40, App.Vector(0, 0, 8)).cut(Part.makeCone(12, 26, 40, App.Vector(0, 0, 8)))
shape = pipe(44, 12, 0, 8).fuse(neck)
for turn in range(6):
    hole = Part.makeCylinder(4, 8, App.Vector(34, 0, 0))
    hole.rotate(App.Vector(), App.Vector(0, 0, 1), 60 * turn)
    shape = shape.cut(hole)
part.Shape = shape.removeSplitter()
document.recompute()
fresh_view(document)
select(part)
open_menu("FGMesh")
take("menu")
close_menus()

command("FGMesh_Material")
write("FGMeshConstituent1", "Steel-Generic")
write("FGMeshConstituent2", "Aluminum-Generic")
choose("FGMeshGrading", "Power law along z")
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
fresh_view(document)
take("material")
write("FGMeshFormula", "clamp((z - start)/height, 0, 1)^n")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
take("material-error")
write("FGMeshFormula", "clamp((z - start)/length, 0, 1)^n")
wait_until(lambda: widget("FGMeshFormulaMessage").text() == "On the solid: 0 to 1")
panel_button("Ok")

select(part)
command("FGMesh_Preview")
choose("FGMeshQuantity", "Young's modulus")
choose("FGMeshSectionAxis", "Y")
fresh_view(document)
take("preview")
panel_button("Close")

select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.1")
click("FGMeshStart")
wait_until(lambda: document.getObject("FGMesh") is not None and widget("FGMeshStart").isEnabled(), 120)
fresh_view(document)
estimated = wait_for_text("FGMeshExpectation", "tetrahedra", 5)
scroll_to_top("FGMeshStart")
take("mesh")
click("FGMeshOpenReport")
wait_until(lambda: is_shown("FGMeshStages"))
choose("FGMeshCutAxis", "Y")
fresh_view(document)
scroll_to_top("FGMeshStages")
take("report")
choose("FGMeshLook", "Smallest angles")
take("worst")
panel_button("Close")

select(document.FGMesh)
command("FGMesh_Analysis")
write("FGMeshAllowedError", "1")
wait_for_text("FGMeshAnalysisMessage", "Materials:", 20)
write("FGMeshYoungsModulusLaw", "mori_tanaka")
settle(1)
wait_for_text("FGMeshAnalysisMessage", "Materials:", 20)
fresh_view(document)
take("analysis")
panel_button("Cancel")
return dict(status=document.FGMesh.Status)
"""

DIALOGS = """
from PySide import QtGui
def take(name):
    picture(f"{folder}/{name}.png")

def choose_bracket(dialog):
    dialog.setTextValue(dialog.comboBoxItems()[2])
    dialog.accept()

def show_list(dialog):
    (box,) = [one for one in widgets_inside(dialog) if isinstance(one, QtGui.QComboBox)]
    box.showPopup()
    take("examples")
    close_menus()
    dialog.reject()

def preferences(dialog):
    dialog.resize(900, 520)
    show_preference_page(dialog, "FGMesh")
    picture_of(dialog, f"{folder}/preferences.png")
    dialog.reject()

in_dialog(lambda: command("FGMesh_Examples"), choose_bracket)
opened = FreeCAD.ActiveDocument.Name
in_dialog(lambda: command("FGMesh_Examples"), show_list)
FreeCAD.closeDocument(opened)
in_dialog(lambda: FreeCADGui.runCommand("Std_DlgPreferences"), preferences)
return dict(opened=opened)
"""


@pytest.fixture
def folder(artifacts):
    """Where scripts/update-pictures looks for them."""
    path = artifacts / "pictures"
    path.mkdir(exist_ok=True)
    return path


def pixels_of(path):
    from matplotlib import image

    assert path.exists(), path.name
    return (image.imread(path)[:, :, :3] * 255).astype(int)


def check_window(path, has_panel=True):
    """A FreeCAD window with a panel at the left, where one is open, and something coloured in its 3D view."""
    pixels = pixels_of(path)
    assert pixels.shape == (HEIGHT, WIDTH, 3)
    panel, view = pixels[150:700, 10:240], pixels[150:700, 480:1150]
    assert not has_panel or panel.std() > 20, f"{path.name}: no panel"
    assert len(np.unique(view.reshape(-1, 3), axis=0)) > 100, f"{path.name}: an empty view"
    # The usual background is blue to grey: the rest is what is shown.
    assert (np.abs(view - view[:1, :1]).max(axis=2) > 60).mean() > 0.1, f"{path.name}: an empty view"


def test_the_way_from_part_to_report(drive, folder):
    answer = drive(f"folder = {str(folder)!r}\n" + WALK, screen=f"{WIDTH}x{HEIGHT}x24")
    assert answer["status"] == "ok"
    for name in ("menu", "material", "material-error", "preview", "mesh", "report", "worst", "analysis"):
        check_window(folder / f"{name}.png", has_panel=name != "menu")


def test_dialogs(drive, folder):
    answer = drive(f"folder = {str(folder)!r}\n" + DIALOGS, screen=f"{WIDTH}x{HEIGHT}x24")
    assert answer["opened"] == "FaceToFace"
    check_window(folder / "examples.png", has_panel=False)
    height, width, _ = pixels_of(folder / "preferences.png").shape
    assert 500 < width < WIDTH and 300 < height < HEIGHT
