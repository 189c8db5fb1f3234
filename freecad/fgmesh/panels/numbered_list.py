# SPDX-License-Identifier: GPL-3.0-or-later
"""What a formula numbers, as a list with buttons: d1, d2, ... or t1, t2, ..."""
from PySide import QtCore, QtGui

from freecad.fgmesh.panels.add_remove_row import AddRemoveRow


class NumberedList(QtGui.QWidget):
    """`letter` stands before the numbers. The list is called FGMesh + `name` + s, its buttons FGMeshAdd + `name` and
    FGMeshRemove + `name`; what the button `add` does is a subclass's own, and so is how an entry is shown.

    `edited` tells of changes by the user.
    """

    edited = QtCore.Signal()

    def __init__(self, letter, name, parent=None):
        super().__init__(parent)
        self._letter, self._entries = letter, []
        self.list = QtGui.QListWidget()
        self.list.setObjectName(f"FGMesh{name}s")
        buttons = AddRemoveRow(name)
        self.add = buttons.add
        buttons.remove.clicked.connect(self._remove_selected)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.list)
        layout.addLayout(buttons)
        self._show()

    def entries(self):
        return list(self._entries)

    def set_entries(self, entries):
        """Shows `entries`; tells nobody."""
        self._entries = list(entries)
        self._show()

    def _text(self, entry):
        raise NotImplementedError

    def _append(self, entries):
        self._entries += entries
        self._show()
        self.edited.emit()

    def _remove_selected(self):
        if self._entries:
            row = self.list.currentRow()
            del self._entries[row if 0 <= row < len(self._entries) else -1]
            self._show()
            self.edited.emit()

    def _show(self):
        self.list.clear()
        for number, entry in enumerate(self._entries, 1):
            self.list.addItem(f"{self._letter}{number}   {self._text(entry)}")
        rows = min(self.list.count(), 4)
        self.list.setVisible(rows > 0)
        self.list.setFixedHeight(rows * (self.list.fontMetrics().height() + 4) + 6)
