# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD in a real window under Xvfb, driven by a script."""
import json
import os
import random
import subprocess
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

SCREEN = "1400x900x24"


@pytest.fixture(scope="session")
def artifacts(build_dir):
    """The folder for pictures, kept after the tests."""
    folder = build_dir / "test-artifacts"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture
def preferences():
    """A function: FreeCAD's user.cfg with entries of BaseApp/Preferences, as in preferences(General={"Language":
    "German"}). Groups below others: {"Mod/FGMesh": {...}}."""

    def make(groups=None, **more):
        root = xml.Element("FCParameters")
        base = xml.SubElement(root, "FCParamGroup", Name="Root")
        for path, entries in {**(groups or {}), **more}.items():
            group = base
            for name in f"BaseApp/Preferences/{path}".split("/"):
                known = group.find(f"FCParamGroup[@Name='{name}']")
                group = xml.SubElement(group, "FCParamGroup", Name=name) if known is None else known
            for name, value in entries.items():
                _add_entry(group, name, value)
        return xml.tostring(root, encoding="unicode", xml_declaration=True)

    return make


def _add_entry(group, name, value):
    if isinstance(value, str):
        xml.SubElement(group, "FCText", Name=name).text = value
    else:
        kind = {bool: "FCBool", int: "FCInt", float: "FCFloat"}[type(value)]
        xml.SubElement(group, kind, Name=name, Value=str(int(value) if kind == "FCBool" else value))


@pytest.fixture
def run_freecad(tmp_path, freecad_home):
    """A function: runs a macro in a FreeCAD with FGMesh in its Mod folder; gives what the program wrote."""

    def run(macro, screen=SCREEN, settings="", **environment):
        home = tmp_path / "home"
        freecad_home(home, settings=settings)
        path = tmp_path / "macro.py"
        path.write_text(macro)
        # The start page's browser refuses to run as root inside its sandbox.
        variables = {
            "PATH": os.environ["PATH"],
            "HOME": str(home),
            "LC_ALL": "C.UTF-8",
            "QTWEBENGINE_DISABLE_SANDBOX": "1",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            **environment,
        }
        # Tests that run beside these, perhaps in another root, look for a free number from another one on: two that
        # choose the same at the same moment end each other's server.
        first = str(100 + random.randrange(20000))
        command = [
            "xvfb-run",
            "-n",
            first,
            "--auto-servernum",
            "-s",
            f"-screen 0 {screen}",
            "freecad",
            str(path),
        ]
        done = subprocess.run(command, env=variables, capture_output=True, text=True, timeout=240)
        return done.stdout + done.stderr

    return run


@pytest.fixture
def drive(run_freecad, tmp_path, artifacts):
    """A function: runs the body of steps() in FreeCAD, where `driver` is at hand; gives what it returns.

    `pictures` is the folder for pictures there; `workbench` is active at the start. No traceback may appear.
    """

    def run(body, workbench="FGMeshWorkbench", **options):
        answer_file = tmp_path / "answer.json"
        answer_file.unlink(missing_ok=True)
        lines = "".join(f"    {line}\n" for line in body.strip("\n").split("\n"))
        macro = (
            "import sys\n"
            f"sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
            "import FreeCAD, FreeCADGui\n"
            "import driver\nfrom driver import *\nfrom windows import *\n"
            f"pictures = {str(artifacts)!r}\n\n"
            f"def steps():\n{lines}\n"
            f"driver.main(steps, {str(answer_file)!r}, {workbench!r})\n"
        )
        output = run_freecad(macro, **options)
        assert answer_file.exists(), output[-3000:]
        answer = json.loads(answer_file.read_text())
        assert not (isinstance(answer, dict) and "error" in answer), answer["error"] + output[-2000:]
        assert "Traceback" not in output, output[-3000:]
        answer = answer if isinstance(answer, dict) else {"value": answer}
        return {**answer, "output": output}

    return run


@pytest.fixture
def in_gui(drive):
    """A function: runs a script that defines look() in FreeCAD; `given` are the further arguments as texts, numpy is at
    hand. Gives the dictionary `answer` that the script has filled."""

    def run(script, **given):
        texts = {name: str(value) for name, value in given.items()}
        head = f"import numpy as np\nfrom PySide import QtCore\ngiven, answer = {texts!r}, {{}}\n"
        return drive(f"{head}{script}\nlook()\nreturn answer")

    return run


@pytest.fixture
def meshed_box():
    """The first lines of a script: `document` with `part`, a graded box, and `mesh`, seen in the view."""
    return """
import freecad.fgmesh as fgmesh
document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Box", "Box")
part.Length, part.Width, part.Height = 10, 20, 30
document.recompute()
fgmesh.attach_material(part, "z/30", constituents=["Steel-Generic", "Aluminum-Generic"])
mesh = fgmesh.make_mesh(document, part)
mesh.MaterialThreshold = 0.2
fgmesh.generate(mesh)
part.Visibility = False
document.recompute()
fresh_view(document)
"""
