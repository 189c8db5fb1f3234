# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing in a child process: what OpenCASCADE and CGAL do to a bad shape stays there.

    from freecad.fgmesh import core, worker
    result = worker.generate_mesh("part.step", material, options)

`generate_mesh` is `core.generate_mesh` but for three things: a crash is an error (`Crashed`), cancelling and
limits end even a run that listens to nothing, and without a memory limit there is one nevertheless, of nine
tenths of what is available at the start. It takes a tenth of a second longer, to start the process. `start`
does not wait, and gives a `Run` to be asked now and then.
"""
from freecad.fgmesh.worker.run import Crashed, Run, generate_mesh, start

__all__ = ["Crashed", "Run", "generate_mesh", "start"]
