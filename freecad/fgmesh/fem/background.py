# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing that does not block: started for a solid and options, asked now and then, adopted by generate().

The document is only read at the start; nothing is in it before generate() stores the mesh. So a run that is
cancelled, or fails, leaves no trace.
"""
import Fem
import numpy as np

from freecad.fgmesh import core, worker
from freecad.fgmesh.fem.fem_mesh import fill
from freecad.fgmesh.model import fingerprint, graded_parts, mesh_object
from freecad.fgmesh.model.options import meshing_options, option_values
from freecad.fgmesh.model.references import stored_links
from freecad.fgmesh.model.shapes import brep_text

_adopted = []
"""The finished run that the next generate() may store: at most one."""


class Request:
    """What a mesh of `solid` with the option values `values` (`options.option_values`) is made from, as it is in
    the document now. Raises core.InvalidInput, core.GeometryError."""

    def __init__(self, solid, values):
        make_ready(solid)
        self.solid, self.values = solid, values
        self.taken = fingerprint.take(solid, values)
        self.arguments = brep_text(solid.Shape), graded_parts.materials_of(solid), meshing_options(values)
        self._fem_mesh = self._steps = None

    def prepare(self, result):
        """Yields again and again, after some hundredths of a second each, while the Fem mesh of `result`, which came of
        this request, is made: the share that is done. What is not done then, store() does."""
        if self._steps is None:
            self._fem_mesh = Fem.FemMesh()
            self._steps = fill(self._fem_mesh, result, self.values["Groups"])
        yield from self._steps

    def store(self, mesh, result):
        """Puts `result` into the mesh object."""
        for _ in self.prepare(result):
            pass
        mesh_object.store(mesh, self._fem_mesh, core.report(result), result.fractions, self.taken)
        mesh.Proxy.kept.arrays = mesh.Fingerprint, (np.array(result.points), np.array(result.tets))


class BackgroundRun:
    """A run in a child process. `control` shows its progress and cancels it while wait() is called."""

    def __init__(self, solid, values, control=None):
        self.request = Request(solid, values)
        self.control = control or core.RunControl()
        self._run = worker.start(*self.request.arguments, self.control)
        self._result = None  # read once, however often it is asked for

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def wait(self, seconds=0.0):
        """True as soon as the run has ended; False after so many seconds. To be called every half second."""
        return self._run.wait(seconds)

    def result(self):
        """The core.MeshingResult of a run that has ended; raises core.Error where it came to nothing."""
        if self._result is None:
            self._result = self._run.result()
        return self._result

    def close(self):
        """Ends the child where it still runs. May be called twice."""
        self._run.close()


def adopt(run):
    """Has the next generate() store what `run`, which has ended well, has made, if it is for a mesh of the same
    solid with the same options: in a macro the same call meshes anew."""
    _adopted[:] = [(run.request, run.result())]


def adopted(mesh):
    """(Request, core.MeshingResult) that adopt() has left for `mesh`, once; None where there is none."""
    while _adopted:
        request, result = _adopted.pop()
        if request.solid == mesh.Shape and request.values == option_values(mesh):
            return request, result
    return None


def make_ready(solid):
    """Computes `solid` and what its material refers to where they wait for a recompute."""
    if solid is None:
        raise core.InvalidInput("the mesh has lost its solid: set its Shape to a graded solid")
    # The links of references are no dependencies, so that a solid can refer to its own faces.
    links = [link for part, _ in graded_parts.graded_parts(solid) for link in stored_links(part)]
    for thing in dict.fromkeys([*(thing for thing, name in links), solid]):
        if any("Touched" in needed.State for needed in [thing, *thing.OutListRecursive]):
            thing.recompute(True)
    if not solid.isValid():
        raise core.GeometryError(f"{solid.Label} cannot be computed: repair it in FreeCAD first")
    if solid.Shape.isNull() or not solid.Shape.Solids:
        raise core.GeometryError(f"{solid.Label} has no solid to mesh: make a solid of it first")
