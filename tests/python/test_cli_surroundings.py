# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shell does to a command: closed and full streams, pipes, devices, limits of the system."""
import os
import shlex
import subprocess
import time

import meshio
import pytest

GOOD = ("--fraction", "x/10", "--threshold", "0.5", "-o", "out.vtu")


@pytest.fixture
def shell(launcher, shapes, tmp_path):
    """Run a line of shell in which $fgmesh, $box and $good stand for the command, a shape and options."""

    def run(line, seconds=60):
        names = {"fgmesh": launcher, "box": shapes / "box.brep"}
        text = line.replace("$good", shlex.join(GOOD))
        for name, value in names.items():
            text = text.replace(f"${name}", shlex.quote(str(value)))
        return subprocess.run(
            ["bash", "-c", text], cwd=tmp_path, capture_output=True, text=True, timeout=seconds
        )

    return run


@pytest.mark.parametrize("closed", [">&-", "<&-", "2>&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full"])
@pytest.mark.parametrize("quiet", ["", "--quiet"])
def test_mesh_in_spite_of_streams_that_are_closed_or_full(shell, tmp_path, closed, quiet):
    done = shell(f"$fgmesh $box $good {quiet} {closed}")
    assert done.returncode == 0, done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["out.vtu"]
    assert len(meshio.read(tmp_path / "out.vtu").cells_dict["tetra"])


def test_wrong_usage_with_closed_streams(shell):
    assert shell("$fgmesh --unknown <&- >&- 2>&-").returncode == 2
    assert shell("$fgmesh --unknown 2>/dev/full").returncode == 2


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_that_nobody_can_read(shell, option):
    full = shell(f"$fgmesh {option} >/dev/full")
    assert full.returncode == 2
    assert full.stderr == "fgmesh: cannot write to standard output: No space left on device\n"
    for reader in (">&-", "| true; exit ${PIPESTATUS[0]}"):
        done = shell(f"$fgmesh {option} {reader}")
        assert done.returncode == 0 and done.stderr == ""


def test_inputs_through_pipes(shell, tmp_path):
    (tmp_path / "m.json").write_text('{"fractions": ["t1*d1/10"], "references": ["Face1"]}')
    (tmp_path / "t.csv").write_text("x, value\n0, 1\n10, 1\n")
    done = shell(
        "cat $box | $fgmesh /dev/stdin --material <(cat m.json) --table <(cat t.csv) --threshold 0.5 -o a.vtu"
        " && $fgmesh $box --material m.json --table t.csv --threshold 0.5 -o b.vtu && cmp a.vtu b.vtu"
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "line",
    [
        "$fgmesh pipe --fraction x/10",
        "$fgmesh $box --fraction t1 --table pipe",
        "$fgmesh $box --material pipe",
        # One that says something, and no more.
        "(printf DBRep_DrawableShape; sleep 9) | $fgmesh /dev/stdin --fraction x/10",
    ],
)
def test_time_limit_counts_while_a_pipe_says_nothing(shell, tmp_path, line):
    os.mkfifo(tmp_path / "pipe")
    begin = time.monotonic()
    done = shell(f"{line} --time-limit 0.5 -o out.vtu & wait $!")
    assert done.returncode == 5 and time.monotonic() - begin < 20
    assert "the time limit was reached while" in done.stderr and "was read" in done.stderr


@pytest.mark.parametrize("device", ["/dev/zero", "/dev/null", "/dev/tty0"])
@pytest.mark.parametrize("place", ["{}", "$box --material {}", "$box --fraction t1 --table {}"])
def test_devices_are_refused(shell, device, place):
    if not os.path.exists(device):
        device = "/dev/random"
    formula = "" if "--" in place else "--fraction x/10"
    done = shell(f"$fgmesh {place.format(device)} {formula} -o out.vtu")
    assert done.returncode == 2 and f"{device}" in done.stderr
    assert "it is a device: name a file or a pipe" in done.stderr


def test_shape_file_that_is_too_large(shell, tmp_path):
    with open(tmp_path / "huge.step", "wb") as file:
        file.truncate(40 << 30)  # without a block on the disk
    done = shell("ulimit -v 8000000; $fgmesh huge.step --fraction x/10 -o out.vtu")
    assert done.returncode == 2 and "'huge.step': it is larger than 1024 MB" in done.stderr


@pytest.mark.parametrize(
    "limit, words",
    [
        ("-n 9", "the limit on open files was reached (ulimit -n raises it)"),
        ("-f 4", "the limit on the size of files was reached (ulimit -f raises it)"),
    ],
)
def test_limits_of_the_system(shell, tmp_path, limit, words):
    (tmp_path / "out.vtu").write_text("precious")
    done = shell(f"ulimit {limit}; $fgmesh $box $good --threads 1")
    assert done.returncode == 5, done.stderr
    assert f"fgmesh: stopped: {words}" in done.stderr
    assert (tmp_path / "out.vtu").read_text() == "precious"
    assert [path.name for path in tmp_path.iterdir()] == ["out.vtu"]


def test_want_of_memory_is_no_fault_of_the_shape(fgmesh_whose_child, fgmesh, shapes):
    """OpenCASCADE takes an allocation that fails for a face that cannot be triangulated."""
    starve = (
        "import resource; held = [bytearray(1 << 20)]; "
        "resource.setrlimit(resource.RLIMIT_AS, (1 << 31, -1))\n"
        "    try:\n"
        "        while True: held.append(bytearray(16 << 20))\n"
        "    except MemoryError: held.clear()\n"
        "    raise core.GeometryError('Face1 cannot be triangulated')"
    )
    done = fgmesh(shapes / "box.brep", *GOOD, program=fgmesh_whose_child(starve))
    assert done.returncode == 5, done.stderr
    assert "memory" in done.stderr and "Face1" not in done.stderr


def test_fault_of_the_shape_is_told_in_spite_of_a_limit_on_memory(shell, shapes):
    done = shell(f"ulimit -v 4000000; $fgmesh {shlex.quote(str(shapes / 'flat.brep'))} $good")
    assert done.returncode == 3 and "volume" in done.stderr


def test_numbers_of_standard_streams_are_not_taken_by_the_run(shell, own_namespace, tmp_path):
    """A Python program without standard input may mesh, too."""
    (tmp_path / "run.py").write_text(
        f"{own_namespace}import sys\n"
        "from freecad.fgmesh import core, worker\n"
        "options = core.MeshingOptions(material_threshold=0.5)\n"
        "print(worker.generate_mesh(sys.argv[1], core.Material(['x/10']), options).status)\n"
    )
    done = shell("/usr/bin/python3 -P run.py $box <&-")
    assert done.stdout == "ok\n", done.stderr
