# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing in a child process, with its progress shown here."""
from freecad.fgmesh import core, worker

POLL_SECONDS = 0.1


def watched_run(part, material, options, progress, time_limit=0.0, memory_limit_mb=0.0):
    """`worker.generate_mesh`, shown by `progress` and bounded by limits (0: none but that of the worker).

    Gives the MeshingResult or raises what worker.generate_mesh raises.
    """
    control = core.RunControl()
    control.set_limits(time_limit, memory_limit_mb)
    with worker.start(part, material, options, control) as run:
        while not run.wait(POLL_SECONDS):
            progress.show(control.progress())
        progress.close(control.progress())
        return run.result()
