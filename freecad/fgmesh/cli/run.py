# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing in a worker thread, watched from the main thread, which alone receives signals."""
import contextlib
import os
import sys
import threading
import time

from freecad.fgmesh import core
from freecad.fgmesh.cli import interrupts

POLL_SECONDS = 0.1
LIMIT_SECONDS = 0.4
GRACE_SECONDS = 1.5
"""What a run may take to notice its time limit by itself, and then that it is to stop: together less than the
2 seconds promised to the user."""


def watched_run(part, material, options, progress, time_limit=0.0, memory_limit_mb=0.0):
    """`core.generate_mesh`, shown by `progress` and stoppable by signals and limits (0: none).

    Gives the MeshingResult or raises what generate_mesh raises; core.Cancelled for an interrupt, too. Where the
    run does not notice in time that it is to stop, the process ends with exit status 5.
    """
    control = core.RunControl()
    control.set_limits(time_limit, memory_limit_mb)
    work = _Work(lambda: core.generate_mesh(part, material, options, control))
    hard_end = time.monotonic() + time_limit + LIMIT_SECONDS if time_limit else None
    try:
        while not work.wait(POLL_SECONDS):
            progress.show(control.progress())
            if hard_end is not None and time.monotonic() > hard_end:
                _stop(work, control, progress, "the time limit was reached")
    except interrupts.Interrupted as interrupt:
        _stop(work, control, progress, f"interrupted by {interrupt}")
    progress.close(control.progress())
    return work.result()


def _stop(work, control, progress, reason):
    interrupts.ignore()
    control.cancel()
    work.wait(GRACE_SECONDS)
    if not work.ended:
        # A thread inside C++ cannot be ended alone. No output exists yet, so that nothing is left behind.
        progress.close()
        with contextlib.suppress(OSError):
            print(f"fgmesh: stopped: {reason}", file=sys.stderr, flush=True)
        os._exit(5)
    progress.close()
    raise core.Cancelled(reason)


class _Work:
    """A function running in a thread of its own."""

    def __init__(self, function):
        self._function = function
        self._value = self._error = None
        self._done = threading.Event()
        threading.Thread(target=self._run, daemon=True).start()

    @property
    def ended(self):
        return self._done.is_set()

    def wait(self, seconds):
        return self._done.wait(seconds)

    def result(self):
        if self._error is not None:
            raise self._error
        return self._value

    def _run(self):
        try:
            self._value = self._function()
        except BaseException as error:  # handed to the main thread, whatever it is
            self._error = error
        finally:
            self._done.set()
