# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals and limits: exit status 5 within 2 seconds, and nothing half-written."""
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

import pytest
from broken_shapes import SIDE

# Far more tetrahedra than any machine makes in these tests' time.
ENDLESS = ("--fraction", "x/10", "--threshold", "0.002", "--memory-limit", "6000")
LARGEST_DELAY = 2.0


@pytest.fixture
def started(launcher, shapes, tmp_path):
    """Start a run in a folder with an old output; gives the process and a function that waits for a text."""
    processes = []

    def start(part, *arguments, program=(launcher,)):
        (tmp_path / "out.vtu").write_text("precious")
        command = [*program, shapes / part, *arguments, "-o", "out.vtu", "--report", "out.json"]
        process = subprocess.Popen(
            command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        processes.append(process)
        lines = []
        reader = threading.Thread(target=lambda: lines.extend(iter(process.stderr.readline, "")), daemon=True)
        reader.start()

        def wait_for(text, seconds=60):
            end = time.monotonic() + seconds
            while not any(text in line for line in lines):
                assert time.monotonic() < end and process.poll() is None, "".join(lines)
                time.sleep(0.02)

        def errors():
            reader.join(5)
            return "".join(lines)

        return process, wait_for, errors

    start.launcher = launcher
    yield start
    for process in processes:
        process.kill()
        process.wait()


def assert_untouched(folder):
    assert [path.name for path in folder.iterdir()] == ["out.vtu"]
    assert (folder / "out.vtu").read_text() == "precious"


@pytest.mark.parametrize(
    "number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU, signal.SIGUSR1]
)
def test_signal_during_material_refinement(started, tmp_path, number):
    process, wait_for, errors = started("box.brep", *ENDLESS)
    wait_for("material")
    time.sleep(1)
    process.send_signal(number)
    begin = time.monotonic()
    assert process.wait(30) == 5
    assert time.monotonic() - begin < LARGEST_DELAY
    assert "stopped" in errors() and number.name in errors() and "Traceback" not in errors()
    assert_untouched(tmp_path)


def test_signal_during_geometry_refinement(started, tmp_path):
    deviation = [
        "--fraction",
        "x/40 + 0.5",
        "--threshold",
        "0.5",
        "--deviation",
        "0.00002",
        "--min-size",
        "0.00001",
    ]
    process, wait_for, errors = started("ball.brep", *deviation, "--memory-limit", "6000")
    wait_for("geometry")
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    assert process.wait(30) == 5, errors()
    assert time.monotonic() - begin < LARGEST_DELAY
    assert_untouched(tmp_path)


def test_signal_at_any_early_moment(started, tmp_path):
    for delay in (0.03, 0.06, 0.09, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5):
        process, _, errors = started("box.brep", *ENDLESS)
        time.sleep(delay)
        process.send_signal(signal.SIGTERM)
        # Before the command has said its first word, the system's own answer to the signal is right as well.
        assert process.wait(10) in (5, -signal.SIGTERM)
        assert "Traceback" not in errors()
        assert_untouched(tmp_path)


def test_two_signals(started, tmp_path):
    process, wait_for, errors = started("box.brep", *ENDLESS)
    wait_for("material")
    process.send_signal(signal.SIGINT)
    time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert process.wait(LARGEST_DELAY + 1) == 5
    assert "Traceback" not in errors()
    assert_untouched(tmp_path)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGUSR2])
def test_signal_while_the_mesh_is_written(started, tmp_path, changed_fgmesh, number):
    program = changed_fgmesh(
        "import os, time\n"
        "from freecad.fgmesh.io import mesh_file\n"
        "def write(mesh, fields, path):\n"
        "    open(path, 'w').write('half')\n"
        "    print('half', file=sys.stderr, flush=True)\n"
        "    time.sleep(60)\n"
        "mesh_file.WRITERS['.vtu'] = write"
    )
    process, wait_for, errors = started(
        "box.brep", "--fraction", "x/10", "--threshold", "0.5", program=program
    )
    wait_for("half")
    process.send_signal(number)
    assert process.wait(10) == 5, errors()
    assert_untouched(tmp_path)


def test_hangup_that_is_ignored(started, tmp_path):
    """As nohup has it."""
    nohup = ("nohup", started.launcher)
    process, wait_for, errors = started(
        "box.brep", "--fraction", "x/10", "--threshold", "0.05", program=nohup
    )
    wait_for("material")
    process.send_signal(signal.SIGHUP)
    assert process.wait(60) == 0, errors()


def test_time_limit(started, tmp_path):
    begin = time.monotonic()
    process, _, errors = started("box.brep", *ENDLESS, "--time-limit", "4")
    assert process.wait(30) == 5
    assert 4 <= time.monotonic() - begin < 4 + LARGEST_DELAY + 1  # a second to start the interpreter
    told = errors()
    assert 'the time limit was reached in the stage "material", in which tetrahedra are divided' in told
    found = re.search(
        r"there were \d+ of about \d+ tetrahedra; it was at work near \((.*), (.*), (.*)\) mm; "
        "a larger MaterialThreshold",
        told,
    )
    assert all(0 <= float(x) <= SIDE for x in found.groups())
    assert_untouched(tmp_path)


def test_memory_limit(started, tmp_path):
    process, _, errors = started("box.brep", *ENDLESS[:-1], "100")
    assert process.wait(120) == 5
    assert "memory limit" in errors()
    assert_untouched(tmp_path)


HANG = "control.begin_stage('reading'); time.sleep(1000)"


def test_time_limit_of_a_run_that_hangs(started, tmp_path, fgmesh_whose_child):
    begin = time.monotonic()
    limit = [*ENDLESS, "--time-limit", "2"]
    process, _, errors = started("box.brep", *limit, program=fgmesh_whose_child(HANG))
    assert process.wait(30) == 5
    assert 2 <= time.monotonic() - begin < 2 + LARGEST_DELAY + 1
    assert 'time limit was reached in the stage "reading", in which the shape is read' in errors()
    assert_untouched(tmp_path)


def test_signal_to_a_run_that_hangs(started, tmp_path, fgmesh_whose_child):
    process, wait_for, errors = started("box.brep", *ENDLESS, program=fgmesh_whose_child(HANG))
    wait_for("reading")
    (child,) = subprocess.run(
        ["pgrep", "-P", str(process.pid)], capture_output=True, text=True
    ).stdout.split()
    process.send_signal(signal.SIGTERM)
    begin = time.monotonic()
    assert process.wait(30) == 5
    while Path("/proc", child).exists():
        assert time.monotonic() - begin < LARGEST_DELAY, "the meshing process goes on"
        time.sleep(0.02)
    assert_untouched(tmp_path)


def test_memory_limit_of_a_run_that_takes_all_at_once(started, tmp_path, fgmesh_whose_child):
    program = fgmesh_whose_child("np.ones(1 << 30)")
    process, _, errors = started("box.brep", *ENDLESS[:-1], "300", program=program)
    assert process.wait(30) == 5
    assert "memory limit" in errors()
    assert_untouched(tmp_path)


def test_limits_that_suffice_do_not_disturb(started):
    limits = ["--time-limit", "100", "--memory-limit", "8000"]
    process, _, errors = started("box.brep", "--fraction", "x/10", "--threshold", "0.3", *limits)
    assert process.wait(60) == 0, errors()
