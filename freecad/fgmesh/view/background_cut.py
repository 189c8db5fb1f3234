# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections through surfaces with many details, made in a thread while FreeCAD's window goes on."""
import threading

import numpy as np
from PySide import QtCore

from freecad.fgmesh.surfaces import section

_QUICK = 4000  # triangles that the plane meets; some tenths of a second
_POLL_MILLISECONDS = 30


class BackgroundCut(QtCore.QObject):
    """`take` is called with the section.Section of the latest plane that was asked for, in the thread of the window."""

    def __init__(self, take):
        super().__init__()
        self._take, self._thread, self._asked, self._found = take, None, None, None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_POLL_MILLISECONDS)
        self._timer.timeout.connect(self._look)

    def cut(self, surface, origin, normal, limit):
        """As section.cut(); at once where that is quick."""
        self._asked = surface, tuple(origin), tuple(normal), limit
        if self._thread is None and _is_quick(*self._asked[:3]):
            asked, self._asked = self._asked, None
            self._take(section.cut(*asked))
        elif self._thread is None:
            self._begin()

    def stop(self):
        """Nothing more is taken."""
        self._asked = self._found = self._thread = None
        self._timer.stop()

    def _begin(self):
        asked, self._asked, self._found = self._asked, None, None
        self._thread = threading.Thread(target=self._work, args=asked, daemon=True)
        self._thread.start()
        self._timer.start()

    def _work(self, *asked):
        found = section.cut(*asked)
        if self._thread is threading.current_thread():
            self._found = found

    def _look(self):
        if self._thread.is_alive():
            return
        self._timer.stop()
        self._thread = None
        if self._asked is not None:
            self._begin()
        elif self._found is not None:
            self._take(self._found)


def _is_quick(surface, origin, normal):
    is_above = (surface.points - np.array(origin)) @ np.array(normal) > 0
    above = is_above[surface.triangles].sum(axis=1)
    return ((above > 0) & (above < 3)).sum() <= _QUICK
