# SPDX-License-Identifier: GPL-3.0-or-later
"""A line below a field that says how things stand."""
from PySide import QtCore, QtGui

_ERROR, _WARNING = "#e01b24", "#c07000"


class MessageLabel(QtGui.QLabel):
    """Wrapped text in the colour of its gravity. `kind` is what it shows: "", "error" or "warning"."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.kind = ""
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.PlainText)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def say(self, text):
        self._show(text, "", "")

    def warn(self, text):
        self._show(text, "warning", _WARNING)

    def complain(self, text):
        self._show(text, "error", _ERROR)

    def _show(self, text, kind, colour):
        self.kind = kind
        self.setText(text)
        self.setStyleSheet(f"color: {colour}" if colour else "")
