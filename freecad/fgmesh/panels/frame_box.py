# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the material's frame stands: numbers, or picked in the 3D view."""
import math

import FreeCAD
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.model.frames import frame_from
from freecad.fgmesh.panels.length_edit import read_length
from freecad.fgmesh.view.selection import Picker
from freecad.fgmesh.view.texts import length_text, translate

_Z = FreeCAD.Vector(0, 0, 1)
_DIGITS = 9  # more would show the rounding of rotations


class FrameBox(QtGui.QWidget):
    """Origin and z axis in the solid's own coordinates. `edited` tells of changes by the user, `failed` a text."""

    edited = QtCore.Signal()
    failed = QtCore.Signal(str)

    def __init__(self, solid, parent=None):
        super().__init__(parent)
        self._solid = solid
        self._frame = FreeCAD.Placement()
        self._wrong = ""  # why what is written is no frame
        self._picker = Picker(self._picked)
        self.origin, self.axis = QtGui.QLineEdit(), QtGui.QLineEdit()
        self.origin.setObjectName("FGMeshFrameOrigin")
        self.axis.setObjectName("FGMeshFrameAxis")
        self.origin.setToolTip(
            translate(
                "Origin of the frame in the solid's own coordinates: x, y, z, with or without units, as in 0, 0, 1 in"
            )
        )
        self.axis.setToolTip(translate("Direction of the frame's z axis: x, y, z"))
        self.origin.editingFinished.connect(self._typed)
        self.axis.editingFinished.connect(self._typed)
        self.pick = QtGui.QPushButton(translate("Pick"))
        self.pick.setObjectName("FGMeshPickFrame")
        self.pick.setCheckable(True)
        self.pick.setToolTip(
            translate(
                "Then click on a face, an edge, a vertex, a datum or a coordinate system: the frame stands "
                "there, its z axis along the normal or the axis"
            )
        )
        self.pick.toggled.connect(self._toggle_picking)
        reset = QtGui.QPushButton(translate("Reset"))
        reset.setObjectName("FGMeshResetFrame")
        reset.setToolTip(translate("The solid's own coordinates"))
        reset.clicked.connect(lambda: self._take(FreeCAD.Placement()))
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        for row, (title, field, button) in enumerate(
            ((translate("Origin"), self.origin, self.pick), (translate("z axis"), self.axis, reset))
        ):
            grid.addWidget(QtGui.QLabel(title), row, 0)
            grid.addWidget(field, row, 1)
            grid.addWidget(button, row, 2)
        self.set_frame(self._frame)

    def frame(self):
        """Raises core.InvalidInput where what is written is none."""
        if self._wrong:
            raise core.InvalidInput(self._wrong)
        return self.last()

    def last(self):
        """The frame, or the last one where what is written now is none."""
        return FreeCAD.Placement(self._frame)

    def set_frame(self, frame):
        """Shows `frame`; tells nobody."""
        self._frame, self._wrong = FreeCAD.Placement(frame), ""
        self.origin.setText(_lengths_text(frame.Base))
        self.axis.setText(_text(frame.Rotation.multVec(_Z)))

    def stop_picking(self):
        self.pick.setChecked(False)

    def _toggle_picking(self, on):
        self.pick.setText(translate("Click ...") if on else translate("Pick"))
        if on:
            self._picker.start()
        else:
            self._picker.stop()

    def _picked(self, thing, name):
        self.stop_picking()
        try:
            self._take(frame_from(thing, name, self._solid))
        except core.Error as error:
            self.failed.emit(str(error))

    def _typed(self):
        texts = self.origin.text(), self.axis.text()
        if texts == (_lengths_text(self._frame.Base), _text(self._frame.Rotation.multVec(_Z))):
            self._take(self._frame)  # as shown: what was rounded for the eye stays as it is
            return
        try:
            origin, axis = _vector(texts[0], read_length), _vector(texts[1], float)
            if axis.Length == 0:
                raise ValueError
        except ValueError:
            self._wrong = translate(
                "Origin and z axis of the frame take three numbers each, as in 0, 0, 1, and the axis not three zeros"
            )
            self.edited.emit()
            return
        self._take(FreeCAD.Placement(origin, FreeCAD.Rotation(_Z, axis)))

    def _take(self, frame):
        self.set_frame(frame)
        self.edited.emit()


def _text(vector):
    return ", ".join(f"{round(value, _DIGITS) + 0.0:.6g}" for value in vector)


def _lengths_text(vector):
    return ", ".join(length_text(round(value, _DIGITS)) for value in vector)


def _vector(text, read):
    x, y, z = (read(part.strip()) for part in text.split(";" if ";" in text else ","))
    if not all(map(math.isfinite, (x, y, z))):
        raise ValueError
    return FreeCAD.Vector(x, y, z)
