# SPDX-License-Identifier: GPL-3.0-or-later
"""A combo box for texts of any length."""
from PySide import QtGui

_LENGTH = 18


class WideCombo(QtGui.QComboBox):
    """As wide as there is room: its longest text may be wider than FreeCAD's dock. The usual ones are seen whole."""

    def __init__(self, name, parent=None):
        super().__init__(parent)
        self.setObjectName(name)
        self.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LENGTH)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
