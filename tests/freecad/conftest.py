# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents with graded solids, and fresh FreeCAD processes as a user has them."""
import json
import os
import subprocess
import sys

import pytest

sys.path.insert(0, os.path.dirname(__file__))  # of modules that tests share

# FreeCAD's Python modules: PartDesign, Sketcher and Boolean fragments need theirs even without a GUI; so does its
# writer of decks for CalculiX, and Draft since 1.0 that of BIM.
FOLDERS = ("Mod", "Mod/Fem", "Mod/Part", "Mod/Draft", "Mod/BIM", "Mod/Assembly", "Ext")
sys.path += [f"/usr/share/freecad/{folder}" for folder in FOLDERS]


@pytest.fixture
def document(build_dir):
    """An empty document, closed after the test."""
    import FreeCAD

    document = FreeCAD.newDocument("Test")
    yield document
    FreeCAD.closeDocument(document.Name)


@pytest.fixture
def fgmesh(build_dir):
    import freecad.fgmesh

    return freecad.fgmesh


@pytest.fixture
def core(build_dir):
    from freecad.fgmesh import core

    return core


@pytest.fixture
def placement():
    """Neither along an axis nor at the origin."""
    import FreeCAD

    return FreeCAD.Placement(FreeCAD.Vector(11, -7, 5), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))


@pytest.fixture
def box(document, placement):
    """A placed box of 10 x 20 x 30 mm."""
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 10, 20, 30
    box.Placement = placement
    document.recompute()
    return box


@pytest.fixture
def graded_box(box, fgmesh):
    """The placed box with f = z / h along its own height of 30 mm."""
    return fgmesh.attach_material(box, "z/h", {"h": 30.0}, ["Steel-Generic", "Aluminum-Generic"])


@pytest.fixture
def mesh(graded_box, coarse_mesh):
    """The coarse mesh of the graded box."""
    mesh = coarse_mesh(graded_box)
    graded_box.Document.recompute()
    return mesh


@pytest.fixture
def bar(document, fgmesh):
    """The Bench of an exponential bar, E 1000 to 8000 MPa, meshed."""
    import exact_problems

    bench, _ = exact_problems.exponential_bar(document, fgmesh, MaterialThreshold=0.3, MaxSize=1)
    fgmesh.generate(bench.mesh)
    document.recompute()
    return bench


@pytest.fixture
def analysis(bar, fgmesh):
    """A function: an analysis of the graded bar with its constraints."""

    def make(**options):
        made = fgmesh.make_analysis(bar.mesh, **options)
        made.addObjects([one for one in bar.constraints if one not in made.Group])
        bar.document.recompute()
        return made

    return make


@pytest.fixture
def body(document, placement):
    """A placed PartDesign body: a pad of 6 mm on a square of 10 mm."""
    import FreeCAD
    import Part

    body = document.addObject("PartDesign::Body", "Body")
    sketch = body.newObject("Sketcher::SketchObject", "Sketch")
    corners = [FreeCAD.Vector(*xy, 0) for xy in ((0, 0), (10, 0), (10, 10), (0, 10))]
    for start, end in zip(corners, corners[1:] + corners[:1]):
        sketch.addGeometry(Part.LineSegment(start, end))
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile = sketch
    pad.Length = 6
    body.Placement = placement
    document.recompute()
    return body


@pytest.fixture
def in_fresh_freecad(tmp_path, freecad_home):
    """Runs a script in a FreeCAD that was never started before, and returns what it leaves in `answer`.

    with_workbench   FGMesh is linked into the Mod folder of that FreeCAD's user
    """

    def run(script, with_workbench=True):
        home = tmp_path / ("home" if with_workbench else "home_without")
        freecad_home(home, with_workbench)
        answer_file = tmp_path / "answer.json"
        answer_file.unlink(missing_ok=True)
        macro = tmp_path / "macro.py"
        # freecadcmd ends with 0 whatever happens: the answer tells whether the script came to its end.
        macro.write_text(
            "import json, os\n"
            f"answer = None\n{script}\n"
            f"with open({str(answer_file)!r}, 'w') as file:\n    json.dump(answer, file)\n"
            "os._exit(0)\n"
        )
        kept = {name: os.environ[name] for name in ("PATH", "LANG", "LD_LIBRARY_PATH") if name in os.environ}
        done = subprocess.run(
            ["freecadcmd", str(macro)],
            env={**kept, "HOME": str(home)},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
        )
        assert answer_file.exists(), done.stdout[-3000:] + done.stderr[-3000:]
        return json.loads(answer_file.read_text())

    return run
