# SPDX-License-Identifier: GPL-3.0-or-later
"""The child process: takes one request, tells its progress, answers, ends.

Arguments: the numbers of two open files in memory, for the request (a line of JSON, then the shapes: that to
mesh, and those of references) and for arrays, those of the request and behind them those of the answer. Standard
output takes messages, a line of JSON each: ["progress", [stage, fraction, tets, expected tets, place or null]], and at
last ["result", packed] or ["error", {name, limit, text, position, formula, place}]. Standard input never says
anything: it ends when the parent does.
"""
import contextlib
import json
import os
import resource
import signal
import sys
import threading
import time
import traceback

from freecad.fgmesh import core, system_limits
from freecad.fgmesh.worker.tasks import TASKS
from freecad.fgmesh.worker.transfer import mapped, pack

PROGRESS_SECONDS = 0.1

DATA_FACTOR, DATA_SLACK = 2.0, 64e6
"""Memory that is asked for is more than what is in use, which the parent watches: growing arrays ask for up
to twice their content, threads for stacks."""


def main():
    """Serve the request; never returns."""
    # What a terminal sends reaches the parent, too, whose business it is.
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    # Where memory runs out in spite of all limits, the system is to end this process and not FreeCAD.
    with contextlib.suppress(OSError), open("/proc/self/oom_score_adj", "w") as file:
        file.write("1000")
    send = _message_channel()
    request, arrays = (os.fdopen(int(number), mode) for number, mode in zip(sys.argv[1:], ("rb", "wb")))
    with arrays:
        asked = json.loads(request.readline())
        shapes = [request.read(length) for length in asked["shapes"]]
        answer = _answer(asked, shapes, arrays, send)
    send(*answer)
    # Not through exit handlers and destructors: those of a library may crash, now that all is done.
    os._exit(0)


def _end_with_parent():
    while os.read(0, 1):
        pass
    os._exit(1)


def _message_channel():
    """A function that sends a message. From now on what libraries print goes to standard error."""
    channel = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    lock = threading.Lock()

    def send(kind, value):
        with lock:
            channel.write(json.dumps([kind, value]) + "\n")
            channel.flush()

    return send


def _answer(request, shapes, arrays, send):
    """The last message to the parent."""
    control = core.RunControl()
    threading.Thread(target=_tell_progress, args=(control, send), daemon=True).start()
    try:
        _limit_data(request["memory_limit_mb"])
        task = TASKS[request["task"]]
        return "result", pack(task.answer(request["asked"], shapes, mapped(arrays.fileno()), control), arrays)
    except Exception as error:
        # OpenCASCADE takes a want of memory for a fault of the shape.
        starved = isinstance(error, core.GeometryError) and system_limits.memory_was_short()
        return "error", {
            "name": "MemoryError" if starved else type(error).__name__,
            "limit": system_limits.reached(error),
            "text": str(error),
            "position": getattr(error, "position", None),
            "formula": getattr(error, "formula", None),
            "place": traceback.format_exc(),
        }
    finally:
        send("progress", _progress(control))


def _tell_progress(control, send):
    told = None
    while True:
        progress = _progress(control)
        if progress != told:
            send("progress", progress)
        told = progress
        time.sleep(PROGRESS_SECONDS)


def _progress(control):
    progress = control.progress()
    return [progress.stage, progress.fraction, progress.tets, progress.expected_tets, progress.place]


def _limit_data(megabytes):
    """Refuse memory far above the limit at once: the parent, which looks now and then, may be too late."""
    with open("/proc/self/statm", encoding="ascii") as file:
        _, resident, _, _, _, data, _ = (int(pages) * resource.getpagesize() for pages in file.read().split())
    largest = int(data + DATA_FACTOR * max(0.0, megabytes * 1e6 - resident) + DATA_SLACK)
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    if hard == resource.RLIM_INFINITY or largest < hard:
        resource.setrlimit(resource.RLIMIT_DATA, (largest, largest))
