# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input: its own message, its exit status, existing outputs untouched."""
import json

import pytest

GOOD = ("--fraction", "x/10", "--threshold", "0.3")


@pytest.fixture
def refused(fgmesh, tmp_path):
    """Run, expect a status and a message, and see that the folder is as it was."""

    def run(status, message, *arguments, **keywords):
        for name in ("out.vtu", "out.json"):
            (tmp_path / name).write_text("precious")
        before = sorted(path.name for path in tmp_path.iterdir())
        done = fgmesh(*arguments, "-o", "out.vtu", "--report", "out.json", **keywords)
        assert done.returncode == status, done.stderr
        assert message.lower() in done.stderr.lower()
        assert "Traceback" not in done.stderr and "internal error" not in done.stderr
        assert done.stdout == ""
        assert sorted(path.name for path in tmp_path.iterdir()) == before
        for name in ("out.vtu", "out.json"):
            assert (tmp_path / name).read_text() == "precious"
        return done

    return run


@pytest.mark.parametrize(
    "formula, message, position",
    [
        ("x/10 + foo", "foo", 7),
        ("exp(x, y)", "exp", None),
        ("clamp(x)", "clamp", None),
        ("(x/10", ")", None),
        ("x/10)", ")", 4),
        ("a = x/10", "=", 2),
        ("__import__('os').system('true')", "", None),
        ("x.real", "", None),
        ("lambda: x", "", None),
        ("", "empty", None),
        ("x +", "", None),
        ("2 x", "", None),
        ("1e999", "", 0),
        ("d1/10", "none is given", 0),
        ("t1/10", "value of table 1, but none is given", 0),
        ("d\N{GREEK SMALL LETTER ALPHA}", "", None),
    ],
)
def test_formula(refused, shapes, formula, message, position):
    done = refused(2, message, shapes / "box.brep", "--fraction", formula)
    lines = done.stderr.splitlines()
    shown, caret = lines[-2], lines[-1]
    assert shown == f"  {formula}" and caret.strip() == "^"
    if position is not None:
        assert caret.index("^") == position + 2


def test_formula_messages_differ(refused, shapes):
    bad = ["foo", "exp(x, y)", "(x", "x)", "x = 1", "x +", "2 x", ""]
    texts = {refused(2, "", shapes / "box.brep", "--fraction", f).stderr.splitlines()[0] for f in bad}
    assert len(texts) == len(bad)


@pytest.mark.parametrize(
    "formula",
    [
        pytest.param("x+" * 500_000 + "x", id="long"),
        pytest.param("(" * 100_000 + "x" + ")" * 100_000, id="deep"),
        pytest.param("x/10\0+1", id="nul"),
        pytest.param("x/10\n=1", id="newline"),
    ],
)
def test_formula_of_a_file(refused, shapes, tmp_path, formula):
    (tmp_path / "m.json").write_text(json.dumps({"fractions": [formula]}))
    done = refused(2, "", shapes / "box.brep", "--material", "m.json")
    assert len(done.stderr) < 2000 and "\0" not in done.stderr


@pytest.mark.parametrize(
    "formula, message",
    [("x/5", "(10"), ("-x/10", "(10"), ("1/(x-5)", "("), ("log(x-20)", "("), ("sqrt(x-5)/10", "(")],
)
def test_material_that_leaves_its_range_names_a_point(refused, shapes, formula, message):
    refused(2, message, shapes / "box.brep", "--fraction", formula, "--threshold", "0.3")


@pytest.mark.parametrize(
    "name, status, message",
    [
        ("missing.step", 2, "missing.step"),
        ("", 2, "it is a folder"),
        ("empty.step", 2, "empty"),
        ("text.step", 2, "step"),
        ("noise.brep", 2, "brep"),
        ("cut.brep", 2, ""),
        ("cut.step", 2, ""),
        ("face.brep", 3, "solid"),
        ("open.brep", 3, ""),
        ("flat.brep", 3, "volume"),
    ],
)
def test_shape(refused, shapes, name, status, message):
    refused(status, message, shapes / name, *GOOD)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--threshold", "0"], "threshold"),
        (["--threshold", "-0.1"], "threshold"),
        (["--threshold", "1.5"], "threshold"),
        (["--threshold", "nan"], "no number"),
        (["--threshold", "1e999"], "too large"),
        (["--deviation", "-1"], "deviation"),
        (["--min-size", "-1"], "min"),
        (["--max-size", "-1"], "max"),
        (["--threads", "-1"], "whole number"),
        (["--seed", "4294967296"], "whole number"),
        (["--time-limit", "0"], "above 0"),
        (["--memory-limit", "-5"], "above 0"),
        (["--order", "3"], "invalid choice"),
        (["--anisotropy", "0.5"], "from 1 to 10"),
        (["--reference", "Face7"], "the reference Face7 is lost: the shape ends with Face6"),
        (["--reference", "Top"], "'Top' names no part"),
        (["--table", "t.csv"], "table t1 (t.csv): cannot read the file: No such file"),
        (["--table", "m.json"], "table t1 (m.json): line 1: the columns must be"),
        (["--fraction", "1-x/20"], "the volume fractions sum up to 1.5, more than 1,"),
        (["--fraction", "y/10+w"], "formula 2: unknown name 'w'"),
        (["--stop-after", "never"], "invalid choice"),
        (["--origin", "1,2"], "X,Y,Z"),
        (["--origin", "-1,2,x"], "no number"),
        (["--axis", "0,0,0"], "axis"),
        (["--param", "a"], "NAME=VALUE"),
        (["--param", "a=b"], "no number"),
        (["--param", "a=inf"], "no number"),
        (["--param", "a=1", "--param", "a=2"], "twice"),
        (["--param", "x=1"], "x"),
        (["--param", "2a=1"], "2a"),
        (["--material", "m.json"], "one of them"),
        (["--param", b"\xff=1"], "the name of the parameter '\\udcff' holds bytes that are no UTF-8 text"),
        (["--reference", b"\xff"], "the reference '\\udcff' holds bytes that are no UTF-8 text"),
        (
            ["--fraction", b"x\xff"],
            "the formula 'x\\udcff' holds bytes that are no UTF-8 text, at character 2",
        ),
        (["--threshold", b"\xff"], "no number"),
        (["--unknown"], "unrecognized"),
        (["--thresh", "0.1"], "unrecognized"),
        (["second.step"], "unrecognized"),
    ],
)
def test_option(refused, shapes, tmp_path, arguments, message):
    (tmp_path / "m.json").write_text('{"fractions": ["x/10"]}')
    refused(2, message, shapes / "box.brep", *GOOD, *arguments)


@pytest.mark.parametrize(
    "content, message",
    [
        ("", "material file"),
        ("{", "material file"),
        ("[]", "fractions"),
        ("{}", "fractions"),
        ('{"fractions": []}', "--fraction"),
        ('{"fractions": "x/10"}', "list"),
        ('{"fractions": [1]}', "list"),
        ('{"fractions": ["x/10"], "colour": 1}', "colour"),
        ('{"fractions": ["x/10"], "fractions": ["y/10"]}', "twice"),
        ('{"fractions": ["a*x"], "parameters": {"a": NaN}}', "NaN"),
        ('{"fractions": ["a*x"], "parameters": {"a": true}}', "number"),
        ('{"fractions": ["a*x"], "parameters": {"a": 1e999}}', "number"),
        ('{"fractions": ["a*x"], "parameters": [1]}', "object"),
        ('{"fractions": ["x/10"], "origin": [0, 0]}', "origin"),
        ('{"fractions": ["x/10"], "axis": [0, 0, 0]}', "axis"),
        ('{"fractions": ["d1/20"], "references": "Face1"}', "references"),
        ('{"fractions": ["d1/20"], "references": ["Face7"]}', "Face7 is lost"),
        ('{"fractions": ["\\ud800"]}', "UTF-8"),
        ('{"fractions": ["x/10"], "parameters": {"\\ud800": 1}}', "UTF-8"),
        ('{"fractions": ["d1/20"], "references": ["\\ud800"]}', "UTF-8"),
        ('{"fractions": ["t1"], "tables": ["\\ud800"]}', "table t1"),
        pytest.param("[" * 100_000, "nested", id="deep"),
        pytest.param("9" * 5000, "material file", id="long number"),
        pytest.param(" " * 3_000_000, "larger", id="large"),
        pytest.param(b"\xff\xfe\xfa", "material file", id="no text"),
    ],
)
def test_material_file(refused, shapes, tmp_path, content, message):
    path = tmp_path / "m.json"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    refused(2, message, shapes / "box.brep", "--material", "m.json")


def test_missing_material(refused, shapes):
    refused(2, "--fraction", shapes / "box.brep")
    refused(2, "nowhere.json", shapes / "box.brep", "--material", "nowhere.json")


@pytest.mark.parametrize(
    "output, message",
    [
        ("nowhere/out.vtu", "does not exist"),
        ("folder.vtu", "folder"),
        ("out.stl", ".vtu"),
        ("out", ".vtu"),
        ("/dev/null", ".vtu"),
        ("box.json.vtu/out.vtu", "does not exist"),
        ("x" * 255 + ".vtu", "File name too long"),
        ("circle.vtu", "symbolic links"),
    ],
)
def test_output_is_checked_before_the_work(fgmesh, shapes, tmp_path, output, message):
    (tmp_path / "folder.vtu").mkdir()
    (tmp_path / "circle.vtu").symlink_to("circle.vtu")
    # Where the shape were looked at first, the message would be another.
    done = fgmesh(shapes / "empty.step", *GOOD, "-o", output)
    assert done.returncode == 2 and message in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["circle.vtu", "folder.vtu"]


def test_report_must_not_overwrite_inputs_or_the_mesh(fgmesh, shapes, tmp_path):
    (tmp_path / "m.json").write_text('{"fractions": ["x/10"]}')
    material = ["--material", "m.json", "-o", "a.vtu", "--report"]
    assert fgmesh(shapes / "box.brep", *material, "m.json").returncode == 2
    assert fgmesh(shapes / "box.brep", *material, "./a.vtu").returncode == 2
    assert (tmp_path / "m.json").read_text() == '{"fractions": ["x/10"]}'


def test_disk_that_is_full(refused, shapes, changed_fgmesh):
    """A limit on the size of files, set when the mesh is there, stands for a disk without room."""
    program = changed_fgmesh(
        "import resource\n"
        "from freecad.fgmesh.cli import outputs\n"
        "def limited(*given, write=outputs.write):\n"
        "    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))\n"
        "    write(*given)\n"
        "outputs.write = limited"
    )
    refused(2, "cannot write", shapes / "box.brep", *GOOD, "--quiet", program=program)


def test_shape_that_crashes_the_library(refused, shapes, fgmesh_whose_child):
    done = refused(3, "crashed", shapes / "box.brep", *GOOD, program=fgmesh_whose_child("os.abort()"))
    assert "SIGABRT" in done.stderr and "repair" in done.stderr


def test_usage_without_arguments(fgmesh):
    assert fgmesh().returncode == 2


def test_help_tells_the_defaults_of_the_library(fgmesh):
    from freecad.fgmesh import core

    done = fgmesh("--help")
    assert done.returncode == 0 and done.stderr == ""
    assert f"default {core.MeshingOptions().material_threshold:g}" in done.stdout.replace("\n", " ")
