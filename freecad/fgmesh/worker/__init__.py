# SPDX-License-Identifier: GPL-3.0-or-later
"""A child process for what reads shapes: what OpenCASCADE and CGAL do to a bad shape stays there.

    from freecad.fgmesh import core, worker
    result = worker.generate_mesh("part.step", material, options)
    expected = worker.estimate("part.step", material, options)
    table = worker.distances(core.references("part.step", ["Face1"], read=False), points)

`generate_mesh`, `estimate` and `distances` are those of `core` but for three things: a crash is an error (`Crashed`),
cancelling and limits end even a run that listens to nothing, and without a memory limit there is one nevertheless,
of nine tenths of what is available at the start. They take a tenth of a second longer, to start the process.
`start`, `start_estimate` and `start_distances` do not wait, and give a `Run` to be asked now and then.
"""
from freecad.fgmesh.worker.functions import (
    distances,
    estimate,
    generate_mesh,
    start,
    start_distances,
    start_estimate,
    start_surface,
)
from freecad.fgmesh.worker.run import Crashed, Run, available_memory_mb

__all__ = [
    "Crashed",
    "Run",
    "available_memory_mb",
    "distances",
    "estimate",
    "generate_mesh",
    "start",
    "start_distances",
    "start_estimate",
    "start_surface",
]
