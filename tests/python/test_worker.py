# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a child process: the same answer, and whatever happens to the child is an error here.

Doubles of the child, in which core.generate_mesh does something else, stand for shapes that OpenCASCADE or
CGAL cannot bear: which ones these are changes from release to release.
"""
import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from freecad.fgmesh import core, worker
from freecad.fgmesh.worker.transfer import pack, unpack

LARGEST_DELAY = 2.0
"""Of the end of a run after cancel() or its limit, seconds: what users are promised."""

HANG = "time.sleep(1000)"
HANG_WITHOUT_WORD = "control.begin_stage('initial'); time.sleep(0.3); ctypes.PyDLL(None).sleep(1000)"
"""With Python's lock held: no other thread of the child does anything."""


@pytest.fixture
def child_that(child_double, monkeypatch):
    """A function: from now on the child does this in place of meshing, or of another function of `core`."""

    def use(*asked):
        monkeypatch.setattr("freecad.fgmesh.worker.run.child_command", lambda: child_double(*asked))

    return use


@pytest.fixture
def box(shapes):
    return (shapes / "box.brep").read_bytes()


@pytest.fixture
def material():
    return core.Material(["x/length"], {"length": 10.0})


def is_alive(pid):
    with contextlib.suppress(OSError):
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    return False


def ends_within(seconds, pid):
    end = time.monotonic() + seconds
    while is_alive(pid) and time.monotonic() < end:
        time.sleep(0.02)
    return not is_alive(pid)


def plain(value):
    """Everything but times, for comparing."""
    if isinstance(value, np.ndarray):
        return value.dtype, value.shape, value.tobytes()
    if value is None or isinstance(value, (int, float, str)):
        return value
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    names = {name for name in dir(value) if not name.startswith("_")} - {"seconds", "peak_memory_mb"}
    return {name: plain(getattr(value, name)) for name in names if not callable(getattr(value, name))}


def test_the_result_is_that_of_this_process(shapes):
    turned = core.Material(
        ["clamp(0.5 + x/a, 0, 1)"], {"a": 30.1}, (1, 2, 1 / 3), core.frame_rotation((1, 2, 3))
    )
    options = core.MeshingOptions(material_threshold=0.15, surface_deviation=0.1, seed=7)
    asked = shapes / "ball.brep", turned, options
    here, there = core.generate_mesh(*asked), worker.generate_mesh(*asked)
    assert dir(here) == dir(there)
    assert plain(here) == plain(there)
    assert here.report().keys() == json.loads(json.dumps(there.report(), allow_nan=False)).keys()


def test_arrays_stay_after_the_run(box, material):
    result = worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=0.3))
    points = result.points
    del result
    assert (points.min(axis=0), points.max(axis=0)) == (
        pytest.approx([0, 0, 0], abs=1e-6),
        pytest.approx([10, 10, 10]),
    )
    with pytest.raises(ValueError, match="read-only"):
        points[0, 0] = 1


def test_values_survive_the_way(tmp_path):
    values = [
        None,
        True,
        -3,
        0.1 + 0.2,
        float("inf"),
        "ä\n\0",
        [],
        [[1], "x"],
        np.arange(6, dtype=np.int32).reshape(2, 3)[:, ::2],
        np.zeros((0, 3)),
        np.array([np.nan, -0.0]),
        np.zeros((0, 2), np.int32),
    ]
    with open(tmp_path / "arrays", "wb") as file:
        packed = json.loads(json.dumps(pack(values, file)))
    assert plain(unpack(packed, (tmp_path / "arrays").read_bytes())) == plain(values)


def test_peak_memory_is_that_of_the_child(box, material):
    """Not that of the process that starts it, which in FreeCAD has several times as much."""
    large = np.ones(50_000_000)
    result = worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=0.5))
    assert 10 < result.peak_memory_mb < 0.5 * large.nbytes / 1e6


@pytest.mark.parametrize("part", ["face.brep", "text.step", "cut.brep", "noise.brep"])
def test_refusals_are_those_of_this_process(shapes, material, part):
    with pytest.raises(core.Error) as here:
        core.generate_mesh(shapes / part, material)
    with pytest.raises(core.Error) as there:
        worker.generate_mesh(shapes / part, material)
    assert (there.type, str(there.value)) == (here.type, str(here.value))


def test_errors_before_the_child_and_in_it(box, material):
    with pytest.raises(core.InvalidInput, match="no/such"):
        worker.generate_mesh("no/such.step", material)
    with pytest.raises(core.InvalidInput, match="material_threshold"):
        worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=-1))
    with pytest.raises(core.InvalidInput):
        worker.generate_mesh(box, core.Material(["2*x/10"]))


@pytest.mark.parametrize("name", ["SIGSEGV", "SIGABRT", "SIGFPE", "SIGILL", "SIGBUS"])
def test_a_crash_is_an_error_that_tells_it(child_that, box, material, name):
    child_that(
        f"control.begin_stage('reading'); os.write(2, b'heap is bent\\n'); time.sleep(0.3); "
        f"os.kill(os.getpid(), signal.{name})"
    )
    with pytest.raises(worker.Crashed) as caught:
        worker.generate_mesh(box, material)
    text = str(caught.value)
    assert name in text and '"reading"' in text and "heap is bent" in text and "repair" in text
    assert isinstance(caught.value, core.GeometryError)


def test_reading_without_end_is_a_refusal(child_that, box, material, monkeypatch):
    monkeypatch.setattr("freecad.fgmesh.worker.run.READING_SECONDS", 1.0)
    child_that("control.begin_stage('reading')\n    while True: pass")
    with pytest.raises(core.GeometryError, match="could not be read.*within 1 s.*repair it"):
        worker.generate_mesh(box, material)


def test_a_reference_that_crashes_the_library_is_read_in_the_child(child_that, box):
    material = core.Material(["d1/20"], references=core.references(box, ["Face1"], read=False))
    child_that("core.references = lambda *asked: os.abort(); return core.read_references(asked[1][0])")
    with pytest.raises(worker.Crashed):
        worker.generate_mesh(box, material)


def test_a_child_that_is_killed_from_outside(child_that, box, material):
    child_that("os.kill(os.getpid(), signal.SIGKILL)")
    with pytest.raises(core.Cancelled, match="SIGKILL.*memory"):
        worker.generate_mesh(box, material)


def test_a_child_that_leaves_without_an_answer(child_that, box, material):
    child_that("os.write(2, b'no licence\\n'); os._exit(3)")
    with pytest.raises(RuntimeError, match='status 3: "no licence"'):
        worker.generate_mesh(box, material)


def test_a_fault_of_the_program_is_not_blamed_on_the_shape(child_that, box, material):
    child_that("[][0]")
    with pytest.raises(RuntimeError, match="IndexError: list index") as caught:
        worker.generate_mesh(box, material)
    assert "child.py" in caught.value.__notes__[0]


@pytest.mark.parametrize("action", [HANG, HANG_WITHOUT_WORD])
def test_cancel_ends_what_listens_to_nothing(child_that, box, material, action):
    child_that(action)
    control = core.RunControl()
    with worker.start(box, material, control=control) as run:
        assert not run.wait(1.0)
        pid = run._process.pid
        threading.Timer(0.2, control.cancel).start()
        begin = time.monotonic()
        assert run.wait(30)
        assert time.monotonic() - begin < 0.2 + LARGEST_DELAY
        assert not is_alive(pid)
        with pytest.raises(core.Cancelled, match="cancelled"):
            run.result()


@pytest.mark.parametrize("action", [HANG, HANG_WITHOUT_WORD])
def test_the_time_limit_ends_what_listens_to_nothing(child_that, box, material, action):
    child_that(action)
    control = core.RunControl()
    control.set_limits(1.0)
    begin = time.monotonic()
    with pytest.raises(core.Cancelled, match="time limit"):
        worker.generate_mesh(box, material, control=control)
    assert 1.0 <= time.monotonic() - begin < 1.0 + LARGEST_DELAY


@pytest.mark.parametrize(
    "action",
    [
        "blocks = [bytearray(os.urandom(1 << 20)) for _ in range(1 << 16)]",
        "bytearray(8 << 30)",
        "np.ones(1 << 30)",
    ],
    ids=["little by little", "asked for at once", "used at once"],
)
def test_the_memory_limit(child_that, box, material, action):
    child_that(action)
    control = core.RunControl()
    control.set_limits(30, 400)
    with pytest.raises(core.Cancelled, match="memory limit of 400 MB"):
        worker.generate_mesh(box, material, control=control)


def test_without_a_limit_memory_ends_where_that_of_the_machine_does(child_that, box, material):
    child_that("bytearray(1 << 50)")
    with pytest.raises(core.Cancelled, match="memory limit of [0-9]+ MB"):
        worker.generate_mesh(box, material)


def test_limits_that_suffice_do_not_disturb(box, material):
    control = core.RunControl()
    control.set_limits(100, 2000)
    assert worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=0.3), control).status


def test_chatter_disturbs_nothing(child_that, box, material):
    """More than a pipe holds, on both of the child's outputs."""
    child_that("os.write(1, b'{\\n' * 500000); os.write(2, b'x' * 1000000); return real(*asked)")
    result = worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=0.3))
    assert len(result.tets) > 0


def test_progress_is_passed_on(box):
    control, seen = core.RunControl(), []
    options = core.MeshingOptions(material_threshold=0.05)
    with worker.start(box, core.Material(["exp(-0.3*d)"]), options, control) as run:
        while not run.wait(0.01):
            seen.append((control.progress().stage, control.progress().fraction))
        assert control.progress().stage == "certificate"
        assert control.progress().tets == len(run.result().tets)
    order = ["", "reading", "initial", "material", "geometry", "certificate"]
    places = [order.index(stage) for stage, _ in seen]
    assert places == sorted(places) and order.index("material") in places
    assert all(0 <= fraction <= 1 for _, fraction in seen)


def test_leaving_the_block_ends_the_child(child_that, box, material):
    child_that(HANG)
    with pytest.raises(KeyboardInterrupt):
        with worker.start(box, material) as run:
            run.wait(0.5)
            pid = run._process.pid
            assert is_alive(pid)
            raise KeyboardInterrupt
    assert not is_alive(pid)


def test_a_run_that_goes_on_has_no_result(child_that, box, material):
    child_that(HANG)
    with worker.start(box, material) as run, pytest.raises(RuntimeError, match="wait"):
        run.result()


def test_nothing_stays_open(box, material):
    before = len(os.listdir("/proc/self/fd"))
    for _ in range(3):
        result = worker.generate_mesh(box, material, core.MeshingOptions(material_threshold=0.5))
    del result
    assert len(os.listdir("/proc/self/fd")) == before


def test_no_child_outlives_its_parent(shapes, own_namespace):
    code = (
        f"{own_namespace}import sys\n"
        "from freecad.fgmesh import core, worker\n"
        "options = core.MeshingOptions(material_threshold=0.002)\n"
        "run = worker.start(sys.argv[1], core.Material(['x/10']), options)\n"
        "run.wait(1)\n"
        "print(run._process.pid, flush=True)\n"
        "run.wait()\n"
    )
    command = [sys.executable, "-P", "-c", code, str(shapes / "box.brep")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as parent:
        pid = int(parent.stdout.readline())
        assert is_alive(pid)
        parent.send_signal(signal.SIGKILL)
    assert ends_within(LARGEST_DELAY, pid)


@pytest.fixture
def unread(shapes):
    return core.references(shapes / "ball.brep", ["Solid1", "Face1"], read=False)


def test_distances_are_those_of_this_process(shapes, unread):
    points = np.random.default_rng(6).uniform(-15, 15, (3000, 3))
    control = core.RunControl()
    found = worker.distances(unread, points, control)
    assert np.array_equal(found, core.distances(unread, points)) and found.dtype == np.float64
    assert control.progress().stage == "distances"
    box = core.references(shapes / "box.brep", ["Face1"], read=False)
    with worker.start_distances([*box, *unread], points[:2].tolist()) as run:
        assert run.wait(30)
        both = run.result()
    assert both.shape == (2, 3) and np.array_equal(both[:, 1:], found[:2])
    assert worker.distances(unread, np.empty((0, 3))).shape == (0, 2)
    assert worker.distances([], points).shape == (3000, 0)


def test_refusals_to_measure_are_those_of_this_process(shapes, unread):
    lost = core.references(shapes / "ball.brep", ["Face2"], read=False)
    broken = core.references(shapes / "open.brep", ["Face1"], read=False)
    for references, points in ((lost, np.zeros((1, 3))), (broken, np.zeros((1, 3))), (unread, np.zeros(3))):
        with pytest.raises(core.Error) as here:
            core.distances(references, points)
        with pytest.raises(core.Error) as there:
            worker.distances(references, points)
        assert (there.type, str(there.value)) == (here.type, str(here.value))


def test_measuring_is_guarded_as_meshing_is(child_that, unread):
    points = np.zeros((1, 3))
    child_that("os.abort()", "distances")
    with pytest.raises(worker.Crashed, match="the measuring process crashed"):
        worker.distances(unread, points)
    child_that(HANG, "distances")
    control = core.RunControl()
    control.set_limits(1.0)
    with pytest.raises(core.Cancelled, match="time limit"):
        worker.distances(unread, points, control)
    with worker.start_distances(unread, points, control) as run:
        control.cancel()
        assert run.wait(LARGEST_DELAY)
        with pytest.raises(core.Cancelled):
            run.result()
