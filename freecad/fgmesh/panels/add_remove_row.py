# SPDX-License-Identifier: GPL-3.0-or-later
"""The two buttons below a list."""
from PySide import QtGui

from freecad.fgmesh.view.texts import translate


class AddRemoveRow(QtGui.QHBoxLayout):
    """The buttons `add` and `remove`, called FGMeshAdd + `name` and FGMeshRemove + `name`; what they do is their owner's."""

    def __init__(self, name):
        super().__init__()
        self.add = self._button(f"FGMeshAdd{name}", translate("Add"))
        self.remove = self._button(f"FGMeshRemove{name}", translate("Remove"))
        self.add.setToolTip(translate("Adds an entry at the end"))
        self.remove.setToolTip(translate("Removes the selected entry, or else the last one"))
        self.addStretch()

    def _button(self, name, text):
        button = QtGui.QPushButton(text)
        button.setObjectName(name)
        self.addWidget(button)
        return button
