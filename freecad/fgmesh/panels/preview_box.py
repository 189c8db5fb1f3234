# SPDX-License-Identifier: GPL-3.0-or-later
"""The controls of the preview: what is shown, and where the solid is cut open."""
import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from freecad.fgmesh.model.preview_shape import surface_of
from freecad.fgmesh.model.sample_points import sample_points
from freecad.fgmesh.model.shown_quantities import shown_quantities
from freecad.fgmesh.panels.live_field import LiveField
from freecad.fgmesh.panels.quiet import quiet
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.preview import Preview, view_of
from freecad.fgmesh.view.texts import translate

_AXES = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
_STEPS = 200


class PreviewBox(QtGui.QGroupBox):
    """Shows a solid coloured by its material. `looked_at` gives (lowest, highest, share undefined) of the fraction
    over the solid, inside and on its boundary; `failed` a core.Error."""

    looked_at = QtCore.Signal(float, float, float)
    failed = QtCore.Signal(object)

    def __init__(self, solid, parent=None):
        super().__init__(translate("Show the material"), parent)
        self.setWindowTitle(translate("Preview"))
        self.setWindowIcon(QtGui.QIcon(icon("preview")))
        self.setObjectName("FGMeshPreview")
        self._solid, self._preview = solid, None
        self._surface = surface_of(solid)
        self._samples = sample_points(self._surface)
        self._fraction = self._normal = None
        self._field = LiveField(self)
        self._field.ready.connect(self._show)
        self._field.failed.connect(self.failed)
        self.setCheckable(True)
        self.setChecked(False)
        self.toggled.connect(self._toggle)
        self._quantities = []
        self.quantity = QtGui.QComboBox()
        self.quantity.setObjectName("FGMeshQuantity")
        # Its texts are longer than the dock is wide.
        self.quantity.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
        self.quantity.currentIndexChanged.connect(lambda: self._colour())
        self.axis = QtGui.QComboBox()
        self.axis.setObjectName("FGMeshSectionAxis")
        self.axis.addItem(translate("whole"))
        self.axis.addItems(list(_AXES))
        self.axis.setToolTip(translate("Cuts the solid open across this axis"))
        self.axis.currentIndexChanged.connect(lambda: self._cut(turn=True))
        self.place = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.place.setObjectName("FGMeshSectionPlace")
        self.place.setRange(1, _STEPS - 1)
        self.place.setValue(_STEPS // 2)
        self.place.valueChanged.connect(lambda: self._cut())
        self.drag = QtGui.QCheckBox(translate("Drag in the view"))
        self.drag.setObjectName("FGMeshDragSection")
        self.drag.toggled.connect(lambda: self._cut())
        self._lay_out()
        self.set_constituents([])

    def set_constituents(self, names):
        """The names of both constituents, from which follows what can be shown."""
        chosen = max(self.quantity.currentIndex(), 0)
        with quiet(self.quantity):
            self._quantities = shown_quantities([name for name in names if name], self._solid.Document)
            self.quantity.clear()
            self.quantity.addItems([quantity.title for quantity in self._quantities])
            self.quantity.setCurrentIndex(min(chosen, len(self._quantities) - 1))
        self._colour()

    def set_materials(self, materials):
        """The core.Material of each solid, or one for all, as a list; empty where the formula is wrong: then
        nothing is shown in place of what it was before."""
        self._field.update(materials)
        if not materials and self._preview is not None:
            self._fraction = np.full(len(self._preview.points), np.nan)
            self._colour()

    def close_preview(self):
        """Leaves the view as it was."""
        self._field.close()
        if self._preview is not None:
            self._preview.close()
        self._preview = None

    def showEvent(self, event):
        super().showEvent(event)
        if self._fraction is None:
            self._new_points()

    def _lay_out(self):
        form = QtGui.QFormLayout(self)
        form.setContentsMargins(4, 4, 4, 4)
        form.addRow(translate("Show"), self.quantity)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.axis)
        row.addWidget(self.place, 1)
        form.addRow(translate("Section"), row)
        form.addRow("", self.drag)
        self._enable()

    def _toggle(self, on):
        if on:
            self._preview = Preview(self._solid, on_new_points=self._new_points, surface=self._surface)
        else:
            self._preview.close()
            self._preview = None
        self._cut()
        self._new_points()

    def _enable(self):
        cut = self.isChecked() and self.axis.currentIndex() > 0
        self.place.setEnabled(cut)
        self.drag.setEnabled(cut)

    def _new_points(self):
        points, solids = self._samples
        if self._preview is not None:
            points = np.concatenate([self._preview.points, points])
            solids = np.concatenate([self._preview.solids, solids])
        self._field.set_points(points, solids)

    def _show(self, fraction):
        self._fraction = fraction
        defined = fraction[np.isfinite(fraction)]
        missing = 1 - len(defined) / max(len(fraction), 1)
        low, high = (defined.min(), defined.max()) if len(defined) else (np.nan, np.nan)
        self._colour()
        self.looked_at.emit(low, high, missing)

    def _colour(self):
        if self._preview is None or self._fraction is None or len(self._fraction) < len(self._preview.points):
            return
        quantity = self._quantities[max(self.quantity.currentIndex(), 0)]
        fraction = self._fraction[: len(self._preview.points)]
        self._preview.set_values(quantity.values(fraction), quantity.title, *quantity.range)

    def _cut(self, turn=False):
        """Cuts the solid as the controls say; `turn`: so that the cut faces the viewer."""
        self._enable()
        if self._preview is None:
            return
        name = self.axis.currentText()
        if name not in _AXES:
            self._preview.drag_section(False)
            self._preview.section = None
            return
        if turn or self._normal is None:
            self._normal = self._towards_viewer(FreeCAD.Vector(*_AXES[name]))
        box = self._solid.Shape.BoundBox
        part = self.place.value() / _STEPS
        low, high = FreeCAD.Vector(box.XMin, box.YMin, box.ZMin), FreeCAD.Vector(box.XMax, box.YMax, box.ZMax)
        self._preview.section = low + (high - low) * part, self._normal
        self._preview.drag_section(self.drag.isChecked())

    def _towards_viewer(self, axis):
        """`axis`, or its opposite, as what lies between the cut and the viewer is to be taken away."""
        # Of a copy: to ask a property's own rotation for something marks the document as modified.
        own = FreeCAD.Placement(self._solid.Placement)
        turned = self._solid.getGlobalPlacement().multiply(own.inverse()).Rotation
        away = view_of(self._solid).getViewDirection().dot(turned.multVec(axis)) > 0
        return axis * -1 if away else axis
