# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD with its GUI, as a user starts it: the workbench is there, works, and shows meshes."""
import json
import os
import subprocess

import numpy as np
import pytest

SCRIPT = """
import json, os, traceback
import FreeCAD, FreeCADGui
from PySide import QtCore

answer = {{}}

def settle():
    for _ in range(20):
        FreeCADGui.updateGui()

def look():
    answer["listed"] = "FGMeshWorkbench" in FreeCADGui.listWorkbenches()
    FreeCADGui.activateWorkbench("FGMeshWorkbench")
    answer["active"] = FreeCADGui.activeWorkbench().name()
    document = FreeCAD.openDocument({document!r})
    mesh = document.FGMesh
    view = FreeCADGui.activeDocument().activeView()
    view.viewIsometric()
    view.fitAll()
    settle()
    view.saveImage({picture!r}, 800, 600, "White")
    answer["reopened"] = [mesh.Status, mesh.ViewObject.Visibility, mesh.ViewObject.Icon.isNull()]

    mesh.MaterialThreshold = 0.25
    command = FreeCADGui.Command.get("FGMesh_Mesh")
    FreeCADGui.Selection.clearSelection()
    answer["enabled"] = [command.isActive()]
    FreeCADGui.Selection.addSelection(mesh)
    answer["enabled"].append(command.isActive())
    answer["before"] = mesh.Status
    FreeCADGui.runCommand("FGMesh_Mesh")
    answer["after"] = mesh.Status
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Box)
    FreeCADGui.runCommand("FGMesh_Mesh")
    answer["second"] = document.FGMesh001.TetCount
    view.fitAll()
    settle()
    FreeCADGui.getMainWindow().grab().save({window!r})
    document.saveAs({copy!r})
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument({copy!r})
    answer["saved"] = [document.FGMesh.ViewObject.Proxy.__class__.__name__, document.FGMesh.Status]

def run():
    try:
        look()
    except Exception:
        answer["error"] = traceback.format_exc()
    with open({answer!r}, "w") as file:
        json.dump(answer, file)
    os._exit(0)

QtCore.QTimer.singleShot(1000, run)
"""

ESCAPE = """
import json, os, time, traceback
import FreeCAD, FreeCADGui
import freecad.fgmesh as fgmesh
from PySide import QtCore, QtGui

answer = {{"frames": 0}}

def count():
    answer["frames"] += 1

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
    answer["said_yes"] = time.monotonic()
    question.button(QtGui.QMessageBox.Yes).click()

def look():
    document = FreeCAD.openDocument({document!r})
    mesh = document.FGMesh
    answer["before"] = [mesh.TetCount, mesh.MaterialThreshold]
    mesh.MaterialThreshold = 0.002
    FreeCADGui.Selection.addSelection(mesh)
    timer = QtCore.QTimer()
    timer.timeout.connect(count)
    timer.start(100)
    QtCore.QTimer.singleShot(2000, escape)
    FreeCADGui.runCommand("FGMesh_Mesh")
    answer["delay"] = time.monotonic() - answer["said_yes"]
    answer["after"] = mesh.TetCount
    mesh.MaterialThreshold = answer["before"][1]
    FreeCADGui.runCommand("FGMesh_Mesh")
    answer["again"] = [mesh.TetCount, mesh.Status]

def run():
    try:
        look()
    except Exception:
        answer["error"] = traceback.format_exc()
    with open({answer!r}, "w") as file:
        json.dump(answer, file)
    os._exit(0)

FreeCADGui.activateWorkbench("FGMeshWorkbench")
QtCore.QTimer.singleShot(1000, run)
"""


@pytest.fixture
def artifacts(build_dir):
    folder = build_dir / "test-artifacts"
    folder.mkdir(exist_ok=True)
    return folder


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


def run_gui(script, tmp_path, build_dir):
    """Runs `script` in a FreeCAD with FGMesh in its Mod folder; returns what the program wrote."""
    mod = tmp_path / "home" / ".local" / "share" / "FreeCAD" / "Mod"
    mod.mkdir(parents=True)
    (mod / "FGMesh").symlink_to(build_dir / "Mod" / "FGMesh")
    macro = tmp_path / "macro.py"
    macro.write_text(script)
    # The start page's browser refuses to run as root inside its sandbox.
    environment = {
        "PATH": os.environ["PATH"],
        "HOME": str(tmp_path / "home"),
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "LIBGL_ALWAYS_SOFTWARE": "1",
    }
    command = ["xvfb-run", "--auto-servernum", "freecad", str(macro)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=180)
    return done.stdout + done.stderr


def test_workbench(saved_document, tmp_path, build_dir, artifacts):
    from matplotlib import image

    picture, window = artifacts / "mesh-in-freecad.png", artifacts / "freecad-window.png"
    answer_file = tmp_path / "answer.json"
    script = SCRIPT.format(
        document=saved_document,
        picture=str(picture),
        window=str(window),
        copy=str(tmp_path / "copy.FCStd"),
        answer=str(answer_file),
    )
    output = run_gui(script, tmp_path, build_dir)
    assert answer_file.exists(), output[-3000:]
    answer = json.loads(answer_file.read_text())
    assert "error" not in answer, answer["error"]
    assert "Traceback" not in output, output[-3000:]
    assert (answer["listed"], answer["active"]) == (True, "FGMeshWorkbench")
    assert answer["reopened"] == ["ok", True, False]
    assert answer["enabled"] == [False, True]
    assert answer["before"].startswith("out of date")
    assert answer["after"] == "ok"
    assert answer["second"] > 0
    assert answer["saved"] == ["MeshView", "ok"]
    assert window.stat().st_size > 0
    pixels = image.imread(str(picture))[:, :, :3]
    covered = (np.abs(pixels - 1).sum(axis=2) > 0.05).mean()
    assert 0.1 < covered < 0.9


def test_escape_cancels_and_windows_stay_alive(saved_document, tmp_path, build_dir):
    answer_file = tmp_path / "answer.json"
    script = ESCAPE.format(document=saved_document, answer=str(answer_file))
    output = run_gui(script, tmp_path, build_dir)
    assert answer_file.exists(), output[-3000:]
    answer = json.loads(answer_file.read_text())
    assert "error" not in answer, answer["error"]
    assert 'cancelled in the stage "material"' in output
    assert answer["frames"] >= 3
    assert answer["delay"] < 2
    assert answer["after"] == answer["before"][0]
    assert answer["again"] == [answer["before"][0], "ok"]
