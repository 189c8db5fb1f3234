# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark's own parts: a measure that is wrong makes every figure wrong."""
import json
import math
import os
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
CUBE_TETS = np.array([[0, 4, 6, 7], [0, 6, 2, 7], [0, 2, 3, 7], [0, 3, 1, 7], [0, 1, 5, 7], [0, 5, 4, 7]])
"""Six tetrahedra about the diagonal from corner 0 to corner 7."""
NO_TRIANGLES = np.empty((0, 3), int)


@pytest.fixture(scope="session")
def bench(source_dir, build_dir):
    """The benchmark's modules by name."""
    sys.path.append(str(source_dir / "bench"))
    import cases
    import check
    import rivals
    import tables

    return {"cases": cases, "check": check, "rivals": rivals, "tables": tables}


@pytest.fixture(scope="session")
def check(bench):
    return bench["check"]


def test_a_sound_mesh_has_no_fault(check):
    outer, _ = check.hull(CUBE_TETS)
    assert check.faults(CUBE, CUBE_TETS, NO_TRIANGLES) == []
    assert check.faults(CUBE, CUBE_TETS, outer) == []
    assert len(outer) == 12
    assert check.volumes(CUBE, CUBE_TETS).sum() == pytest.approx(1)


@pytest.mark.parametrize(
    "spoil, fault",
    [
        (lambda p, t: (p, t[:, [1, 0, 2, 3]][:1].tolist() + t[1:].tolist()), "turned over"),
        (lambda p, t: (p * [1, 1, 0], t), "flat"),
        (lambda p, t: (p, np.vstack([t, t[:1]])), "more than two"),
        (lambda p, t: (np.vstack([p, [[9, 9, 9]]]), t), "no tetrahedron"),
        (lambda p, t: (np.vstack([p, p[7:]]), np.vstack([t[:5], [[0, 5, 4, 8]]])), "one place"),
    ],
)
def test_a_spoilt_mesh_has_its_fault(check, spoil, fault):
    points, tets = spoil(CUBE, CUBE_TETS)
    assert any(fault in found for found in check.faults(points, np.array(tets), NO_TRIANGLES))


def test_triangles_must_be_the_boundary(check):
    outer, _ = check.hull(CUBE_TETS)
    assert check.faults(CUBE, CUBE_TETS, outer[1:]) == ["1 triangles that are not the boundary"]


def test_angles_of_the_regular_tetrahedron(check):
    points = np.array([[1, 1, 1], [-1, 1, -1], [1, -1, -1], [-1, -1, 1]], float)
    assert check.dihedral_angles(points, np.array([[0, 1, 2, 3]])) == pytest.approx(
        np.degrees(math.acos(1 / 3))
    )


def test_angles_of_a_corner(check):
    angles = np.sort(check.dihedral_angles(np.vstack([np.zeros(3), np.eye(3)]), np.array([[0, 1, 2, 3]]))[0])
    assert angles == pytest.approx([*[np.degrees(math.acos(1 / math.sqrt(3)))] * 3, 90, 90, 90])


def test_integral_of_the_slope(check):
    """The rule is exact for quadratics: z^2 over the unit cube is 1/3."""
    case = SimpleNamespace(slope_at=lambda points: np.cbrt(points[:, 2] ** 2))
    assert check.slope_cubed(case, CUBE, CUBE_TETS) == pytest.approx(1 / 3)


VOLUMES = {
    "ball-exp": 4 / 3 * math.pi * 50**3,
    "cylinder-power": math.pi * 20**2 * 60,
    "block-exp": 60 * 40 * 30 - math.pi * 8**2 * 30,
    "tube-linear": math.pi * (40**2 - 20**2) * 10,
    # A fillet fills its corner but for a quarter of a circle.
    "bracket-tanh": 80 * 40 * 10 + 10 * 40 * 50 + (1 - math.pi / 4) * 8**2 * 40 - math.pi * 7**2 * 10,
}


def test_every_case_has_its_solid(bench):
    cases = bench["cases"]
    for name, case in cases.BY_NAME.items():
        solid = case.build()
        assert solid.isValid() and len(solid.Solids) == 1, name
        assert solid.Volume == pytest.approx(VOLUMES[name], rel=1e-9), name


def test_every_case_is_told_three_times_alike(bench, build_dir):
    """The formula of FGMesh, the fraction of the check and the slope of gmsh."""
    from freecad.fgmesh import core

    points = np.random.default_rng(1).uniform((21, 1, 1), (27, 25, 9), (500, 3))
    step = 1e-4
    for case in bench["cases"].CASES:
        assert core.Material([case.formula]).evaluate(points)[:, 0] == pytest.approx(
            case.fraction_at(points)
        ), case.name
        ends = [(case.fraction_at(points + step * e), case.fraction_at(points - step * e)) for e in np.eye(3)]
        slopes = np.linalg.norm([(above - below) / (2 * step) for above, below in ends], axis=0)
        assert slopes == pytest.approx(case.slope_at(points), rel=1e-5), case.name


def test_case_studies_are_those_of_the_examples(bench):
    import FreeCAD

    for name, case in bench["cases"].STUDIES.items():
        mesh = bench["cases"].build_study(name)
        solid = mesh.Shape
        assert solid.Shape.Volume == pytest.approx(case.build().Volume), name
        FreeCAD.closeDocument(mesh.Document.Name)


def test_the_search_finds_the_largest_constant(bench):
    search = bench["rivals"].search_constant
    found = search(lambda constant: constant <= 0.0471, 0.03, 0.1)
    assert 0.0471 / (0.1 / 0.03) ** (1 / 256) <= found <= 0.0471
    with pytest.raises(bench["rivals"].RivalFailed):
        search(lambda constant: False, 0.03, 0.1)


def test_gmsh_is_driven_and_measured(bench, tmp_path):
    """Half the size takes eight times the elements in the limit; at the foot the slope vanishes."""
    case, shape = bench["cases"].BY_NAME["cylinder-power"], tmp_path / "part.brep"
    case.build().exportBrep(str(shape))
    counts = []
    for constant in (0.08, 0.16):
        assert bench["rivals"].gmsh(case, shape, 30.0, constant, tmp_path / "part.msh") > 0
        figures = bench["check"].measure(case, tmp_path / "part.msh", 0.1)
        assert figures["faults"] == []
        assert figures["volume"] == pytest.approx(VOLUMES[case.name], rel=0.1)
        counts.append(figures["tets"])
    assert 4 < counts[0] / counts[1] < 9


def test_run_is_a_script(source_dir):
    subprocess.run(["bash", "-n", source_dir / "bench" / "run"], check=True)
    assert os.access(source_dir / "bench" / "run", os.X_OK)


@pytest.mark.parametrize("eta, words", [(16.0, "16.0 met"), (16.1, "16.1 **not met**")])
def test_targets_are_told(bench, eta, words):
    column = next(column for column in bench["tables"].CASE_COLUMNS if column.figure == "eta")
    assert column.cell({"eta": eta}, judged=True) == words
    assert "met" not in column.cell({"eta": eta}, judged=False)


def test_compare_prints_ratios(source_dir, tmp_path):
    figures = {"tets": 100, "eta": 8.0, "dihedral_min": 10.0, "dihedral_max": 160.0, "variation_mean": 0.08}
    for name, tets, seconds in (("old", 100, 2.0), ("new", 80, 1.0)):
        ways = {
            "FGMesh": {**figures, "tets": tets, "seconds": seconds},
            "gmsh": {**figures, "seconds": 1.0, "search_seconds": 4.0},
        }
        (tmp_path / name).write_text(json.dumps({"cases": {"ball": ways}, "studies": {}}))
    command = [sys.executable, source_dir / "bench" / "compare", tmp_path / "old", tmp_path / "new"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    row = next(line for line in done.stdout.splitlines() if "ball, FGMesh" in line)
    assert [cell.strip() for cell in row.split("|")][
        2:9
    ] == "0.800 1.000 1.000 1.000 1.000 0.500 0.500".split()
    assert subprocess.run([*command[:-1], tmp_path / "none"], capture_output=True).returncode == 2
