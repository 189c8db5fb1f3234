# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD with its GUI, as a user starts it: the workbench is there, shows meshes, and stays alive while meshing."""
import numpy as np
import pytest


@pytest.fixture
def saved_document(tmp_path, coarse_mesh):
    """A document with a meshed box that was saved without a GUI."""
    import FreeCAD

    import freecad.fgmesh as fgmesh

    document = FreeCAD.newDocument("Part")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    coarse_mesh(fgmesh.attach_material(box, "z/10"))
    path = str(tmp_path / "part.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    return path


def test_commands_are_active_where_they_make_sense(drive, saved_document):
    answer = drive(
        f"""
names = ["FGMesh_Material", "FGMesh_Preview", "FGMesh_Mesh", "FGMesh_Report", "FGMesh_Analysis", "FGMesh_Examples"]

def active():
    return [FreeCADGui.Command.get(name).isActive() for name in names]

found = dict(listed="FGMeshWorkbench" in FreeCADGui.listWorkbenches(), active=FreeCADGui.activeWorkbench().name())
found["no_document"] = active()
document = FreeCAD.openDocument({saved_document!r})
plain = document.addObject("Part::Box", "Plain")
document.recompute()
FreeCADGui.Selection.clearSelection()
found["nothing"] = active()
for thing in (document.Box, plain, document.FGMesh):
    select(thing)
    found[thing.Name] = active()
select(document.Box)
FreeCADGui.Selection.addSelection(plain)
found["both"] = active()
found["icons"] = [FreeCADGui.Command.get(name).getInfo()["pixmap"] for name in names]
return found
"""
    )
    assert answer["listed"] and answer["active"] == "FGMeshWorkbench"
    assert answer["no_document"] == [False, False, False, False, False, True]
    assert answer["nothing"] == [False, False, False, False, False, True]
    assert answer["Box"] == [True, True, True, False, False, True]
    assert answer["Plain"] == [True, True, True, False, False, True]
    assert answer["FGMesh"] == [False, False, True, True, True, True]
    assert answer["both"] == [True, False, False, False, False, True]
    assert len(set(answer["icons"])) == 6


def test_documents_saved_without_a_gui_are_shown(drive, saved_document, tmp_path, artifacts):
    from matplotlib import image

    copy, picture = tmp_path / "copy.FCStd", artifacts / "mesh-in-freecad.png"
    answer = drive(
        f"""
document = FreeCAD.openDocument({saved_document!r})
mesh = document.FGMesh
view = fresh_view(document)
view.saveImage({str(picture)!r}, 800, 600, "White")
reopened = [mesh.Status, mesh.ViewObject.Visibility, mesh.ViewObject.Icon.isNull()]
mesh.MaterialThreshold = 0.25
stale = mesh.Status
document.saveAs({str(copy)!r})
FreeCAD.closeDocument(document.Name)
document = FreeCAD.openDocument({str(copy)!r})
saved = [type(document.FGMesh.ViewObject.Proxy).__name__, document.FGMesh.Status]
return dict(reopened=reopened, stale=stale, saved=saved)
"""
    )
    assert answer["reopened"] == ["ok", True, False]
    assert answer["stale"].startswith("out of date: MaterialThreshold was 0.3, is 0.25")
    assert answer["saved"] == ["MeshView", answer["stale"]]
    pixels = image.imread(str(picture))[:, :, :3]
    covered = (np.abs(pixels - 1).sum(axis=2) > 0.05).mean()
    assert 0.1 < covered < 0.9


def test_escape_cancels_a_macro_and_windows_stay_alive(drive, saved_document):
    answer = drive(
        f"""
import time
import freecad.fgmesh as fgmesh
from PySide import QtCore, QtGui

seen = dict(frames=0)

def count():
    seen["frames"] += 1

def escape():
    window = FreeCADGui.getMainWindow()
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
        QtGui.QApplication.postEvent(window, event)
    QtCore.QTimer.singleShot(500, say_yes)

def say_yes():
    question = QtGui.QApplication.activeModalWidget()
    if question is None:  # not yet: a busy machine
        QtCore.QTimer.singleShot(500, say_yes)
        return
    seen["said_yes"] = time.monotonic()
    question.button(QtGui.QMessageBox.Yes).click()

document = FreeCAD.openDocument({saved_document!r})
mesh = document.FGMesh
before = mesh.TetCount
mesh.MaterialThreshold = 0.002
timer = QtCore.QTimer()
timer.timeout.connect(count)
timer.start(100)
QtCore.QTimer.singleShot(2000, escape)
try:
    fgmesh.generate(mesh)
    seen["ended"] = "well"
except Exception as error:
    seen["ended"] = str(error)
seen["delay"] = time.monotonic() - seen["said_yes"]
seen["kept"] = mesh.TetCount == before
mesh.MaterialThreshold = 0.3
fgmesh.generate(mesh)
seen["again"] = [mesh.TetCount == before, mesh.Status]
return seen
"""
    )
    assert 'cancelled in the stage "material"' in answer["ended"]
    assert answer["frames"] >= 3
    assert answer["delay"] < 2
    assert answer["kept"] and answer["again"] == [True, "ok"]


def test_starts_quickly_and_loads_nothing_heavy(drive):
    answer = drive(
        """
import sys
heavy = ["matplotlib", "vtk", "vtkmodules", "scipy", "meshio", "freecad.fgmesh._core", "freecad.fgmesh.panels.mesh_panel"]
return dict(loaded=[name for name in heavy if name in sys.modules])
""",
        workbench="",
    )
    assert answer["loaded"] == []
