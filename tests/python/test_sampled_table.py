# SPDX-License-Identifier: GPL-3.0-or-later
"""Sampled tables: their texts, their faults, and meshes of materials that read them."""
import itertools
import math

import meshio
import numpy as np
import pytest

from freecad.fgmesh import core, worker

BOX = (
    "x, y, z, value\n"
    + "\n".join(
        f"{x}, {y}, {z}, {0.1 * x + y * z}" for x, y, z in itertools.product((0, 4, 10), (0, 1), (0, 3))
    )
    + "\n"
)


def values_of(table, points):
    return core.Material(["t1"], tables=[table]).evaluate(points)[:, 0]


def sampled(function, **places):
    """The table of a function of some coordinates."""
    grids = np.meshgrid(*places.values(), indexing="ij")
    return core.SampledTable(places, function(*grids))


def test_values_are_linear_between_samples():
    heights, values = [0, 1, 4, 5], [0.2, 0.9, 0.4, 0.5]
    table = core.SampledTable({"z": heights}, values)
    z = np.linspace(-2, 7, 91)
    points = np.column_stack([z * 0 + 3, z * 0 - 2, z])
    assert np.allclose(values_of(table, points), np.interp(z, heights, values), atol=1e-15)


def test_coordinates_are_those_of_the_frame():
    table = sampled(lambda r, theta: r / 10 + theta / 100, r=[0, 10], theta=[-math.pi, math.pi])
    axes = dict(origin=(5, 0, 0), rotation=core.frame_rotation((1, 0, 0)))
    points = np.random.default_rng(3).uniform(-3, 3, (50, 3)) + (5, 0, 0)
    tabled = core.Material(["t1"], tables=[table], **axes)
    written = core.Material(["r/10 + theta/100"], **axes)
    assert np.allclose(tabled.evaluate(points), written.evaluate(points), atol=1e-14)
    assert np.allclose(tabled.gradients(points), written.gradients(points), atol=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        BOX,
        BOX.replace(",", ";"),
        BOX.replace(",", " "),
        BOX.replace(", ", "\t"),
        BOX.replace("\n", "\r\n"),
        "\ufeff" + BOX.replace("x, y, z, value", '"X","Y","Z","Value"'),
        BOX.replace("x, y", "# x, y").replace("10, ", "# the far end\n\n1e1, ", 1),
        BOX.rstrip("\n"),
        "\n".join([BOX.splitlines()[0], *sorted(BOX.splitlines()[1:], reverse=True)]),
        # Columns in another order.
        "z y x value\n"
        + "\n".join(f"{z} {y} {x} {0.1 * x + y * z}" for x in (0, 4, 10) for y in (0, 1) for z in (0, 3)),
        # One place, rounded differently.
        BOX.replace("10, 1", "9.9999999999, 1"),
    ],
)
def test_texts(text, tmp_path):
    (tmp_path / "box.csv").write_bytes(text.encode())
    points = np.random.default_rng(1).uniform((0, 0, 0), (9, 1, 3), (100, 3))
    expected = 0.1 * points[:, 0] + points[:, 1] * points[:, 2]
    sources = (text, text.encode(), tmp_path / "box.csv", str(tmp_path / "box.csv"), core.read_table(text))
    for source in sources:
        assert np.allclose(values_of(source, points), expected, atol=1e-9)


def test_a_table_survives_its_text():
    random = np.random.default_rng(7)
    table = core.SampledTable({"d": np.sort(random.random(5)), "z": [-1e-9, 1 / 3]}, random.random((5, 2)))
    (text,) = core.table_texts([table])
    assert core.read_table(text) == table
    assert core.SampledTable(table.places, table.values) == table
    assert core.read_table(text.replace("-1e-09", "-2e-09")) != table


@pytest.mark.parametrize(
    "text, message",
    [
        ("\n\n", "it is empty; begin with a line that names the columns"),
        ("0 1\n1 2\n", "line 1: there is no header"),
        ("#\n1 2\n", "line 2: there is no header; begin with a line that names the columns"),
        ("# , ;\n1 2\n", "line 1: the columns must be one to three coordinates, then 'value'"),
        ("x y\n0 1\n", "line 1: the columns must be one to three coordinates, then 'value'"),
        ("value\n1\n", "one to three coordinates"),
        ("x y z r value\n0 0 0 0 1\n", "one to three coordinates"),
        ("value,x\n1,2\n", "one to three coordinates, then 'value'"),
        (
            "x,height,value\n1,2,3\n",
            "line 1: the column 'height' is unknown; coordinates are x y z r theta d",
        ),
        ("x x value\n0 0 1\n", "line 1: the column x stands there twice"),
        ("x value\n", "no rows below its header"),
        ("x value\n0 1\n", "x needs samples at two places"),
        ("x value\n0 1\n\n1 nan\n", "line 4: 'nan' is no finite number"),
        ("x value\n0 1\ninf 1\n", "line 3: 'inf' is no finite number"),
        ("x value\n0 1\n1 1e300\n", "line 3: '1e300' is no finite number"),
        ("x value\n0 1\n1_0 1\n", "line 3: '1_0' is no number"),
        ("x value\n0 1\n# no\n1 a\n", "line 4: 'a' is no number"),
        ("x;value\n0;1\n1;0,5\n", "line 3: '0,5' is no number; decimals are written with a point"),
        ("x,value\n0,1\n1,\n", "line 3: '' is no number"),
        ("x,value\n0,1\n1,2,3\n", "line 3 has 3 columns, the header 2"),
        ("x y value\n0 0 1\n1 1 2\n", "no row for x = 0, y = 1; 2 rows must fill a grid of 2 x 2 = 4 places"),
        ("x y value\n0 0 1\n0 1 1\n1 0 1\n", "no row for x = 1, y = 1;"),
        ("x y value\n0 0 1\n0 1 1\n1 0 2\n1 1 3\n0 1 5\n", "line 6: x = 0, y = 1 stands in line 3 already"),
        ("x y value\n0 0 1\n0 1 1\n1 0 2\n1 0 3\n", "line 5: x = 1, y = 0 stands in line 4 already"),
        ("theta value\n0 1\n180 2\n", "theta goes from -pi to pi"),
        (b"\xff\xfex\x00", "it is no text"),
        ("x value\n0 1\n1 \udc80\n", "it is no text"),
        ("no such file", r"table t1 \(no such file\): cannot read the file: No such file"),
        (3.5, "a table is a path, a text of several lines or a core.SampledTable, not float"),
    ],
)
def test_bad_tables_are_refused(text, message):
    with pytest.raises(core.InvalidInput, match=message) as refusal:
        core.Material(["t1"], tables=[text])
    assert str(refusal.value).startswith("table t1")


def test_tables_are_a_list():
    with pytest.raises(core.InvalidInput, match="as a list"):
        core.Material(["t1"], tables=BOX)
    with pytest.raises(core.InvalidInput, match="table t2: line 1"):
        core.Material(["t1"], tables=[BOX, "1\n2\n"])


def test_arrays_that_make_no_table():
    with pytest.raises(core.InvalidInput, match=r"the shape \(2, 3\)"):
        core.SampledTable({"x": [0, 1], "y": [0, 1, 2]}, np.zeros((3, 2)))
    with pytest.raises(core.InvalidInput, match="no coordinate 'w'"):
        core.SampledTable({"w": [0, 1]}, [0, 1])


def test_a_scattered_table_is_refused_soon():
    rows = np.random.default_rng(2).random((100_000, 4)).tolist()
    text = "x y z value\n" + "\n".join(" ".join(map(str, row)) for row in rows)
    with pytest.raises(core.InvalidInput, match="there is no row for"):
        core.read_table(text)


def test_a_mesh_keeps_the_threshold_of_a_table(shapes):
    """A bump that no formula of the test's tells the mesher, found again by interpolation of NumPy's."""
    places = np.linspace(0, 10, 21)
    samples = 0.5 * (1 + np.tanh(places - 5))
    table = core.SampledTable({"x": places}, samples)
    material = core.Material(["t1"], tables=[table])
    result = worker.generate_mesh(shapes / "box.brep", material, core.MeshingOptions(material_threshold=0.2))
    fraction = np.interp(result.points[:, 0], places, samples)
    assert result.status == "ok"
    assert np.allclose(result.fractions[:, 0], fraction, atol=1e-12)
    assert np.ptp(fraction[result.tets], axis=1).max() <= 0.2
    corners = result.points[result.tets]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    assert volumes.min() > 0 and volumes.sum() == pytest.approx(1000)
    widths = np.ptp(corners[:, :, 0], axis=1)
    middles = corners[:, :, 0].mean(axis=1)
    assert widths[abs(middles - 5) < 1].mean() < 0.6 * widths[abs(middles - 5) > 3].mean()


def test_solids_share_tables_on_their_way_to_the_child(shapes):
    one, other = (core.SampledTable({"x": [0, 10]}, [0.0, top]) for top in (0.5, 1.0))
    materials = [core.Material(["t1*t2"], tables=[one, other]), core.Material(["t1"], tables=[other])]
    options = core.MeshingOptions(material_threshold=0.5)
    for material, factor in ((materials[0], 0.5 / 100), (materials[1], None)):
        result = worker.generate_mesh(shapes / "box.brep", [material], options)
        x = result.points[:, 0]
        assert np.allclose(result.fractions[:, 0], x / 10 if factor is None else factor * x**2, atol=1e-12)


def test_references_and_tables_together(shapes):
    """Reading references makes another material, which must keep the tables."""
    table = core.SampledTable({"z": [0, 10]}, [0.0, 0.5])
    references = core.references(shapes / "box.brep", ["Face1"], read=False)
    material = core.read_references(core.Material(["d1/20 + t1"], references=references, tables=[table]))
    assert np.allclose(material.evaluate([[4, 1, 6]]), [[0.5, 0.5]])


@pytest.fixture
def ramp(tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "ramp.csv").write_text("x,value\n0,0\n5,0.2\n10,1\n")
    return "data/ramp.csv"


def test_command_line(fgmesh, shapes, tmp_path, ramp):
    done = fgmesh(
        *(shapes / "box.brep", "--fraction", "t1", "--table", ramp, "--threshold", "0.3", "-o", "box.vtu")
    )
    assert done.returncode == 0, done.stderr
    mesh = meshio.read(tmp_path / "box.vtu")
    expected = np.interp(mesh.points[:, 0], [0, 5, 10], [0, 0.2, 1])
    assert np.allclose(mesh.point_data["fraction_1"], expected, atol=1e-12)


def test_a_material_file_names_tables_from_its_own_folder(fgmesh, shapes, tmp_path, ramp):
    path = tmp_path / "data" / "material.json"
    path.write_text('{"fractions": ["t1"], "tables": ["ramp.csv"]}')
    arguments = shapes / "box.brep", "--material", path, "--threshold", "0.5", "-o", "box.vtu"
    assert fgmesh(*arguments).returncode == 0
    (tmp_path / "flat.csv").write_text("x,value\n0,0.25\n5,0.25\n")
    assert fgmesh(*arguments, "--table", "flat.csv").returncode == 0
    assert np.allclose(meshio.read(tmp_path / "box.vtu").point_data["fraction_1"], 0.25)
