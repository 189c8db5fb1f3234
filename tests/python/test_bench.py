# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark's own parts: a measure that is wrong makes every figure wrong."""
import json
import math
import os
import subprocess
import sys
from types import SimpleNamespace

import meshio
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
    import programs
    import rivals
    import size_fields
    import tables

    modules = (cases, check, programs, rivals, size_fields, tables)
    return {module.__name__: module for module in modules}


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


def test_measures_of_a_structured_mesh(check, tmp_path):
    """A unit cube of n^3 cubes with six tetrahedra each, f = x: eta is 6 n^3 delta^3 / 1, the variation of each
    tetrahedron 1 / n, and the dihedral angles of such a tetrahedron are 45, 60 and 90 degrees."""
    n, delta = 4, 0.25
    ends = np.linspace(0, 1, n + 1)
    cubes = [CUBE / n + [x, y, z] for x in ends[:-1] for y in ends[:-1] for z in ends[:-1]]
    corners = np.vstack(cubes)
    points, place = np.unique(np.round(corners * n), axis=0, return_inverse=True)
    tets = place.reshape(-1)[np.vstack([CUBE_TETS + 8 * i for i in range(n**3)])]
    meshio.Mesh(points / n, [("tetra", tets)]).write(tmp_path / "cube.vtu")
    case = SimpleNamespace(
        fraction_at=lambda points: points[:, 0], slope_at=lambda points: np.ones(len(points))
    )
    figures = check.measure(case, tmp_path / "cube.vtu", delta)
    assert figures["faults"] == [] and figures["tets"] == 6 * n**3 and figures["above"] == 0
    assert figures["eta"] == pytest.approx(6 * (n * delta) ** 3)
    assert figures["variation_mean"] == pytest.approx(1 / n)
    assert (figures["dihedral_min"], figures["dihedral_max"]) == (pytest.approx(45), pytest.approx(90))
    assert sum(figures["dihedral_counts"]) == 6 * 6 * n**3
    assert check.measure(case, tmp_path / "cube.vtu", 0.2)["above"] == 6 * n**3


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
    found = search(lambda constant: constant <= 0.0471, 0.03, 0.1, 8)
    assert 0.0471 / (0.1 / 0.03) ** (1 / 256) <= found <= 0.0471
    with pytest.raises(bench["programs"].RivalFailed):
        search(lambda constant: False, 0.03, 0.1, 8)
    asked = []
    search(lambda constant: not asked.append(constant), 0.03, 0.1, 8, stop=lambda: len(asked) == 3)
    assert len(asked) == 3


@pytest.fixture
def job(bench, tmp_path):
    """Meshes the cylinder into tmp_path."""
    case = bench["cases"].BY_NAME["cylinder-power"]
    case.build().exportBrep(str(tmp_path / "part.brep"))
    return bench["rivals"].Job(case, case.build(), tmp_path / "part.brep", 0.1, 60.0, tmp_path / "part.msh")


@pytest.mark.parametrize("name", ["gmsh", "gmsh HXT"])
def test_gmsh_is_driven_and_measured(bench, job, name):
    """Half the size takes eight times the elements in the limit; at the foot the slope vanishes."""
    mesher, _ = bench["size_fields"].MESHERS[name]
    counts = []
    for constant in (0.08, 0.16):
        assert mesher(job, constant) > 0
        figures = bench["check"].measure(job.case, job.out, 0.1)
        assert figures["faults"] == []
        assert figures["volume"] == pytest.approx(VOLUMES[job.case.name], rel=0.1)
        counts.append(figures["tets"])
    assert 4 < counts[0] / counts[1] < 9


def test_a_search_is_made_once(bench, job):
    """What fails is too coarse; what is too slow ends the search, since the rest would be slower."""
    rivals, programs = bench["rivals"], bench["programs"]
    tried = []

    def mesher(job, constant):
        tried.append(constant)
        if constant > 0.05:
            raise programs.RivalFailed("too coarse")
        bench["size_fields"].MESHERS["gmsh"][0](job, constant)
        return 2.0

    found = rivals.searched(mesher, job)
    assert found["constant"] <= 0.05 and found["seconds"] == 2.0 and found["search_runs"] == 8
    assert found["search_seconds"] == pytest.approx(2.0 * sum(c <= 0.05 for c in tried[:8]), abs=0.1)
    tried.clear()
    assert rivals.searched(mesher, job, found)["search_seconds"] == found["search_seconds"]
    assert tried == [found["constant"]]
    tried.clear()
    job.known = 0.5  # of a coarser threshold
    rivals.searched(mesher, job)
    assert tried[0] == pytest.approx(0.05) and 0.04 < min(tried) and max(tried) < 0.0625

    tried.clear()
    job.known = 1.2  # far too coarse
    assert rivals.searched(mesher, job)["constant"] <= 0.05 and len(tried) == 5 + 8 + 1

    def slow(job, constant):
        raise programs.TooSlow("slow")

    with pytest.raises(programs.TooSlow):
        rivals.searched(slow, job)


def test_programs_are_limited(bench):
    run, failed = bench["programs"].run, bench["programs"].RivalFailed
    assert run(["echo", "done"], 10) == "done\n"
    for command, told in (
        (["sleep", "9"], "takes more than"),
        (["false"], "status 1"),
        (["no-such"], "installed"),
    ):
        with pytest.raises(failed, match=told):
            run(command, 0.5)


def test_the_grid_of_sizes_fills_its_box(bench, check):
    points, tets = bench["size_fields"].grid(((0, 0, 0), (4, 2, 1)))
    low, high = points.min(axis=0), points.max(axis=0)
    assert (low < 0).all() and (high > [4, 2, 1]).all()
    sizes = check.volumes(points, tets)
    assert sizes.min() > 0 and sizes.sum() == pytest.approx(np.prod(high - low))
    assert check.faults(points, tets, NO_TRIANGLES) == []


def test_a_tessellation_is_welded(bench):
    """Two triangles of a square, told with all their corners, and one that is a line."""
    points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 0), (0, 1, 0), (0, 0, 0)]
    merged, triangles = bench["size_fields"].welded(points, [(0, 1, 2), (3, 4, 5), (0, 2, 3)])
    assert len(merged) == 4 and len(triangles) == 2
    assert {tuple(merged[i]) for i in triangles[0]} == {(0, 0, 0), (1, 0, 0), (1, 1, 0)}


def test_run_is_a_script(source_dir):
    subprocess.run(["bash", "-n", source_dir / "bench" / "run"], check=True)
    assert os.access(source_dir / "bench" / "run", os.X_OK)


@pytest.mark.parametrize("eta, words", [(12.0, "12.0 met"), (12.1, "12.1 **not met**")])
def test_targets_are_told(bench, eta, words):
    column = next(column for column in bench["tables"].CASE_COLUMNS if column.figure == "eta")
    assert column.cell({"eta": eta}, judged=True) == words
    assert "met" not in column.cell({"eta": eta}, judged=False)


FIGURES = {
    "tets": 100,
    "faults": [],
    "above": 0,
    "eta": 8.0,
    "dihedral_min": 10.0,
    "dihedral_max": 160.0,
    "dihedral_counts": [0, 0, *[100] * 32, 0, 0],
    "variation_mean": 0.08,
    "seconds": 2.0,
}
MACHINE = {
    "commit": "c0ffee",
    "date": "today",
    "processor": "Z80",
    "cores": 1,
    "load_before": 0,
    "load_after": 0,
}


@pytest.fixture
def results():
    """As bench/run keeps them, of one case at two thresholds; at the finer one Netgen has failed."""
    searched = {**FIGURES, "tets": 400, "eta": 32.0, "seconds": 1.0, "search_seconds": 4.0, "search_runs": 8}
    coarse = {"FGMesh": {**FIGURES, "expected_tets": 120}, "gmsh": searched, "Netgen": searched}
    fine = {
        "FGMesh": {**FIGURES, "tets": 800, "seconds": 16.0, "certificate_seconds": 4.0},
        "gmsh": {**searched, "tets": 3200, "seconds": 4.0, "search_seconds": 40.0},
        "Netgen": {"failed": "one run takes more than 300 s"},
    }
    grown = {"tets": 1000, "seconds": 20.0, "microseconds_a_tet": 20.0, "growth": 1.6, "kilobytes_a_tet": 1.4}
    return {
        "repeat": 1,
        "machine": MACHINE,
        "cases": {"0.1": {"ball-exp": coarse}, "0.05": {"ball-exp": fine}},
        "studies": {},
        "scaling": {"ball-exp at 0.03": {**grown, "threshold": 0.03}},
    }


def test_tables_tell_targets_and_failures(bench, results):
    text = bench["tables"].in_markdown(results)
    rows = [[cell.strip() for cell in line.split("|")] for line in text.splitlines() if line.startswith("|")]
    named = {(row[1], row[2]): row for row in rows}
    head = next(row for row in rows if row[1].startswith("threshold 0.1"))
    own = dict(zip(head, next(row for row in rows if row[2] == "FGMesh")))
    assert own["expected off (<= 30%)"] == "20% met"
    assert own["time / gmsh run (<= 3.00)"] == "2.00 met"
    assert own["time / search (<= 1.00)"] == "0.50 met"
    assert ("ball-exp", "Netgen: one run takes more than 300 s") in named
    assert "1.60 **not met**" in text and "1.40 met" in text
    assert "25%" in text  # of the certificate
    assert "threads used" not in text and "NOT SOUND" not in text
    results["cases"]["0.1"]["ball-exp"]["FGMesh"]["faults"] = ["1 flat"]
    assert "**NOT SOUND** ball-exp at 0.1, FGMesh: 1 flat" in bench["tables"].in_markdown(results)
    results["cases"]["0.05"]["ball-exp"]["FGMesh"] = {"failed": "too thin"}
    assert bench["tables"].unsound(results)[1:] == ["ball-exp at 0.05, FGMesh: too thin"]


def test_compare_prints_ratios(source_dir, tmp_path, results):
    (tmp_path / "old").write_text(json.dumps(results))
    ways = results["cases"]["0.1"]["ball-exp"]
    ways["FGMesh"] = {**ways["FGMesh"], "tets": 80, "seconds": 1.0, "above": 3}
    results["scaling"]["ball-exp at 0.03"]["kilobytes_a_tet"] = 0.7
    del results["cases"]["0.05"]
    (tmp_path / "new").write_text(json.dumps(results))
    command = [sys.executable, source_dir / "bench" / "compare", tmp_path / "old", tmp_path / "new"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    rows = [[cell.strip() for cell in line.split("|")] for line in done.stdout.splitlines()]
    told = {row[1]: dict(zip(rows[0], row)) for row in rows if len(row) > 2}
    own = told["ball-exp at 0.1, FGMesh"]
    wanted = {"tets": "0.800", "eta": "1.000", "time": "0.500", "time / search": "0.500"}
    assert {title: own[title] for title in wanted} == wanted
    assert told["ball-exp at 0.03, scaling"]["memory a tet"] == "0.500"
    assert "only in the old results: ball-exp at 0.05, gmsh" in done.stdout
    assert "ball-exp at 0.1, FGMesh: 3 tetrahedra above the threshold, 0 before" in done.stdout
    (tmp_path / "other").write_text("{}")
    for other in ("none", "other"):
        assert subprocess.run([*command[:-1], tmp_path / other], capture_output=True).returncode == 2


README = "# A part\n\n<!-- bench/publish: begin -->\nold\n<!-- bench/publish: end -->\n\n## Next\n"


def test_publish_draws_and_tells(source_dir, tmp_path, results):
    """The same results give the same files; what has failed is in the table."""
    (tmp_path / "results.json").write_text(json.dumps({**results, "limit": 60}))
    (tmp_path / "README.md").write_text(README)
    command = [
        source_dir / "bench" / "publish",
        tmp_path / "results.json",
        "--readme",
        tmp_path / "README.md",
    ]
    for folder in ("first", "second"):
        subprocess.run([*command, "--docs", tmp_path / folder], check=True)
    names = {"tets.svg", "angles.svg", "times.svg"}
    assert {path.name for path in (tmp_path / "first").iterdir()} == names
    for name in names:
        picture = (tmp_path / "first" / name).read_bytes()
        assert b"<svg" in picture and picture == (tmp_path / "second" / name).read_bytes()
    text = (tmp_path / "README.md").read_text()
    assert text.startswith("# A part\n") and text.endswith("\n## Next\n") and "old" not in text
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if "|" in line]
    assert ["gmsh", "4", "0.5", "2.5", "4", "0.25", "2.8", "10.0 to 160.0"] in rows
    assert ["Netgen", "4", "0.5", "2.5", "none", "none", "", "10.0 to 160.0"] in rows
    assert "commit c0ffee" in text


def test_publish_refuses_a_page_without_a_place(source_dir, tmp_path, results):
    (tmp_path / "results.json").write_text(json.dumps(results))
    (tmp_path / "README.md").write_text("# A part\n")
    command = [
        source_dir / "bench" / "publish",
        tmp_path / "results.json",
        "--readme",
        tmp_path / "README.md",
    ]
    done = subprocess.run([*command, "--docs", tmp_path / "plots"], capture_output=True, text=True)
    assert done.returncode == 1 and "no place" in done.stderr
    assert (tmp_path / "README.md").read_text() == "# A part\n"


def test_pooled_angles_weigh_each_case_alike(bench):
    import plots

    few, many = [1, 0], [0, 1000]
    ways = {name: {"FGMesh": {"dihedral_counts": counts}} for name, counts in (("a", few), ("b", many))}
    shares = plots.pooled_angles({"cases": {"0.2": {}, "0.1": ways, "0.05": {}}})
    assert shares["FGMesh"] == pytest.approx([0.5, 0.5])


def test_commits_wants_two(source_dir):
    script = source_dir / "bench" / "commits"
    subprocess.run(["bash", "-n", script], check=True)
    done = subprocess.run([script, "HEAD"], capture_output=True, text=True)
    assert done.returncode == 2 and "bench/commits OLD NEW" in done.stderr
