# SPDX-License-Identifier: GPL-3.0-or-later
"""The parent's side: starts the child, shows its progress, keeps its limits, tells how it ended."""
import contextlib
import fcntl
import json
import math
import mmap
import os
import selectors
import signal
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

from freecad.fgmesh import core, system_limits
from freecad.fgmesh.worker import stages
from freecad.fgmesh.worker.transfer import mapped, unpack

WATCH_SECONDS = 0.05
LAST_WORDS = 4000
"""Bytes of the child's standard error that are kept for the message."""

READING = ("", "references", "reading")
"""Stages in which the shape is read and checked."""

READING_SECONDS, READING_SECONDS_PER_MB = 12.0, 60.0
"""Of computing, after which OpenCASCADE will not end: sound shapes take less than a tenth of that."""

CRASHES = {
    *(signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS),
    *(signal.SIGFPE, signal.SIGILL, signal.SIGTRAP, signal.SIGSYS),
}


class Crashed(core.GeometryError):
    """The child process has crashed on the shape."""


class Run:
    """A child process at work on one of `tasks`. To be used by one thread; `with` ends the child where it still
    runs. `control` (RunControl) shows the progress while the Run is waited for; its cancel() and limits kill the
    child.
    """

    def __init__(self, task, control=None):
        self._control = control = core.RunControl() if control is None else control
        self._task = task
        self._memory_limit_mb = control.memory_limit_mb() or 0.9 * available_memory_mb()
        self._answer = self._stopped = None
        self._ended = False
        self._unread = self._last_words = b""
        try:
            self._start()
        except OSError as error:
            limit = system_limits.reached(error)
            if not limit:
                raise
            raise core.Cancelled(limit) from error

    def _start(self):
        with contextlib.ExitStack() as undo:
            self._arrays = _memory_file("fgmesh-arrays")
            undo.callback(os.close, self._arrays)
            with _closed_afterwards(_memory_file("fgmesh-request")) as requested:
                self._write_request(requested)
                self._process = _spawn(requested, self._arrays)
            undo.callback(self._process.kill)
            self._selector = selectors.DefaultSelector()
            self._selector.register(self._process.stdout, selectors.EVENT_READ, self._read_messages)
            self._selector.register(self._process.stderr, selectors.EVENT_READ, self._read_chatter)
            undo.pop_all()

    def _write_request(self, requested):
        shapes = []
        with os.fdopen(os.dup(self._arrays), "wb") as arrays:
            asked = self._task.request(shapes, arrays)
        request = {
            "task": type(self._task).__name__,
            "asked": asked,
            "shapes": [len(text) for text in shapes],
            "memory_limit_mb": self._memory_limit_mb,
        }
        self._reading_limit = READING_SECONDS + READING_SECONDS_PER_MB * sum(request["shapes"]) / 1e6
        with os.fdopen(os.dup(requested), "wb") as file:
            file.write(json.dumps(request).encode() + b"\n" + b"".join(shapes))
        os.lseek(requested, 0, os.SEEK_SET)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def wait(self, seconds=math.inf):
        """True as soon as the run has ended; False after so many seconds.

        Progress, cancelling and limits are looked after in here only: call it at least every half second.
        """
        end = time.monotonic() + seconds
        while not self._ended:
            left = max(0.0, end - time.monotonic())
            self._read(min(left, WATCH_SECONDS))
            if not self._ended:
                self._stop_where_due()
            if left == 0.0:
                break
        return self._ended

    def result(self):
        """What the function in `core` gives, of a run that has ended; raises what that raises, and Crashed."""
        if not self._ended:
            raise RuntimeError("the run has not ended: wait() for it")
        if not self._answer:
            raise self._early_end()
        kind, value = self._answer
        if kind == "error":
            raise self._error(**value)
        return self._task.result(unpack(value, mapped(self._arrays)))

    def close(self):
        """End the child where it still runs, and give back what it took; after result(), whose arrays stay."""
        if self._selector is not None:
            self._end()
            self._selector.close()
            for pipe in (self._process.stdin, self._process.stdout, self._process.stderr):
                pipe.close()
            os.close(self._arrays)
            self._selector = None

    def _read(self, seconds):
        for key, _ in self._selector.select(seconds):
            data = os.read(key.fd, 65536)
            if data:
                key.data(data)
            else:
                self._selector.unregister(key.fileobj)
        if self._answer or not self._selector.get_map():
            self._end()

    def _read_messages(self, data):
        *lines, self._unread = (self._unread + data).split(b"\n")
        for line in lines:
            kind, value = json.loads(line)
            if kind == "progress":
                self._show(*value)
            else:
                self._answer = kind, value

    def _read_chatter(self, data):
        self._last_words = (self._last_words + data)[-LAST_WORDS:]

    def _show(self, stage, fraction, tets, expected_tets, place):
        if stage != self._control.progress().stage:
            self._control.begin_stage(stage)
        self._control.report(fraction, tets)
        self._control.expect(expected_tets)
        if place:
            self._control.look_at(*place)

    def _stop_where_due(self):
        stage = self._control.progress().stage
        if self._control.cancelled():
            self._stopped = core.Cancelled("the run was cancelled" + self._place())
        elif self._control.seconds_left() < 0:
            self._stopped = core.Cancelled("the time limit was reached" + self._limit_place())
        elif _resident_mb(self._process.pid) > self._memory_limit_mb:
            self._stopped = core.Cancelled(self._memory_limit_reached() + self._limit_place())
        elif stage in READING and _computed_seconds(self._process.pid) > self._reading_limit:
            self._stopped = core.GeometryError(
                f"the shape could not be read and checked within {self._reading_limit:.0f} s of computing, many "
                "times what a sound one of its size takes: check its geometry (Part -> Check geometry) and "
                "repair it, or export it again from its source"
            )
        if self._stopped:
            self._end()

    def _end(self):
        if not self._selector.get_map():
            # Its pipes are closed, so it is ending by itself: the exit status tells how.
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(1.0)
        # Even after its answer: nothing that it could still do is wanted.
        self._process.kill()
        self._process.wait()
        self._ended = True

    def _error(self, name, limit, text, position, formula, place):
        if name == "MemoryError":
            return core.Cancelled(system_limits.memory_text(self._memory_limit_mb) + self._limit_place())
        kind = getattr(core, name, None)
        if not (isinstance(kind, type) and issubclass(kind, core.Error)):
            if limit:
                return core.Cancelled(limit + self._place())
            fault = RuntimeError(f"{name}: {text}")
            fault.add_note(f"In the {self._task.process}:\n{place}")
            return fault
        error = kind(text)
        if position is not None:
            error.position, error.formula = position, formula
        return error

    def _early_end(self):
        """The error of a child that gave no answer."""
        if self._stopped:
            return self._stopped
        status = self._process.returncode
        if status >= 0:
            limit = system_limits.reached(self._last_words.decode(errors="backslashreplace"))
            if limit:
                return core.Cancelled(limit + self._place())
            return RuntimeError(f"the {self._task.process} ended with exit status {status}{self._words()}")
        number = signal.Signals(-status)
        if number in CRASHES:
            return Crashed(
                f"the {self._task.process} crashed ({number.name}, {signal.strsignal(number)}){self._place()}"
                f"{self._words()}. The shape is more than OpenCASCADE or CGAL can bear: check its geometry "
                "and repair it, or export it again from its source"
            )
        memory = ", as the system does where memory runs out" if number == signal.SIGKILL else ""
        return core.Cancelled(f"{number.name} ended the {self._task.process}{memory}{self._place()}")

    def _memory_limit_reached(self):
        return f"the memory limit of {self._memory_limit_mb:.0f} MB was reached"

    def _place(self):
        return stages.place(self._control.progress())

    def _limit_place(self):
        """Where a run was that has reached a limit, and what helps."""
        return stages.place_and_cure(self._control.progress())

    def _words(self):
        """What the child said at last, for a message."""
        lines = self._last_words.decode(errors="backslashreplace").split("\n")
        said = [line.strip() for line in lines if line.strip().isprintable() and line.strip()]
        return f': "{said[-1][:200]}"' if said else ""


def child_command():
    """The command line of the child, without the files' numbers."""
    return [interpreter(), "-P", str(Path(__file__).resolve().with_name("__main__.py"))]


def interpreter():
    """The path of the Python that runs this: inside FreeCAD sys.executable is FreeCAD."""
    if Path(sys.executable or "").name.startswith("python"):
        return sys.executable
    return str(Path(sysconfig.get_config_var("BINDIR"), f"python{sysconfig.get_python_version()}"))


def _memory_file(name):
    """The number of an open file in memory, above those of the standard streams, even where these are closed."""
    with _closed_afterwards(os.memfd_create(name)) as file:
        return fcntl.fcntl(file, fcntl.F_DUPFD_CLOEXEC, 3)


@contextlib.contextmanager
def _closed_afterwards(file):
    try:
        yield file
    finally:
        os.close(file)


def _spawn(*files):
    pipe = subprocess.PIPE
    command = [*child_command(), *map(str, files)]
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, pass_fds=files)


def available_memory_mb():
    """Memory that a run could use, MB, by the system's account."""
    with open("/proc/meminfo", encoding="ascii") as file:
        sizes = dict(line.split(":") for line in file)
    return int(sizes["MemAvailable"].split()[0]) * 1024 / 1e6


def _resident_mb(pid):
    """Memory in use by a process, MB."""
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        # The file of a process that has ended is empty.
        fields = file.read().split()
    return int(fields[1]) * mmap.PAGESIZE / 1e6 if fields else 0.0


def _computed_seconds(pid):
    """Processor time that a process has taken."""
    with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
        # Behind the name of the program, which may have blanks and brackets.
        fields = file.read().rpartition(")")[2].split()
    return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK") if fields else 0.0
