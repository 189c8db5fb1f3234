# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing in a child process, with its progress shown here."""
from freecad.fgmesh import worker

POLL_SECONDS = 0.1


def watched_run(shape, material, options, progress, control):
    """`worker.generate_mesh`, shown by `progress` and bounded by the limits of `control`.

    Gives the MeshingResult or raises what worker.generate_mesh raises.
    """
    with worker.start(shape, material, options, control) as run:
        while not run.wait(POLL_SECONDS):
            progress.show(control.progress())
        progress.close(control.progress())
        return run.result()
