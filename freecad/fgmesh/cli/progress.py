# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a run is, on standard error: a bar on a terminal, plain lines otherwise."""
import contextlib
import shutil
import sys
import time

from freecad.fgmesh.worker.remaining import RemainingTime, rough_time

LINE_SECONDS = 10.0
"""Plain lines go to log files: one at the start of each stage, then one in this time."""

MANY_MORE = 1.5
"""Expected tetrahedra are told as long as they are so many times those there are."""


def make_progress(quiet, stream=None):
    """The display that fits `stream` (standard error)."""
    stream = sys.stderr if stream is None else stream
    if quiet:
        return NoProgress()
    return ProgressBar(stream) if stream.isatty() else ProgressLines(stream)


class NoProgress:
    def show(self, progress):
        """Show a core progress: its stage, fraction in [0, 1], tetrahedra and how many are expected."""

    def close(self, progress=None):
        """Leave the stream at the start of a line; `progress` is the last state, if there is one."""


class ProgressBar(NoProgress):
    def __init__(self, stream):
        self._stream = stream
        self._start = time.monotonic()
        self._remaining = RemainingTime()

    def show(self, progress):
        if progress.stage:
            columns = shutil.get_terminal_size().columns
            elapsed = time.monotonic() - self._start
            left = self._remaining.seconds(progress.stage, progress.fraction, elapsed)
            _write(self._stream, f"\r{bar_line(progress, elapsed, columns - 1, left)}\x1b[K")

    def close(self, progress=None):
        _write(self._stream, "\r\x1b[K")


class ProgressLines(NoProgress):
    def __init__(self, stream):
        self._stream = stream
        self._start = time.monotonic()
        self._stage = ""
        self._next = 0.0
        self._remaining = RemainingTime()

    def show(self, progress):
        elapsed = time.monotonic() - self._start
        left = self._remaining.seconds(progress.stage, progress.fraction, elapsed)
        if progress.stage and (progress.stage != self._stage or elapsed >= self._next):
            self._stage, self._next = progress.stage, elapsed + LINE_SECONDS
            done = f" {100 * clamped(progress.fraction):.0f} %" if progress.fraction else ""
            more = "" if left is None else f", stage about {rough_time(left)} more"
            _write(
                self._stream, f"fgmesh: {elapsed:.1f} s, {progress.stage}{done}, {tets_of(progress)}{more}\n"
            )

    def close(self, progress=None):
        # A stage shorter than the polling would otherwise never be told.
        if progress is not None and progress.stage != self._stage:
            self.show(progress)


def _write(stream, text):
    # Nobody reads any more: no reason to give up the mesh.
    with contextlib.suppress(OSError):
        stream.write(text)
        stream.flush()


def bar_line(progress, seconds, columns, left=None):
    """One line of at most `columns` characters. left: seconds that the stage is expected to take still."""
    fraction = clamped(progress.fraction)
    head = f"{progress.stage:9s}"
    tail = f" {100 * fraction:3.0f} %  {tets_of(progress)}  {seconds:.0f} s"
    if left is not None:
        tail += f", stage about {rough_time(left)} more"
    room = max(0, min(40, columns - len(head) - len(tail) - 3))
    filled = round(fraction * room)
    return f"{head} [{'#' * filled}{'.' * (room - filled)}]{tail}"[:columns]


def tets_of(progress):
    """How many tetrahedra there are; and how many are expected, where they are many more."""
    if progress.expected_tets <= MANY_MORE * progress.tets:
        return f"{progress.tets} tets"
    expected = float(f"{progress.expected_tets:.2g}")
    return f"{progress.tets} of about {expected:.0f} tets"


def clamped(fraction):
    return min(1.0, max(0.0, fraction))
