# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python interface without FreeCAD."""
import json
import math
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from freecad.fgmesh import core


@pytest.fixture
def material():
    return core.Material(["x/length"], parameters={"length": 10})


@pytest.fixture
def options():
    return core.MeshingOptions(material_threshold=0.3)


def test_a_shape_may_be_a_path_bytes_or_text(shapes, material, options):
    path = shapes / "box.brep"
    content = path.read_bytes()
    counts = {
        len(core.generate_mesh(shape, material, options).tets)
        for shape in (path, str(path), content, bytearray(content), content.decode())
    }
    assert len(counts) == 1


def test_result(shapes, material, options):
    result = core.generate_mesh(shapes / "box.brep", material, options)
    n, m, t = len(result.points), len(result.tets), len(result.triangles)
    assert result.points.shape == (n, 3) and result.points.dtype == np.float64
    assert result.tets.shape == (m, 4) and result.tets.dtype == np.int32
    assert result.tet_solids.shape == result.variation.shape == result.dihedral_min.shape == (m,)
    assert result.triangles.shape == (t, 3) and result.triangle_faces.shape == (t,)
    assert result.carriers.shape == (n, 2) and result.fractions.shape == (n, 2)
    assert len(result.edges) == len(result.edge_edges) > 0
    assert result.status == "ok" and len(result.above_threshold) == 0
    assert {"points", "tets", "report", "stages"} <= set(dir(result))
    with pytest.raises(AttributeError):
        result.no_such_thing


def test_carriers_tell_where_points_lie(shapes, material, options):
    result = core.generate_mesh(shapes / "box.brep", material, options)
    on_planes = ((result.points == 0) | (result.points == 10)).sum(axis=1)
    assert np.array_equal(3 - result.carriers[:, 0], on_planes)


def test_report_follows_the_result(shapes, material, options):
    result = core.generate_mesh(shapes / "box.brep", material, options)
    report = json.loads(json.dumps(result.report(), allow_nan=False))
    assert report == core.report(result)
    last = report["stages"][-1]
    assert last["tets"] == len(result.tets) and last["facets"] == len(result.triangles)
    edges = np.linspace(*(last["variation"]["histogram"][key] for key in ("low", "high")), num=2)
    assert edges[0] <= result.variation.min() and result.variation.max() <= edges[1] + 1e-12
    assert sum(last["variation"]["histogram"]["counts"]) == len(result.tets)


def test_report_holds_the_threshold_of_the_run(shapes, material, options):
    result = core.generate_mesh(shapes / "box.brep", material, options)
    options.material_threshold = 0.9
    assert result.report()["threshold"] == 0.3


def test_cancel_from_another_thread(shapes, material):
    control = core.RunControl()
    threading.Timer(1.0, control.cancel).start()
    begin = time.monotonic()
    with pytest.raises(core.Cancelled):
        core.generate_mesh(
            shapes / "box.brep", material, core.MeshingOptions(material_threshold=0.002), control
        )
    assert 0.9 < time.monotonic() - begin < 3


@pytest.mark.parametrize("shape", ["no/such/file.step", Path("none.brep"), "nul\0.step", "", 5, None])
def test_shape_that_cannot_be_read(shape, material):
    with pytest.raises(core.InvalidInput):
        core.generate_mesh(shape, material)


def test_errors_are_one_family():
    for error in (core.InvalidInput, core.FormulaError, core.GeometryError, core.Cancelled):
        assert issubclass(error, core.Error)
    assert issubclass(core.FormulaError, core.InvalidInput) and issubclass(core.InvalidInput, ValueError)


@pytest.mark.parametrize(
    "axis", [(0, 0, 1), (0, 0, -3), (1, 0, 0), (1, 1e-9, 0), (0, 5, 0), (1, 2, 3), (1e-200, 0, 1e-200)]
)
def test_frame_rotation(axis):
    rotation = np.array(core.frame_rotation(axis))
    assert np.allclose(rotation @ rotation.T, np.eye(3)) and np.linalg.det(rotation) == pytest.approx(1)
    assert np.allclose(np.cross(rotation[:, 2], np.array(axis) / max(map(abs, axis))), 0)
    assert rotation[:, 2] @ axis > 0


def test_frame_rotation_of_the_z_axis_is_none():
    assert np.array_equal(core.frame_rotation((0, 0, 2.5)), np.eye(3))


@pytest.mark.parametrize("axis", [(0, 0, 0), (math.nan, 0, 1), (math.inf, 0, 0), (1, 2)])
def test_axis_without_direction(axis):
    with pytest.raises(core.InvalidInput, match="axis"):
        core.frame_rotation(axis)


def test_neither_freecad_nor_qt_nor_meshio_is_loaded(own_namespace):
    code = (
        f"{own_namespace}import sys\n"
        "from freecad.fgmesh import core, io; import freecad.fgmesh.cli.main\n"
        "names = ('FreeCAD', 'PySide2', 'PySide6', 'meshio', 'vtkmodules')\n"
        "print([name for name in names if name in sys.modules])"
    )
    assert (
        subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, text=True, check=True).stdout
        == "[]\n"
    )


def test_missing_extension_tells_how_to_build(source_dir):
    code = "import sys; sys.path.insert(0, sys.argv[1]); from freecad.fgmesh import core"
    command = [sys.executable, "-P", "-c", code, str(source_dir)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and "ImportError" in done.stderr and "./scripts/build" in done.stderr


def test_references(shapes):
    ball = core.references(shapes / "ball.brep", ["Solid1", "Face1"])
    assert [(reference.name, reference.is_solid) for reference in ball] == [
        ("Solid1", True),
        ("Face1", False),
    ]
    points = np.random.default_rng(2).uniform(-15, 15, (200, 3))
    height = np.linalg.norm(points, axis=1) - 10
    signed = core.Material(["s1"], references=ball)
    assert signed.references[0].name == "Solid1"
    np.testing.assert_allclose(signed.evaluate(points)[:, 0], height, atol=1e-12)
    np.testing.assert_allclose(signed.gradients(points)[:, 0], points / (height + 10)[:, None], atol=1e-9)
    for formula in ("d1", "d2"):
        plain = core.Material([formula], references=ball)
        np.testing.assert_allclose(plain.evaluate(points)[:, 0], abs(height), atol=1e-12)
    (low,), (high,) = signed.bounds((1, 1, 1), (2, 2, 2))
    assert low <= np.sqrt(3) - 10 and high >= np.sqrt(12) - 10


def test_references_that_are_lost_are_named(shapes):
    with pytest.raises(core.InvalidInput, match="Face2 is lost"):
        core.references(shapes / "ball.brep", ["Face1", "Face2"])
    with pytest.raises(core.GeometryError, match="solid"):
        core.references(shapes / "face.brep", ["Face1"])


def test_references_that_are_not_read_yet(shapes):
    unread = core.references(shapes / "ball.brep", ["Solid1", "Face1"], read=False)
    assert [(one.name, one.is_solid, one.is_read) for one in unread] == [
        ("Solid1", True, False),
        ("Face1", False, False),
    ]
    with pytest.raises(core.FormulaError):
        core.Material(["s2"], references=unread)
    material = core.Material(["a*s1"], {"a": 3}, (1, 2, 3), references=unread)
    for ask in (material.evaluate, material.gradients, lambda points: material.bounds((0, 0, 0), (1, 1, 1))):
        with pytest.raises(core.InvalidInput, match="Solid1 has not been read: .*read_references"):
            ask([(0, 0, 0)])
    read = core.read_references(material)
    np.testing.assert_allclose(read.evaluate([(0, 0, 13), (0, 4, 0)])[:, 0], [9, -18], atol=1e-12)
    assert tuple(read.origin) == (1, 2, 3) and core.read_references(read) is read
    lost = core.Material(["d1"], references=core.references(shapes / "ball.brep", ["Face2"], read=False))
    with pytest.raises(core.InvalidInput, match="Face2 is lost"):
        core.read_references(lost)
    broken = core.Material(["d1"], references=core.references(shapes / "open.brep", ["Face1"], read=False))
    with pytest.raises(core.GeometryError, match="the shape of the reference Face1: .* is open"):
        core.read_references(broken)


def test_distances(shapes):
    """To a ball and to the plane z = 0 in closed form, whether anybody has read the references or not."""
    points = np.random.default_rng(3).uniform(-15, 15, (5000, 3))
    expected = np.linalg.norm(points, axis=1) - 10
    for read in (True, False):
        ball = core.references(shapes / "ball.brep", ["Solid1", "Face1"], read=read)
        np.testing.assert_allclose(
            core.distances(ball, points), np.column_stack([expected, abs(expected)]), atol=1e-12
        )
    inside = np.random.default_rng(4).uniform(0, 10, (100, 3))
    (bottom,) = core.references(shapes / "box.brep", ["Face5"])
    np.testing.assert_allclose(core.distances([bottom], inside)[:, 0], inside[:, 2], atol=1e-12)
    assert core.distances([bottom], np.empty((0, 3))).shape == (0, 1)
    assert core.distances([], points).shape == (5000, 0)
    with pytest.raises(core.InvalidInput, match=r"\(n, 3\)"):
        core.distances([bottom], [1, 2, 3])


def test_distances_can_be_cancelled(shapes):
    control = core.RunControl()
    ball = core.references(shapes / "ball.brep", ["Solid1"])
    control.cancel()
    with pytest.raises(core.Cancelled):
        core.distances(ball, np.zeros((1, 3)), control)


def test_a_material_whose_distances_are_known_needs_no_reading(shapes):
    """d is the distance without its sign, s that with it; coordinates are those in the frame as ever."""
    formula, frame = "x + 2*s1 + 100*d1 + 10000*d2", {"origin": (1, 0, 0)}
    unread = core.references(shapes / "ball.brep", ["Solid1", "Face1"], read=False)
    material = core.Material([formula], references=unread, **frame)
    values = material.evaluate([(3, 0, 0), (4, 5, 6)], [(-7, 5), (0.5, 0)])
    np.testing.assert_allclose(values[:, 0], [2 - 14 + 700 + 50000, 3 + 1 + 50], rtol=1e-14)
    points = np.random.default_rng(5).uniform(-15, 15, (3000, 3))
    read = core.references(shapes / "ball.brep", ["Solid1", "Face1"])
    known = core.distances(read, points)
    direct = core.Material([formula], references=read, **frame).evaluate(points)
    assert np.array_equal(material.evaluate(points, distances=known), direct)
    assert np.isnan(material.evaluate([(0, 0, 0)], [(np.nan, 0)])).all()


@pytest.mark.parametrize("shape", [(2,), (2, 2), (3, 1), (0, 1), (1, 2), (2, 1, 1)])
def test_distances_of_another_shape_are_refused(shapes, shape):
    unread = core.references(shapes / "ball.brep", ["Solid1"], read=False)
    material = core.Material(["s1"], references=unread)
    with pytest.raises(core.InvalidInput, match=r"distances .* shape \(2, 1\)"):
        material.evaluate(np.zeros((2, 3)), np.zeros(shape))
