# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension module by itself: material evaluation, errors, options, arrays that share memory."""
import gc
import math
import re
import threading
import time

import numpy as np
import pytest

from freecad.fgmesh import _core

ALPHA = 0.08
FLOATS = {"points", "fractions", "variation", "dihedral_min"}
"""The arrays of a result that are not of int32."""


@pytest.fixture
def material():
    return _core.Material(["exp(-alpha*d)"], parameters={"alpha": ALPHA})


@pytest.fixture
def points():
    return np.random.default_rng(4).uniform(-20, 20, (500, 3))


@pytest.fixture
def result(shapes):
    ramp = _core.Material(["x/10"])
    content = (shapes / "box.brep").read_bytes()
    return _core.generate_mesh(content, [ramp], _core.MeshingOptions(material_threshold=0.5))


def test_material_values(material, points):
    values = material.evaluate(points)
    assert values.shape == (500, 2) and values.dtype == np.float64
    np.testing.assert_allclose(values.sum(axis=1), 1, rtol=1e-15)
    np.testing.assert_allclose(values[:, 0], np.exp(-ALPHA * np.linalg.norm(points, axis=1)), rtol=1e-14)


def test_material_gradients(material, points):
    distance = np.linalg.norm(points, axis=1)[:, None]
    expected = -ALPHA * np.exp(-ALPHA * distance) * points / distance
    gradients = material.gradients(points)
    assert gradients.shape == (500, 2, 3)
    np.testing.assert_allclose(gradients[:, 0], expected, rtol=1e-12, atol=1e-16)
    np.testing.assert_array_equal(gradients[:, 1], -gradients[:, 0])
    assert np.array_equal(material.gradients([[0, 0, 0]]), [[[0, 0, 0], [0, 0, 0]]])


def test_material_bounds(material):
    (low,), (high,) = material.bounds((1, 2, 3), (4, 5, 6))
    assert low == pytest.approx(math.exp(-ALPHA * math.sqrt(77)), rel=1e-13)
    assert high == pytest.approx(math.exp(-ALPHA * math.sqrt(14)), rel=1e-13)
    with pytest.raises(_core.InvalidInput, match="low <= high"):
        material.bounds((1, 1, 1), (0, 2, 2))


def test_material_in_a_frame():
    turn = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    material = _core.Material(["x"], origin=(1, 2, 3), rotation=turn)
    # The frame's x axis is the world's y.
    assert material.evaluate([[7.0, 5.0, 9.0]]) == pytest.approx(np.array([[3.0, -2.0]]))
    np.testing.assert_array_equal(material.gradients([[7.0, 5.0, 9.0]])[:, 0], [[0, 1, 0]])
    np.testing.assert_array_equal(material.origin, [1, 2, 3])
    np.testing.assert_array_equal(material.rotation, turn)
    assert material.fractions == ["x"] and material.parameters == {}


@pytest.mark.parametrize("shape", [(3,), (4, 2), (2, 3, 3)])
def test_points_of_another_shape_are_refused(material, shape):
    for method in (material.evaluate, material.gradients):
        with pytest.raises(_core.InvalidInput, match=r"\(n, 3\)"):
            method(np.zeros(shape))


def test_points_of_any_layout_are_read_right(material, points):
    expected = material.evaluate(points)
    for same in (np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2], points.tolist()):
        assert np.array_equal(material.evaluate(same), expected)
    assert material.evaluate(np.zeros((0, 3))).shape == (0, 2)
    assert material.gradients(np.zeros((0, 3))).shape == (0, 2, 3)


def test_evaluation_lets_other_threads_run():
    slow = _core.Material(["+".join(["sin(x*y)^1.5"] * 50)])
    many = np.zeros((400_000, 3))
    worker = threading.Thread(target=slow.gradients, args=(many,))
    worker.start()
    turns = 0
    while worker.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 20


def test_family_of_errors():
    assert issubclass(_core.InvalidInput, (_core.Error,)) and issubclass(_core.InvalidInput, ValueError)
    assert issubclass(_core.FormulaError, _core.InvalidInput)
    assert issubclass(_core.GeometryError, _core.Error) and issubclass(_core.Cancelled, _core.Error)
    assert not issubclass(_core.GeometryError, ValueError)
    assert _core.FormulaError("by hand").position == 0


@pytest.mark.parametrize(
    "formula, position, part",
    [
        ("exp(-alpa*d)", 5, "alpha"),
        ("2x", 1, "operator is missing"),
        ("x\0", 1, "NUL"),
        ("__import__('os')", 0, "unknown function"),
        ("x" * 1_000_000, 10_000, "1000000 characters"),
        ("α*d", 0, "'α'"),
    ],
)
def test_formula_errors_tell_the_position(formula, position, part):
    with pytest.raises(_core.FormulaError, match=part) as caught:
        _core.Material([formula], parameters={"alpha": 1})
    assert caught.value.position == position
    line, caret = _core.caret_excerpt(formula, position).splitlines()
    assert caret.strip() == "^" and len(line) < 120


def test_materials_without_meaning():
    with pytest.raises(_core.InvalidInput, match="'pi'"):
        _core.Material(["x"], parameters={"pi": 3})
    with pytest.raises(_core.InvalidInput, match="finite"):
        _core.Material(["x"], parameters={"alpha": math.inf})
    with pytest.raises(_core.InvalidInput, match="right-handed"):
        _core.Material(["x"], rotation=np.diag([1, 1, -1]))
    with pytest.raises(TypeError):
        _core.Material("x")


def options_of_the_header(source_dir):
    text = (source_dir / "cpp" / "pipeline" / "meshing_options.hpp").read_text(encoding="utf-8")
    body = re.search(r"struct MeshingOptions \{(.*?)\n\};", text, re.DOTALL).group(1)
    return dict(re.findall(r"^  [\w:]+ (\w+) = (.+);", body, re.MULTILINE))


def test_options_are_those_of_cpp(source_dir):
    header = options_of_the_header(source_dir)
    assert len(header) > 5
    fields = _core.MeshingOptions.fields()
    assert list(fields) == list(header)
    truth = {"true": True, "false": False}
    for name, default in header.items():
        told = default.strip('"') if default.startswith('"') else truth.get(default)
        assert fields[name] == (float(default) if told is None else told)


def test_options_by_keyword_and_attribute():
    options = _core.MeshingOptions(order=2, stop_after="material", max_size=7)
    assert (options.order, options.stop_after, options.max_size) == (2, "material", 7.0)
    untouched = _core.MeshingOptions.fields()
    assert options.as_dict() == {**untouched, "order": 2, "stop_after": "material", "max_size": 7.0}
    options.seed = 5
    assert eval(repr(options), {"MeshingOptions": _core.MeshingOptions}) == options
    assert options != _core.MeshingOptions()
    with pytest.raises(_core.InvalidInput, match="material_threshold"):
        _core.MeshingOptions(material_threshold=-1).validate()


def test_options_refuse_what_they_do_not_know():
    with pytest.raises(TypeError, match="'treshold'; there are material_threshold"):
        _core.MeshingOptions(treshold=0.1)
    with pytest.raises(TypeError, match="order is a int, not 'two'"):
        _core.MeshingOptions(order="two")
    with pytest.raises(TypeError):
        _core.MeshingOptions().seed = -1
    with pytest.raises(TypeError):
        _core.MeshingOptions(0.1)


def test_arrays_are_views_of_the_result(result):
    counts = {"points": 3, "carriers": 2, "tets": 4, "triangles": 3, "edges": 2}
    for name, columns in counts.items():
        array = getattr(result, name)
        assert array.ndim == 2 and array.shape[1] == columns, name
    names = [*counts, "tet_solids", "triangle_faces", "fractions", "variation", "dihedral_min"]
    for name in names:
        array, again = getattr(result, name), getattr(result, name)
        assert array.dtype == (np.float64 if name in FLOATS else np.int32), name
        assert not array.flags.owndata and not array.flags.writeable, name
        assert array.__array_interface__["data"] == again.__array_interface__["data"], name
    assert result.above_threshold.dtype == np.int32


def test_arrays_outlive_the_result(shapes):
    ramp = _core.Material(["x/10"])
    options = _core.MeshingOptions(material_threshold=0.5)
    content = (shapes / "box.brep").read_bytes()
    points = _core.generate_mesh(content, [ramp], options).points
    before = points.copy()
    gc.collect()
    [np.full(points.shape, 7.0) for _ in range(50)]
    assert np.array_equal(points, before)


def test_stages_are_plain_figures(result):
    stage = result.stages[0]
    assert stage.name == "initial" and stage.tets >= 1
    assert all(isinstance(count, int) for count in stage.variation_histogram.counts)


def test_errors_of_a_run(shapes, material):
    with pytest.raises(_core.InvalidInput):
        _core.generate_mesh(b"", [material])
    with pytest.raises(_core.GeometryError):
        _core.generate_mesh((shapes / "face.brep").read_bytes(), [material])
    control = _core.RunControl()
    control.cancel()
    assert control.cancelled()
    with pytest.raises(_core.Cancelled):
        _core.generate_mesh((shapes / "box.brep").read_bytes(), [material], control=control)


def test_progress_of_a_new_control():
    control = _core.RunControl()
    control.set_limits(seconds=5)
    progress = control.progress()
    assert (progress.stage, progress.fraction, progress.tets, progress.expected_tets) == ("", 0.0, 0, 0)


def test_progress_tells_how_many_tetrahedra_are_expected(shapes):
    shape, material = (shapes / "ball.brep").read_bytes(), _core.Material(["exp(-0.1*d)"])
    control = _core.RunControl()
    result = _core.generate_mesh(shape, [material], control=control)
    expected = control.progress().expected_tets
    assert expected == int(_core.estimate(shape, [material]).tets)
    assert 0.7 * len(result.tets) < expected < 1.3 * len(result.tets)


def test_versions():
    versions = _core.versions()
    assert versions["fgmesh"] == _core.__version__
    for name in ("occt_compiled", "cgal"):
        assert re.match(r"\d+\.\d+", versions[name])
    # FreeCAD's Part would share the library: one copy, of the version compiled for.
    assert [version.split(".")[:2] for version in versions["occt_loaded"]] in (
        [],
        [versions["occt_compiled"].split(".")[:2]],
    )
