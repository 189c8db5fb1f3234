# SPDX-License-Identifier: GPL-3.0-or-later
"""Showing a task panel where there is room for it."""
import FreeCADGui
from PySide import QtCore, QtGui

_MARGIN = 60
"""Of FreeCAD's task view around a panel: frames, indents and the scroll bar."""


def show(panel):
    """Shows `panel`, and makes the dock of the task view wide enough for it where it is too narrow."""
    FreeCADGui.Selection.clearSelection()  # its colour would lie upon those of previews and meshes
    FreeCADGui.Control.showDialog(panel)
    QtCore.QTimer.singleShot(0, lambda: _widen(panel))


def _widen(panel):
    forms = panel.form if isinstance(panel.form, list) else [panel.form]
    try:
        needed = max(form.minimumSizeHint().width() for form in forms) + _MARGIN
        dock = forms[0].parentWidget()
        while dock is not None and not isinstance(dock, QtGui.QDockWidget):
            dock = dock.parentWidget()
    except RuntimeError:  # the panel was closed at once
        return
    if dock is not None and dock.width() < needed:
        FreeCADGui.getMainWindow().resizeDocks([dock], [needed], QtCore.Qt.Horizontal)
