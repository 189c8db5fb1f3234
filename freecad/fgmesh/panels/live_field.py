# SPDX-License-Identifier: GPL-3.0-or-later
"""Fractions at points of a solid, again and again while its material is edited.

Formulas are evaluated here. Distances to references are measured in a child process, where a bad shape does no
harm, and kept for as long as points and references stay the same: typing a formula needs no new ones.
"""
import numpy as np
from PySide import QtCore

from freecad.fgmesh import core, worker

POLL_MILLISECONDS = 40


class LiveField(QtCore.QObject):
    """`ready` gives the fractions (n, k) of the latest request, `failed` a core.Error."""

    ready = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._points, self._solids, self._materials = np.empty((0, 3)), np.empty(0, int), []
        self._distances = {}  # {references: (n, r) of the points at hand}
        self._run = self._asked = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MILLISECONDS)
        self._timer.timeout.connect(self._poll)

    def set_points(self, points, solids):
        """Where fractions are wanted, (n, 3), and the 0-based solid of each, (n,)."""
        self._points, self._solids = points, solids
        self._distances.clear()
        self._stop()
        self.update(self._materials)

    def update(self, materials):
        """materials: a list with the core.Material of each solid, or with one for all. Answers by a signal."""
        self._materials = materials
        if not len(self._points):
            return  # they are under way
        needed = next((key for key in map(_key, materials) if key and key not in self._distances), None)
        if needed is None:
            if materials:
                self.ready.emit(self._evaluate())
        elif self._asked != needed:
            self._stop()
            references = next(one.references for one in materials if _key(one) == needed)
            self._run, self._asked = worker.start_distances(references, self._points), needed
            self._timer.start()

    def close(self):
        """Ends a child that still runs; nothing more is answered."""
        self._materials = []
        self._stop()

    def _poll(self):
        if not self._run.wait(0.0):
            return
        try:
            self._distances[self._asked] = self._run.result()
        except (core.Error, RuntimeError) as error:
            self._stop()
            self.failed.emit(error)
            return
        self._stop()
        self.update(self._materials)

    def _stop(self):
        self._timer.stop()
        if self._run is not None:
            self._run.close()
        self._run = self._asked = None

    def _evaluate(self):
        if len(self._materials) == 1:
            return self._values(self._materials[0], slice(None))
        most = max((len(material.fractions) + 1 for material in self._materials), default=2)
        fractions = np.full((len(self._points), most), np.nan)
        for number, material in enumerate(self._materials):
            chosen = self._solids == number
            values = self._values(material, chosen)
            fractions[chosen] = 0.0  # a constituent that a material has not
            fractions[chosen, : values.shape[1]] = values
        return fractions

    def _values(self, material, chosen):
        points = self._points[chosen]
        if not material.references:
            return material.evaluate(points)
        return material.evaluate(points, self._distances[_key(material)][chosen])


def _key(material):
    """What distances are kept by; the empty tuple for a material without references."""
    return tuple((one.shape, one.name) for one in material.references)
