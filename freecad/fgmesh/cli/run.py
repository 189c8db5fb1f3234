# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing in a worker thread; the main thread shows the progress, receives signals and watches the clock."""
import threading
import time

from freecad.fgmesh import core
from freecad.fgmesh.cli import interrupts

POLL_SECONDS = 0.1
GRACE_SECONDS = 1.5
"""What a run may take to notice its time limit by itself: the promise to the user is 2 seconds."""


def watched_run(work, progress, time_limit=0.0, memory_limit_mb=0.0):
    """`work(control)`, shown by `progress` and bounded by limits (0: none); `control` is a core.RunControl.

    Gives or raises what `work` does. Where it does not notice in time that its time is over, the process ends
    with exit status 5.
    """
    control = core.RunControl()
    control.set_limits(time_limit, memory_limit_mb)
    last_moment = time.monotonic() + time_limit + GRACE_SECONDS if time_limit else float("inf")
    thread = _Work(lambda: work(control))
    while not thread.wait(POLL_SECONDS):
        progress.show(control.progress())
        if time.monotonic() > last_moment:
            interrupts.leave("the time limit was reached")
    progress.close(control.progress())
    return thread.result()


class _Work:
    """A function running in a thread of its own."""

    def __init__(self, function):
        self._function = function
        self._value = self._error = None
        self._done = threading.Event()
        threading.Thread(target=self._run, daemon=True).start()

    def wait(self, seconds):
        """True as soon as the function has ended; False after so many seconds."""
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
