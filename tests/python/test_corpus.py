# SPDX-License-Identifier: GPL-3.0-or-later
"""The corpus runner on made parts: what it writes, and that it notices a step back."""
import json
import shutil
import subprocess
import sys

import numpy as np
import pytest

from freecad.fgmesh import core


@pytest.fixture(scope="module")
def parts(shapes, tmp_path_factory):
    """A folder with a box of 10 x 20 x 5 mm with a hole across, a ball and a file that is no part."""
    import FreeCAD
    import Part

    folder = tmp_path_factory.mktemp("parts")
    (folder / "deeper").mkdir()
    box = Part.makeBox(10, 20, 5, FreeCAD.Vector(1e-6, -3, 0))
    hole = Part.makeBox(4, 4, 5, FreeCAD.Vector(3, 2, 0))
    box.cut(hole).exportStep(str(folder / "box.STEP"))
    shutil.copy(shapes / "ball.brep", folder / "deeper")
    shutil.copy(shapes / "text.step", folder)
    (folder / "notes.txt").write_text("not a part")
    return folder


@pytest.fixture
def part_figures(source_dir, monkeypatch):
    monkeypatch.syspath_prepend(source_dir / "tests" / "corpus")
    import part_figures

    return part_figures


@pytest.fixture(scope="module")
def run(source_dir, parts):
    """Run the corpus; gives the completed process."""

    def run(folder, *arguments):
        command = [source_dir / "tests" / "corpus" / "run", parts, "-o", folder, "--threshold", "0.3"]
        return subprocess.run([*command, *arguments], capture_output=True, text=True, timeout=120)

    return run


@pytest.fixture(scope="module")
def kept(run, tmp_path_factory):
    """The folder of a first result."""
    folder = tmp_path_factory.mktemp("corpus")
    done = run(folder, "--gmsh")
    assert done.returncode == 0, done.stderr
    assert (folder / "corpus.md").read_text() == done.stdout
    return folder


def files_of(folder):
    return json.loads((folder / "corpus.json").read_text())["files"]


def test_every_part_has_its_row(kept):
    files = files_of(kept)
    assert list(files) == ["box.STEP", "deeper/ball.brep", "text.step"]
    box, ball, text = files.values()
    assert (box["status"], ball["status"], text["status"]) == ("ok", "ok", "refused")
    assert "tets" not in text and text["message"]
    assert abs(box["volume_error"]) < 1e-6
    # Chords of a ball lie inside it; facets within the deviation lose less than a shell of that thickness.
    assert -100 * 3 * (np.sqrt(12) * 10 / 2000) / 10 < ball["volume_error"] < 0
    assert abs(box["deviation"]) < 1e-6 and 0 < ball["deviation"] <= 1
    for row in box, ball:
        assert 5 < row["dihedral_min"] == row["unforced_min"] < 70.6 < row["dihedral_max"] < 180
        assert row["off"] < 1e-9 and row["misses"] == ""
    assert box["euler"] == box["shape_euler"] == [0]  # a ring's
    assert ball["euler"] == ball["shape_euler"] == [2]


def test_gmsh_meshes_the_parts_too(kept):
    box, ball, _ = files_of(kept).values()
    assert abs(box["gmsh_volume_error"]) < 1e-6 and abs(box["alike_volume_error"]) < 1e-6
    assert -5 < ball["gmsh_volume_error"] < 0
    for row in box, ball:
        assert row["gmsh_message"] == "" and row["gmsh_seconds"] > 0
        assert row["alike_ratio"] == row["alike_tets"] / row["gmsh_tets"]
    assert ball["fine_tets"] > ball["alike_tets"]


def test_limits_that_are_missed_are_told(part_figures):
    kept = dict(
        volume_error=-0.4,
        deviation=1.0,
        unforced_min=5.0,
        seconds=120,
        euler=[2, 3],
        shape_euler=[2, None],
        off=1e-9,
    )
    assert list(part_figures.misses(kept)) == []
    missed = dict(volume_error=-0.6, deviation=1.1, unforced_min=4.9, seconds=121, euler=[2], shape_euler=[0])
    assert list(part_figures.misses({**kept, **missed})) == [
        "volume",
        "deviation",
        "angle",
        "time",
        "topology ([2] for [0])",
    ]
    assert list(part_figures.misses({**kept, "off": 1e-3})) == ["points off"]
    del kept["off"]
    assert list(part_figures.misses(kept)) == ["FreeCAD fails"]


@pytest.mark.parametrize("off, wrong_half", [(0, False), (0.01, False), (0, True)])
def test_distances_to_faces_are_true(off, wrong_half, source_dir, tmp_path):
    """Where FreeCAD's own are not: of half a torus fused with its mirror image it misses a part."""
    import FreeCAD
    import Part

    half = Part.makeTorus(10, 3, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -180, 180, 180)
    torus = half.fuse(half.mirror(FreeCAD.Vector(), FreeCAD.Vector(0, 1, 0)))
    torus.exportBrep(str(tmp_path / "torus.brep"))
    side = 1 if torus.Faces[0].CenterOfMass.y > 0 else -1
    u, v = (angles.ravel() for angles in np.meshgrid(np.linspace(0.2, 2.9, 7), np.linspace(-3, 3, 8)))
    height, radius = (3 + off) * np.sin(v), 10 + (3 + off) * np.cos(v)
    y = radius * np.sin(u) * (-side if wrong_half else side)
    points = np.column_stack([radius * np.cos(u), y, height])
    np.savez(tmp_path / "points.npz", points=points, carriers=np.tile([2, 1], (len(points), 1)))
    check = source_dir / "tests" / "corpus" / "boundary_check.py"
    command = [sys.executable, "-P", check, tmp_path / "torus.brep", tmp_path / "points.npz"]
    answer = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert answer["euler"] == [0] and answer["volume"] == pytest.approx([180 * np.pi**2])
    if wrong_half:
        assert answer["distance"] > 1
    else:
        assert answer["distance"] == pytest.approx(off, abs=1e-9)


def test_parts_are_graded_along_their_longest_axis(kept):
    material = core.Material([files_of(kept)["box.STEP"]["formula"]])
    ends = material.evaluate([[0, -3, 0], [10, 17, 5]])
    assert ends[:, 0] == pytest.approx([0.05, 0.95], abs=1e-9)


def test_the_table_is_markdown(kept):
    lines = (kept / "corpus.md").read_text().splitlines()
    assert all(line.count("|") == lines[0].count("|") for line in lines[:5])
    assert all(line.count("|") == lines[8].count("|") > 10 for line in lines[8:13])
    assert "2 ok, 1 refused" in lines


def test_steps_back_are_told(run, kept, tmp_path):
    files = files_of(kept)
    files["text.step"]["status"] = "ok"
    files["deeper/ball.brep"].update(status="crashed", tets=1)
    files["lost.brep"] = files["box.STEP"]
    (tmp_path / "kept.json").write_text(json.dumps({"files": files}))
    done = run(tmp_path, "--compare", tmp_path / "kept.json")
    assert done.returncode == 1, done.stderr
    assert "| text.step | ok | **refused** |" in done.stdout
    assert "| deeper/ball.brep | crashed | ok |" in done.stdout
    assert "only in the kept result: lost.brep" in done.stdout
    assert done.stdout.count("box.STEP") == 1


def test_wrong_usage(run, tmp_path):
    assert run(tmp_path, "--compare", tmp_path / "none.json").returncode == 2
    assert run(tmp_path, "--no-such-option").returncode == 2
