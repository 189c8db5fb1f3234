# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing run, watched by Qt's event loop: FreeCAD stays usable meanwhile."""
from PySide import QtCore

from freecad.fgmesh import core
from freecad.fgmesh.fem.background import BackgroundRun

POLL_MILLISECONDS = 100


class MeshRunner(QtCore.QObject):
    """At most one run at a time. `progressed` gives (stage, fraction, tetrahedra); `finished` the BackgroundRun,
    which the receiver closes; `failed` the error."""

    progressed = QtCore.Signal(str, float, int)
    finished = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._run = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MILLISECONDS)
        self._timer.timeout.connect(self._poll)

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
        if self.running:
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
        self._run = None
        try:
            run.result()
        except (core.Error, RuntimeError) as error:
            run.close()
            self.failed.emit(error)
        else:
            self.finished.emit(run)
