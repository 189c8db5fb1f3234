# SPDX-License-Identifier: GPL-3.0-or-later
"""A table that is always seen as a whole."""
from PySide import QtCore, QtGui


class WholeTable(QtGui.QTableWidget):
    """As large as its cells, in whatever style sheet; the panel around it scrolls."""

    def __init__(self, rows, columns, parent=None):
        super().__init__(rows, columns, parent)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setSizePolicy(QtGui.QSizePolicy.Minimum, QtGui.QSizePolicy.Fixed)

    def sizeHint(self):
        frame = 2 * self.frameWidth() + 2
        across, down = self.horizontalHeader(), self.verticalHeader()
        width = across.length() + (down.width() if down.isVisible() else 0)
        return QtCore.QSize(width + frame, down.length() + across.sizeHint().height() + frame)

    def minimumSizeHint(self):
        return self.sizeHint()

    def showEvent(self, event):
        super().showEvent(event)
        self.updateGeometry()  # style sheets have set fonts and margins by now
