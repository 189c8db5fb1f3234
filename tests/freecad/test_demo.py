# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples, and the pictures and figures that the demo makes of them."""
import importlib.util
import json
import math
import os
import shutil
import subprocess
import sys

import FreeCAD
import numpy as np
import pytest


@pytest.fixture
def demo(build_dir, source_dir, tmp_path):
    """Runs examples/run_demo.py with a build folder of its own, so that the real one's demo/ stays."""
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "Mod").symlink_to(build_dir / "Mod")

    def run(*arguments):
        return subprocess.run(
            [
                sys.executable,
                str(source_dir / "examples" / "run_demo.py"),
                str(tmp_path / "build"),
                *arguments,
            ],
            cwd=tmp_path,
            env={**os.environ, "HOME": str(tmp_path)},
            capture_output=True,
            text=True,
            timeout=600,
        )

    return run


def test_a_part_of_the_user(demo, tmp_path):
    import meshio
    import Part
    from matplotlib import image

    part = tmp_path / "my part.brep"
    Part.makeBox(10, 20, 30).exportBrep(str(part))
    done = demo(str(part), "0.5+0.5*tanh((z-15)/10)")
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "build" / "demo"
    report = json.loads((folder / "my part.json").read_text())
    assert report["status"] == "ok"
    mesh = meshio.read(folder / "my part.vtu")
    assert len(mesh.get_cells_type("tetra")) == report["stages"][-1]["tets"]
    wanted = 0.5 + 0.5 * np.tanh((mesh.points[:, 2] - 15) / 10)
    assert mesh.point_data["fraction_1"] == pytest.approx(wanted)
    assert str(report["stages"][-1]["tets"]) in done.stdout
    pictures = [
        f"{stage}-{view}" for stage in ("initial", "material", "geometry") for view in ("mesh", "cut")
    ]
    for name in pictures + ["variation", "dihedral"]:
        pixels = image.imread(str(folder / f"my part-{name}.png"))[:, :, :3]
        assert (np.ptp(pixels, axis=2) > 0.1).mean() > 0.01, f"{name} shows no colours"
    document = FreeCAD.openDocument(str(folder / "my part.FCStd"))
    try:
        assert document.FGMesh.TetCount == report["stages"][-1]["tets"]
    finally:
        FreeCAD.closeDocument(document.Name)


@pytest.mark.parametrize(
    "content, formula, status, told",
    [
        (None, "z/30", 2, "missing.step"),
        (b"no CAD", "z/30", 2, "missing.step"),
        ("box", "z/(30", 2, ""),
        ("face", "z/30", 2, "solid"),
    ],
)
def test_demo_fails_clearly(demo, tmp_path, content, formula, status, told):
    import Part

    part = tmp_path / "missing.step"
    if content == "box":
        Part.makeBox(10, 20, 30).exportStep(str(part))
    elif content == "face":
        Part.makePlane(10, 20).exportStep(str(part))
    elif content:
        part.write_bytes(content)
    done = demo(str(part), formula)
    assert done.returncode == status
    assert done.stderr.startswith("demo: ") and told in done.stderr
    assert "Traceback" not in done.stderr


def test_demo_usage(demo):
    assert demo("only a part").returncode == 2


EXACT_VOLUME = {"case_study_1": 4 / 3 * math.pi * 50**3, "case_study_2": math.pi * 20**2 * 60}
FORMULA = {
    "case_study_1": lambda x, y, z: np.exp(-0.08 * np.sqrt(x**2 + y**2 + z**2)),
    "case_study_2": lambda x, y, z: (z / 60) ** 3,
}


@pytest.fixture
def example(source_dir):
    """A function: the mesh object that an example builds, by the name of its macro."""
    meshes = []

    def build(name):
        path = source_dir / "examples" / f"{name}.py"
        spec = importlib.util.spec_from_file_location(f"examples.{name}", path)
        macro = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(macro)
        meshes.append(macro.build())
        return meshes[-1]

    yield build
    for mesh in meshes:
        FreeCAD.closeDocument(mesh.Document.Name)


def volume_of(result):
    corners = result.points[result.tets]
    return np.linalg.det(corners[:, 1:] - corners[:, :1]).sum() / 6


@pytest.mark.parametrize("name", EXACT_VOLUME)
def test_case_study(name, example, fgmesh):
    """At a threshold that needs few tetrahedra; the surface as fine as in the demo."""
    mesh = example(name)
    mesh.MaterialThreshold = 0.3
    result = fgmesh.generate(mesh)
    assert mesh.Status == "ok"
    assert volume_of(result) == pytest.approx(EXACT_VOLUME[name], rel=2e-3)
    assert result.fractions[:, 0] == pytest.approx(FORMULA[name](*result.points.T), abs=1e-9)


def test_the_hardened_pin_follows_its_table(example, fgmesh, source_dir):
    """The table read and interpolated by NumPy: in z along each ring of samples, then from ring to ring."""
    mesh = example("hardened_pin")
    mesh.MaterialThreshold = 0.3
    result = fgmesh.generate(mesh)
    assert mesh.Status == "ok"
    assert volume_of(result) == pytest.approx(math.pi * 10**2 * 40, rel=5e-3)
    table = np.loadtxt(source_dir / "examples" / "hardened_pin.csv", delimiter=",", skiprows=2)
    rings = np.unique(table[:, 0])
    x, y, z = result.points.T
    along = [np.interp(z, *table[table[:, 0] == ring][:, 1:].T) for ring in rings]
    expected = [np.interp(r, rings, column) for r, column in zip(np.hypot(x, y), np.column_stack(along))]
    assert result.fractions[:, 0] == pytest.approx(np.array(expected), abs=1e-9)
    assert np.ptp(np.array(expected)[result.tets], axis=1).max() <= 0.3


def test_a_macro_run_by_freecadcmd(source_dir, in_fresh_freecad, tmp_path):
    """freecadcmd runs a macro under its own name, not as __main__."""
    macro = tmp_path / "case_study_2.py"
    text = (source_dir / "examples" / "case_study_2.py").read_text()
    macro.write_text(text.replace("MaterialThreshold = 0.1", "MaterialThreshold = 0.5"))
    assert shutil.which("freecadcmd")
    answer = in_fresh_freecad(
        f"""
import sys
sys.path.insert(0, {str(tmp_path)!r})
import case_study_2
answer = [case_study_2.mesh.Status, case_study_2.mesh.Document.FileName]
"""
    )
    assert answer == ["ok", str(tmp_path / "home" / "case_study_2.FCStd")]
