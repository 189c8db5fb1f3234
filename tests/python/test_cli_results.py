# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line's good ends: files, report, table, exit statuses 0 and 4."""
import json
import re

import meshio
import numpy as np
import pytest

# A box of 10 mm with f = x / 10: |grad f| = 0.1 / mm, so that the integral of its cube is 1, and eta = N d^3.
LINEAR = ("--fraction", "x/length", "--param", "length=10", "--threshold", "0.3")


@pytest.fixture
def meshed(fgmesh, shapes):
    def run(name, *arguments):
        done = fgmesh(shapes / "box.brep", *LINEAR, "-o", name, *arguments)
        assert done.returncode == 0, done.stderr
        return done

    return run


def tet_volumes(points, tets):
    a, b, c = (points[tets[:, i]] - points[tets[:, 0]] for i in (1, 2, 3))
    return np.einsum("ij,ij->i", np.cross(a, b), c) / 6


def test_vtu(meshed, tmp_path):
    meshed("box.vtu")
    mesh = meshio.read(tmp_path / "box.vtu")
    tets, triangles = (block.data for block in mesh.cells)
    assert [block.type for block in mesh.cells] == ["tetra", "triangle"]
    volumes = tet_volumes(mesh.points, tets)
    assert volumes.min() > 0 and volumes.sum() == pytest.approx(1000, rel=1e-9)
    first, second = mesh.point_data["fraction_1"], mesh.point_data["fraction_2"]
    assert np.allclose(first, mesh.points[:, 0] / 10, atol=1e-12) and np.allclose(first + second, 1)
    variation = mesh.cell_data["variation"][0]
    assert np.allclose(variation, np.ptp(first[tets], axis=1)) and variation.max() <= 0.3
    assert (mesh.cell_data["solid"][0] == 1).all() and (mesh.cell_data["solid"][1] == 0).all()
    assert (mesh.cell_data["face"][0] == 0).all()
    faces = mesh.cell_data["face"][1]
    assert set(faces) == {1, 2, 3, 4, 5, 6}
    for face in range(1, 7):
        corners = mesh.points[triangles[faces == face]]
        spread = np.ptp(corners.reshape(-1, 3), axis=0)
        assert sorted(np.round(spread, 9)) == [0, 10, 10], f"Face{face} is no face of the box"
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.linalg.norm(sides, axis=1).sum() / 2 == pytest.approx(100)


@pytest.mark.parametrize("extension", ["inp", "msh"])
def test_other_formats_hold_the_same_tetrahedra(meshed, tmp_path, extension):
    meshed("box.vtu")
    meshed(f"box.{extension}")
    one, other = (meshio.read(tmp_path / f"box.{name}") for name in ("vtu", extension))
    centres = [mesh.points[mesh.cells_dict["tetra"]].mean(axis=1) for mesh in (one, other)]
    assert np.allclose(*(np.array(sorted(map(tuple, np.round(centre, 9)))) for centre in centres))


def test_unv_in_freecad(meshed, tmp_path):
    import FreeCAD  # noqa: F401
    import Fem

    meshed("box.unv")
    mesh = Fem.read(str(tmp_path / "box.unv"))
    points = np.array([tuple(mesh.Nodes[number]) for number in sorted(mesh.Nodes)])
    tets = np.array([mesh.getElementNodes(number) for number in mesh.Volumes]) - 1
    assert tet_volumes(points, tets).sum() == pytest.approx(-1000)  # FreeCAD's sense is the opposite one
    names = {mesh.getGroupName(group) for group in mesh.Groups}
    assert {"Solid1", *(f"Face{n}" for n in range(1, 7))} <= names


def test_step_gives_the_same_solid(fgmesh, shapes, tmp_path):
    done = fgmesh(shapes / "box.step", *LINEAR, "-o", "box.vtu")
    assert done.returncode == 0, done.stderr
    mesh = meshio.read(tmp_path / "box.vtu")
    assert tet_volumes(mesh.points, mesh.cells_dict["tetra"]).sum() == pytest.approx(1000)


def test_report(meshed, tmp_path):
    meshed("box.vtu", "--report", "box.json")
    report = json.loads((tmp_path / "box.json").read_text())
    mesh = meshio.read(tmp_path / "box.vtu")
    assert report["status"] == "ok" and report["threshold"] == 0.3
    assert [stage["name"] for stage in report["stages"]] == ["initial", "material", "geometry"]
    assert {"element_ratio", "certified", "deviation_max", "threads", "peak_memory_mb"} <= set(report)
    last = report["stages"][-1]
    tets, triangles = mesh.cells_dict["tetra"], mesh.cells_dict["triangle"]
    assert (last["points"], last["facets"], last["tets"]) == (len(mesh.points), len(triangles), len(tets))
    variation = mesh.cell_data["variation"][0]
    assert [last["variation"][key] for key in ("min", "max", "mean")] == pytest.approx(
        [variation.min(), variation.max(), variation.mean()]
    )
    assert last["variation"]["above_threshold"] == 0
    assert sum(last["variation"]["histogram"]["counts"]) == len(tets)
    assert sum(last["dihedral"]["histogram"]["counts"]) == 6 * len(tets)
    assert last["dihedral"]["min"] == pytest.approx(mesh.cell_data["dihedral_min"][0].min())
    assert report["element_ratio"] == pytest.approx(len(tets) * 0.3**3, rel=0.01)


@pytest.mark.parametrize("stage, count", [("initial", 1), ("material", 2), ("geometry", 3)])
def test_stop_after(fgmesh, shapes, tmp_path, stage, count):
    done = fgmesh(shapes / "box.brep", *LINEAR, "-o", "a.vtu", "--stop-after", stage, "--report", "a.json")
    assert done.returncode in (0, 4)
    assert len(json.loads((tmp_path / "a.json").read_text())["stages"]) == count


def test_table_on_standard_output_and_progress_on_standard_error(meshed):
    done = meshed("box.vtu")
    rows = [line.split() for line in done.stdout.splitlines()]
    assert {"initial", "material", "geometry"} <= {row[0] for row in rows if row}
    # Which stages are seen is a matter of how long they take.
    assert re.search("material|geometry|certificate", done.stderr) and "\r" not in done.stderr
    assert re.search(r"above threshold\s+0 of \d+", done.stdout)


def test_second_order(fgmesh, shapes, tmp_path):
    arguments = ["--fraction", "d/10", "--threshold", "0.4", "--deviation", "0.3", "--order", "2"]
    done = fgmesh(shapes / "ball.brep", *arguments, "-o", "ball.vtu", "--report", "ball.json")
    assert done.returncode == 0, done.stderr
    mesh = meshio.read(tmp_path / "ball.vtu")
    assert [block.type for block in mesh.cells] == ["tetra10", "triangle6"]
    on_boundary = mesh.points[np.unique(mesh.cells_dict["triangle6"])]
    assert np.abs(np.linalg.norm(on_boundary, axis=1) - 10).max() < 1e-7
    distance = np.linalg.norm(mesh.points, axis=1) / 10
    assert np.allclose(mesh.point_data["fraction_1"], distance, atol=1e-9)
    report = json.loads((tmp_path / "ball.json").read_text())
    assert (report["order"], report["points"], report["straightened"]) == (2, len(mesh.points), 0)
    assert report["volume"] == pytest.approx(report["shape_volume"], rel=1e-3)
    assert re.search(rf"second order\s+{len(mesh.points)} points", done.stdout)


def test_quiet(meshed):
    done = meshed("box.vtu", "--quiet")
    assert (done.stdout, done.stderr) == ("", "")


def test_frame(fgmesh, shapes, tmp_path):
    """z measured along the axis (1, 1, 0)/sqrt(2) from the box's far corner."""
    arguments = ["--fraction", "-z/20", "--origin", "10,10,10", "--axis", "1,1,0", "--threshold", "0.3"]
    assert fgmesh(shapes / "box.brep", *arguments, "-o", "a.vtu").returncode == 0
    mesh = meshio.read(tmp_path / "a.vtu")
    expected = (20 - mesh.points[:, 0] - mesh.points[:, 1]) / np.sqrt(2) / 20
    assert np.allclose(mesh.point_data["fraction_1"], expected, atol=1e-12)


def test_material_file(fgmesh, shapes, tmp_path):
    material = {"fractions": ["k*d"], "parameters": {"k": 0.5}, "origin": [0, 0, 0], "axis": [0, 0, 2]}
    (tmp_path / "m.json").write_text(json.dumps(material))
    arguments = ["--material", "m.json", "--param", "k=0.05", "--threshold", "0.3"]
    done = fgmesh(shapes / "box.brep", *arguments, "-o", "a.vtu")
    assert done.returncode == 0, done.stderr
    mesh = meshio.read(tmp_path / "a.vtu")
    assert np.allclose(mesh.point_data["fraction_1"], np.linalg.norm(mesh.points, axis=1) / 20)


def test_jump_is_written_and_located(fgmesh, shapes, tmp_path):
    arguments = ["--fraction", "step(5.1, x)", "--threshold", "0.3", "--report", "a.json"]
    done = fgmesh(shapes / "box.brep", *arguments, "-o", "a.vtu")
    assert done.returncode == 4, done.stderr
    mesh = meshio.read(tmp_path / "a.vtu")
    tets = mesh.cells_dict["tetra"]
    values = mesh.points[tets][:, :, 0] >= 5.1
    bad = values.any(axis=1) & ~values.all(axis=1)
    assert bad.any()
    report = json.loads((tmp_path / "a.json").read_text())
    assert report["status"] == "threshold_not_met"
    assert report["stages"][-1]["variation"]["above_threshold"] == bad.sum()
    assert f"{bad.sum()} of {len(tets)} tetrahedra" in done.stderr
    x = float(re.search(r" at \(([-0-9.e+]+)", done.stderr).group(1))
    crossing = mesh.points[tets[bad]][:, :, 0]
    assert crossing.min() <= x <= crossing.max()


def test_replaces_existing_files(meshed, tmp_path):
    (tmp_path / "box.vtu").write_text("old")
    (tmp_path / "box.json").write_text("old")
    meshed("box.vtu", "--report", "box.json")
    assert meshio.read(tmp_path / "box.vtu").points.shape[1] == 3
    assert json.loads((tmp_path / "box.json").read_text())["status"] == "ok"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["box.json", "box.vtu"]


def test_unread_standard_output_does_no_harm(launcher, shapes, tmp_path):
    import subprocess

    command = [launcher, shapes / "box.brep", *LINEAR, "-o", tmp_path / "a.vtu"]
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, timeout=120)
    assert done.returncode == 0 and (tmp_path / "a.vtu").exists()
    assert "Traceback" not in done.stderr and "Exception" not in done.stderr


def test_same_seed_same_mesh(meshed, tmp_path):
    meshed("a.vtu", "--seed", "7", "--threads", "1")
    meshed("b.vtu", "--seed", "7", "--threads", "1")
    assert (tmp_path / "a.vtu").read_bytes() == (tmp_path / "b.vtu").read_bytes()


def test_runs_from_the_source_folder_as_well(launcher, shapes, source_dir, tmp_path):
    """The folder freecad/ of the sources must not be taken for the built package."""
    import subprocess

    command = [launcher, shapes / "box.brep", *LINEAR, "-o", tmp_path / "a.vtu", "--quiet"]
    assert subprocess.run(command, cwd=source_dir, timeout=120).returncode == 0


def test_references(fgmesh, shapes, tmp_path):
    """From one face of the box to the opposite one; the option overrules the file."""
    content = {"fractions": ["(d1/(d1+d2))^2"], "references": ["Face3"]}
    (tmp_path / "m.json").write_text(json.dumps(content))
    options = ("--reference", "Face1", "--reference", "Face2", "--threshold", "0.3")
    done = fgmesh(shapes / "box.step", "--material", "m.json", *options, "-o", "box.vtu")
    assert done.returncode == 0, done.stderr
    mesh = meshio.read(tmp_path / "box.vtu")
    squares = [(mesh.points[:, axis] / 10) ** 2 for axis in range(3)]
    squares += [(1 - mesh.points[:, axis] / 10) ** 2 for axis in range(3)]
    assert any(np.allclose(mesh.point_data["fraction_1"], square, atol=1e-9) for square in squares)
