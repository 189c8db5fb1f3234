# SPDX-License-Identifier: GPL-3.0-or-later
"""The references of a formula: what d1, d2, ... are the distances to."""
from PySide import QtCore, QtGui

from freecad.fgmesh.view.selection import Picker
from freecad.fgmesh.view.texts import translate


class ReferenceList(QtGui.QWidget):
    """`edited` tells of changes by the user."""

    edited = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._links = []
        self._picker = Picker(self._picked)
        self._wanted = 0
        self.list = QtGui.QListWidget()
        self.list.setObjectName("FGMeshReferences")
        self.list.setToolTip(
            translate("d1 is the distance to the first of them, d2 to the second, and so on")
        )
        self.pick = QtGui.QPushButton(translate("Add"))
        self.pick.setObjectName("FGMeshAddReference")
        self.pick.setCheckable(True)
        self.pick.setToolTip(
            translate("Then click on a face, an edge or a vertex in the 3D view, or on a solid in the tree")
        )
        self.pick.toggled.connect(self._toggle_picking)
        remove = QtGui.QPushButton(translate("Remove"))
        remove.setObjectName("FGMeshRemoveReference")
        remove.clicked.connect(self._remove_selected)
        buttons = QtGui.QHBoxLayout()
        buttons.addWidget(self.pick)
        buttons.addWidget(remove)
        buttons.addStretch()
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.list)
        layout.addLayout(buttons)
        self._show()

    def links(self):
        """[(object, name of a part or "")]."""
        return list(self._links)

    def set_links(self, links):
        """Shows `links`; tells nobody."""
        self._links = list(links)
        self._show()

    def pick_until(self, count):
        """Waits for clicks until there are `count` references."""
        self._wanted = count
        if len(self._links) < count:
            self.pick.setChecked(True)
        self._show()

    def stop_picking(self):
        self._wanted = 0
        self.pick.setChecked(False)

    def _toggle_picking(self, on):
        if on:
            self._picker.start()
        else:
            self._picker.stop()
        self._show()

    def _picked(self, thing, name):
        self._links.append((thing, name))
        self.pick.setChecked(False)
        if len(self._links) < self._wanted:
            # Not at once: FreeCAD is still telling its observers of this click.
            QtCore.QTimer.singleShot(0, lambda: self.pick.setChecked(True))
        self._show()
        self.edited.emit()

    def _remove_selected(self):
        if self._links:
            row = self.list.currentRow()
            del self._links[row if 0 <= row < len(self._links) else -1]
            self._show()
            self.edited.emit()

    def _show(self):
        number = len(self._links) + 1
        self.pick.setText(
            translate("Click on d{} ...").format(number) if self.pick.isChecked() else translate("Add")
        )
        self.list.clear()
        for number, (thing, name) in enumerate(self._links, 1):
            self.list.addItem(f"d{number}   {thing.Label}{'.' if name else ''}{name}")
        rows = min(self.list.count(), 4)
        self.list.setVisible(rows > 0)
        self.list.setFixedHeight(rows * (self.list.fontMetrics().height() + 4) + 6)
