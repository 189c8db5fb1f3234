# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing run, watched by Qt's event loop: FreeCAD stays usable meanwhile."""
import time

from PySide import QtCore

from freecad.fgmesh import core
from freecad.fgmesh.fem.background import BackgroundRun

POLL_MILLISECONDS = 100
_SLICE_SECONDS = 0.05

STORING = "storing"
"""The stage behind those of a run, in which the Fem mesh is made."""


class MeshRunner(QtCore.QObject):
    """At most one run at a time. `progressed` gives (stage, fraction, tetrahedra); `finished` the BackgroundRun,
    which the receiver closes; `failed` the error."""

    progressed = QtCore.Signal(str, float, int)
    finished = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._run = self._steps = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MILLISECONDS)
        self._timer.timeout.connect(self._poll)
        self._preparing = QtCore.QTimer(self)  # without an interval: whenever FreeCAD has nothing else to do
        self._preparing.timeout.connect(self._prepare)

    @property
    def running(self):
        return self._run is not None

    def start(self, solid, values, limits=(0.0, 0.0)):
        """limits: seconds and MB, 0 for none. Raises what BackgroundRun does."""
        control = core.RunControl()
        control.set_limits(*limits)
        self._run = BackgroundRun(solid, values, control)
        self._timer.start()

    def cancel(self):
        """The run ends within a tenth of a second; `failed` tells that it was cancelled."""
        if self._steps is not None:
            self._fail(core.Cancelled("the run was cancelled"))
        elif self.running:
            self._run.control.cancel()
            self._poll()

    def _poll(self):
        run = self._run
        ended = run.wait()
        progress = run.control.progress()
        self.progressed.emit(progress.stage, progress.fraction, progress.tets)
        if not ended:
            return
        self._timer.stop()
        try:
            self._steps = run.request.prepare(run.result())
        except (core.Error, RuntimeError) as error:
            self._fail(error)
        else:
            self._preparing.start()

    def _prepare(self):
        """Has the Fem mesh made bit by bit, which takes seconds where it is large."""
        end = time.monotonic() + _SLICE_SECONDS
        tets = len(self._run.result().tets)
        for done in self._steps:
            if time.monotonic() > end:
                self.progressed.emit(STORING, done, tets)
                return
        self._preparing.stop()
        run, self._run, self._steps = self._run, None, None
        self.finished.emit(run)

    def _fail(self, error):
        self._preparing.stop()
        run, self._run, self._steps = self._run, None, None
        run.close()
        self.failed.emit(error)
