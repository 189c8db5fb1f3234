# SPDX-License-Identifier: GPL-3.0-or-later
"""A field for a length, with or without a unit; empty where FGMesh is to choose."""
import FreeCAD
from PySide import QtGui

from freecad.fgmesh import core
from freecad.fgmesh.view.texts import translate


class LengthEdit(QtGui.QLineEdit):
    """0 and an empty field mean the same."""

    def __init__(self, title, parent=None):
        super().__init__(parent)
        self._title, self._shown = title, ("", 0.0)
        self.setPlaceholderText(translate("automatic"))

    def set_length(self, millimetres):
        self.setText(
            FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString if millimetres else ""
        )
        self._shown = self.text(), millimetres

    def length(self):
        """In mm. Raises core.InvalidInput that names the field."""
        text = self.text().strip()
        if not text:
            return 0.0
        if text == self._shown[0]:
            return self._shown[1]  # what was rounded for the eye stays as it is
        try:
            quantity = FreeCAD.Units.Quantity(text)
        except Exception:  # FreeCAD's parser of quantities knows many
            quantity = None
        if quantity is None or quantity.Unit not in (FreeCAD.Units.Length, FreeCAD.Units.Unit()):
            message = translate("{}: {} is no length; write for example 0.5 mm")
            raise core.InvalidInput(message.format(self._title, repr(text)))
        return float(quantity.Value)
