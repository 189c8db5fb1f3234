# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a mesh as fields."""
from PySide import QtCore, QtGui

from freecad.fgmesh.model.options import GROUP_KINDS, OPTIONS
from freecad.fgmesh.panels.length_edit import LengthEdit
from freecad.fgmesh.panels.quiet import quiet
from freecad.fgmesh.view.texts import translate

_TIPS = {option.property: option.tip for option in OPTIONS}


class MeshOptionsBox(QtGui.QWidget):
    """Shows and gives values as `options.option_values` does. `edited` tells of changes by the user."""

    edited = QtCore.Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self._values = {}
        self.threshold = QtGui.QDoubleSpinBox()
        self.threshold.setRange(0.001, 1.0)
        self.threshold.setDecimals(4)
        self.threshold.setSingleStep(0.01)
        self.lengths = {
            "SurfaceDeviation": LengthEdit("SurfaceDeviation"),
            "MinSize": LengthEdit("MinSize"),
            "MaxSize": LengthEdit("MaxSize"),
        }
        self.anisotropy = QtGui.QDoubleSpinBox()
        self.anisotropy.setRange(1.0, 10.0)
        self.anisotropy.setSingleStep(0.5)
        self.order = QtGui.QCheckBox(translate("Ten-node tetrahedra"))
        self.certify = QtGui.QCheckBox(translate("Prove the threshold between corners"))
        self.groups = {kind: QtGui.QCheckBox(title) for kind, title in _group_titles().items()}
        self._lay_out()
        self._connect()

    def set_values(self, values):
        """Shows `values`; tells nobody."""
        with quiet(self):
            self._values = dict(values)
            self.threshold.setValue(values["MaterialThreshold"])
            for name, field in self.lengths.items():
                field.set_length(values[name])
            self.anisotropy.setValue(values["Anisotropy"])
            self.order.setChecked(values["SecondOrder"])
            self.certify.setChecked(values["Certify"])
            for kind, box in self.groups.items():
                box.setChecked(kind in values["Groups"])

    def values(self):
        """{property: value}. Raises core.InvalidInput that names the field which is wrong."""
        threshold = self.threshold.value()
        given = self._values["MaterialThreshold"]
        return {
            **self._values,
            # Finer than the field shows, a value that nobody has touched stays.
            "MaterialThreshold": given if round(given, self.threshold.decimals()) == threshold else threshold,
            **{name: field.length() for name, field in self.lengths.items()},
            "Anisotropy": self.anisotropy.value(),
            "SecondOrder": self.order.isChecked(),
            "Certify": self.certify.isChecked(),
            "Groups": [kind for kind, box in self.groups.items() if box.isChecked()],
        }

    def _lay_out(self):
        form = QtGui.QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        rows = {
            "MaterialThreshold": (translate("Material threshold"), self.threshold),
            "SurfaceDeviation": (translate("Surface deviation"), self.lengths["SurfaceDeviation"]),
            "MinSize": (translate("Smallest size"), self.lengths["MinSize"]),
            "MaxSize": (translate("Largest size"), self.lengths["MaxSize"]),
            "Anisotropy": (translate("Anisotropy"), self.anisotropy),
            "SecondOrder": ("", self.order),
            "Certify": ("", self.certify),
        }
        for name, (title, field) in rows.items():
            field.setObjectName(f"FGMesh{name}")
            field.setToolTip(translate(_TIPS[name]))
            form.addRow(title, field)
        grid = QtGui.QGridLayout()
        for place, (kind, box) in enumerate(self.groups.items()):
            box.setObjectName(f"FGMeshGroup{kind}")
            box.setToolTip(
                translate("The mesh gets a group of elements for each of these parts of the shape")
            )
            grid.addWidget(box, place // 2, place % 2)
        form.addRow(translate("Groups"), grid)

    def _connect(self):
        self.threshold.valueChanged.connect(lambda: self.edited.emit())
        self.anisotropy.valueChanged.connect(lambda: self.edited.emit())
        for field in self.lengths.values():
            field.textChanged.connect(lambda: self.edited.emit())
        for box in (self.order, self.certify, *self.groups.values()):
            box.toggled.connect(lambda: self.edited.emit())


def _group_titles():
    titles = translate("solids"), translate("faces"), translate("edges"), translate("vertices")
    return dict(zip(GROUP_KINDS, titles))
