# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of `core` in a child process: each by a function that starts it, and by one that waits, too."""
from freecad.fgmesh.worker.run import Run
from freecad.fgmesh.worker.tasks import Estimating, Measuring, Meshing, Showing


def start(brep, material, options=None, control=None):
    """Start the child process for what `core.generate_mesh` takes. Gives the Run."""
    return Run(Meshing(brep, material, options, control), control)


def generate_mesh(brep, material, options=None, control=None):
    """As `core.generate_mesh`, in a child process. Raises Crashed, too, a GeometryError."""
    return _result(start(brep, material, options, control))


def start_estimate(brep, material, options=None, control=None):
    """Start the child process for what `core.estimate` takes. Gives the Run."""
    return Run(Estimating(brep, material, options, control), control)


def estimate(brep, material, options=None, control=None):
    """As `core.estimate`, in a child process. Raises Crashed, too, a GeometryError."""
    return _result(start_estimate(brep, material, options, control))


def start_distances(references, points, control=None):
    """Start the child process for what `core.distances` takes, best references that nobody has read. Gives the
    Run."""
    return Run(Measuring(references, points), control)


def distances(references, points, control=None):
    """As `core.distances`, in a child process; a read-only array. Raises Crashed, too, a GeometryError."""
    return _result(start_distances(references, points, control))


def start_surface(brep, diagonal, control=None):
    """Start the child process for what `surfaces.surface.shown_surface` takes. Gives the Run, whose result is the Surface
    and the (points, solids) of `surfaces.sample_points.sample_points`."""
    return Run(Showing(brep, diagonal), control)


def _result(run):
    with run:
        run.wait()
        return run.result()
