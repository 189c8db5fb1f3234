# SPDX-License-Identifier: GPL-3.0-or-later
"""Where something shown in the 3D view is cut open: an axis, and a place along it."""
import FreeCAD
from PySide import QtCore, QtGui

from freecad.fgmesh.model.frames import global_placement
from freecad.fgmesh.view.preview import view_of
from freecad.fgmesh.view.texts import translate

_AXES = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
_STEPS = 200


class SectionControls(QtGui.QWidget):
    """`changed` tells of another plane. The cut faces the viewer: what is in front of it goes.

    thing   an object with a Placement; the plane is in the coordinates which that leads to
    box     FreeCAD.BoundBox of what is cut, in the same coordinates
    """

    changed = QtCore.Signal()

    def __init__(self, thing, box, name, parent=None):
        super().__init__(parent)
        self._thing, self._box, self._normal = thing, box, None
        self.axis = QtGui.QComboBox()
        self.axis.setObjectName(f"FGMesh{name}Axis")
        self.axis.addItems([translate("whole"), *_AXES])
        self.axis.setToolTip(translate("Cuts it open across this axis"))
        self.place = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.place.setObjectName(f"FGMesh{name}Place")
        self.place.setToolTip(translate("Shifts the cut along its axis"))
        self.place.setRange(1, _STEPS - 1)
        self.place.setValue(_STEPS // 2)
        self.axis.currentIndexChanged.connect(self._choose_axis)
        self.place.valueChanged.connect(lambda: self.changed.emit())
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.axis)
        row.addWidget(self.place, 1)
        self._choose_axis()

    def plane(self):
        """(origin, normal), FreeCAD.Vectors; None where nothing is cut."""
        if self._normal is None:
            return None
        low = FreeCAD.Vector(self._box.XMin, self._box.YMin, self._box.ZMin)
        high = FreeCAD.Vector(self._box.XMax, self._box.YMax, self._box.ZMax)
        return low + (high - low) * (self.place.value() / _STEPS), self._normal

    def _choose_axis(self):
        name = self.axis.currentText()
        self._normal = self._towards_viewer(FreeCAD.Vector(*_AXES[name])) if name in _AXES else None
        self.place.setEnabled(self._normal is not None)
        self.changed.emit()

    def _towards_viewer(self, axis):
        # Of a copy: to ask a property's own rotation for something marks the document as modified.
        own = FreeCAD.Placement(self._thing.Placement)
        turned = global_placement(self._thing).multiply(own.inverse()).Rotation
        away = view_of(self._thing).getViewDirection().dot(turned.multVec(axis)) > 0
        return axis * -1 if away else axis
