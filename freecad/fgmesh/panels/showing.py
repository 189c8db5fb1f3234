# SPDX-License-Identifier: GPL-3.0-or-later
"""Showing a task panel where there is room for it."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad.fgmesh.panels.with_help import WithHelp


_selected = []
"""Names of document and object of what was selected when the panel was shown: objects may go meanwhile."""


def show(panel, command):
    """Shows `panel`, with a button that opens the help page of `command`, and makes the dock of the task view wide
    enough for it where it is too narrow."""
    _selected[:] = [(thing.Document.Name, thing.Name) for thing in FreeCADGui.Selection.getSelection()]
    FreeCADGui.Selection.clearSelection()  # its colour would lie upon those of previews and meshes
    FreeCADGui.Control.showDialog(WithHelp(panel, command))
    QtCore.QTimer.singleShot(0, lambda: _widen(panel))


def close():
    """Closes the panel. What was selected before is selected again, for the next command."""
    FreeCADGui.Control.closeDialog()
    for document, name in [] if FreeCADGui.Selection.getSelection() else _selected:
        if document in FreeCAD.listDocuments() and FreeCAD.getDocument(document).getObject(name):
            FreeCADGui.Selection.addSelection(document, name)
    _selected.clear()


def _widen(panel):
    form = panel.form[0] if isinstance(panel.form, list) else panel.form
    try:
        area = _around(form, QtGui.QScrollArea)
        dock = _around(form, QtGui.QDockWidget)
        if area is None or dock is None:
            return
        bar = area.verticalScrollBar()
        around = dock.width() - area.viewport().width() + (0 if bar.isVisible() else bar.sizeHint().width())
        # Not those of the forms alone: their titles, in which labels of the user's stand, take room, too.
        least, best = area.widget().minimumSizeHint().width(), area.widget().sizeHint().width()
    except RuntimeError:  # the panel was closed at once
        return
    window = FreeCADGui.getMainWindow()
    width = max(min(least + around, window.width() // 2), min(best + around, window.width() // 3))
    if dock.width() < width:
        window.resizeDocks([dock], [width], QtCore.Qt.Horizontal)


def _around(widget, kind):
    """The next parent of that kind; None where there is none."""
    parent = widget.parentWidget()
    while parent is not None and not isinstance(parent, kind):
        parent = parent.parentWidget()
    return parent
