# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that would end the process: it ends at once, and leaves nothing half-written.

The handler raises no exception: one that surfaces in the middle of an import or of a callback is swallowed
there. Nor does it end the meshing process, which ends by itself when this one does.
"""
import os
import signal

SIGNALS = (
    *(signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU),
    *(signal.SIGALRM, signal.SIGVTALRM, signal.SIGPROF, signal.SIGUSR1, signal.SIGUSR2),
)
"""Those that end a process that does not ask for them, but for faults of its own and SIGKILL, which nobody can catch."""
STOPPED = 5
"""The exit status that tells of it."""

_cleanups = []


def install():
    """From now on a signal ends the process with exit status STOPPED."""
    for number in SIGNALS:
        # A shell's background job has SIGINT ignored on purpose; nohup, SIGHUP.
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(
                number, lambda received, frame: leave(f"interrupted by {signal.Signals(received).name}")
            )


def ignore():
    """From now on signals do nothing: for the last steps, which take no time and must not be torn apart."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_IGN)


def before_leaving(cleanup):
    """Have `cleanup()` called where the process ends early."""
    _cleanups.append(cleanup)


def leave(reason):
    """End the process now with exit status STOPPED."""
    ignore()
    for cleanup in _cleanups:
        cleanup()
    clear_line = "\r\x1b[K" if os.isatty(2) else ""
    try:
        # Not through sys.stderr: the signal may have come in the middle of its own work.
        os.write(2, f"{clear_line}fgmesh: stopped: {reason}\n".encode())
    finally:
        os._exit(STOPPED)
