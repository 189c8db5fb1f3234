# SPDX-License-Identifier: GPL-3.0-or-later
"""A line below a field that says how things stand."""
from PySide import QtCore, QtGui

from freecad.fgmesh.view.texts import in_user_units

# With a background of their own, as style sheets of FreeCAD have any: no other colour is readable on all of them.
_LOOK = "QLabel {{ color: {}; background-color: {}; border-radius: 3px; padding: 3px; }}"
_ERROR = _LOOK.format("#9c1118", "#fde7e7")
_PLAIN = "QLabel { background-color: transparent; }"
_WARNING = _LOOK.format("#704300", "#fff0cc")


class MessageLabel(QtGui.QLabel):
    """Wrapped text in the colours of its gravity, its lengths in the user's units. `kind` is what it shows: "", "error" or "warning"."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.kind = ""
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.PlainText)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def say(self, text):
        self._show(text, "", _PLAIN)

    def warn(self, text):
        self._show(text, "warning", _WARNING)

    def complain(self, text):
        self._show(text, "error", _ERROR)

    def _show(self, text, kind, look):
        self.kind = kind
        if look != self.styleSheet():
            self.setStyleSheet(look)
        self.setText(in_user_units(text))
        if self.isVisible():
            self._fit()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._fit()

    def _fit(self):
        """As high as the text needs: FreeCAD's task view does not always ask again when that changes."""
        self.setMinimumHeight(max(self.heightForWidth(self.width()), 0))
