# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields for lengths, read and written by FreeCAD's own quantity field in the unit schema of the user."""
import functools
import math

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.view.texts import translate


_FARTHEST = 1e100
"""mm; what is farther stands for infinity."""


class _QuantityHolder(QtGui.QWidget):
    """Holds one of FreeCAD's quantity fields, for lengths.

    The field and its line are looked up again and again: PySide2 takes the Python objects of widgets that C++ has made
    for deleted as soon as that of a widget around them goes.
    """

    def __init__(self, parent=None):
        super().__init__(parent)
        field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        field.setProperty("unit", "mm")
        field.setProperty("minimum", -_FARTHEST)
        field.setProperty("maximum", _FARTHEST)
        field.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(field)

    @property
    def field(self):
        return self.findChild(QtGui.QAbstractSpinBox)

    @property
    def line(self):
        return self.findChild(QtGui.QLineEdit)

    @property
    def is_length(self):
        """False where a quantity of another kind stands in the field, as FreeCAD 1.0 lets one."""
        return self.field.property("value").Unit == FreeCAD.Units.Length

    @property
    def millimetres(self):
        return float(self.field.property("rawValue"))

    @millimetres.setter
    def millimetres(self, value):
        self.field.setProperty("rawValue", float(value))


class LengthEdit(_QuantityHolder):
    """A length, never negative; 0 and an empty field mean that FGMesh is to choose. A number without a unit counts in
    that of the user's schema, as in FreeCAD's own fields. `textChanged` tells of every key."""

    textChanged = QtCore.Signal(str)

    def __init__(self, title, parent=None):
        super().__init__(parent)
        self._title = title
        self.line.setPlaceholderText(translate("automatic"))
        self.line.textChanged.connect(self._changed)
        self.line.editingFinished.connect(self._tidy_soon)
        self.setFocusProxy(self.field)
        self.set_length(0.0)

    def setObjectName(self, name):
        """Of the field that is typed into."""
        self.field.setObjectName(name)

    def set_length(self, millimetres):
        self._is_tidying = True
        self.millimetres = millimetres
        if not millimetres:
            self.line.clear()
        self._is_tidying = False

    def length(self):
        """In mm. Raises core.InvalidInput that names the field."""
        text = self.line.text().strip()
        if not text:
            return 0.0
        shown = self.millimetres
        try:
            if read_length(text, shown) < 0:
                raise ValueError
        except ValueError:
            message = translate("{}: {} is no length; write for example 0.5 mm")
            raise core.InvalidInput(message.format(self._title, repr(text))) from None
        return shown  # with all its digits, whatever is rounded for the eye

    def showEvent(self, event):
        super().showEvent(event)
        self._tidy_soon()

    def _changed(self, text):
        if self._is_tidying:
            return
        if not text.strip():
            self.set_length(0.0)  # or FreeCAD's field would write the former value again
        self.textChanged.emit(text)

    def _tidy_soon(self):
        # FreeCAD's field writes a zero when it is shown, and when it is left.
        if not self.millimetres:
            QtCore.QTimer.singleShot(0, self._tidy)

    def _tidy(self):
        self.set_length(0.0)


@functools.lru_cache(maxsize=1)
def _reader():
    return _QuantityHolder()


def read_length(text, about=0.0):
    """The mm that `text` stands for in a quantity field of FreeCAD's that shows `about`. Raises ValueError where it is no
    length."""
    reader = _reader()
    reader.millimetres = about  # whose unit counts
    line, found = reader.line, []
    for before in ("1 mm", "2 mm"):  # what is no length leaves the value as it was
        line.setText(before)
        line.setText(text)
        found.append(reader.millimetres if reader.is_length else math.nan)
    if found[0] != found[1] or not abs(found[0]) < _FARTHEST:
        raise ValueError(text)
    return found[0]
