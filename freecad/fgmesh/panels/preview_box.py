# SPDX-License-Identifier: GPL-3.0-or-later
"""The controls of the preview: what is shown, and where the solid is cut open."""
import numpy as np
from PySide import QtCore, QtGui

from freecad.fgmesh import core, worker
from freecad.fgmesh.model.preview_shape import surface_request
from freecad.fgmesh.model.shown_quantities import shown_quantities
from freecad.fgmesh.panels.live_field import LiveField
from freecad.fgmesh.panels.quiet import quiet
from freecad.fgmesh.panels.section_controls import SectionControls
from freecad.fgmesh.panels.wide_combo import WideCombo
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.preview import Preview
from freecad.fgmesh.view.texts import number_text, translate


_ROUNDING = 1e-12
_POLL_MILLISECONDS = 40


def range_text(ranges):
    """What `PreviewBox.looked_at` gives, in words. Of two constituents the first tells all."""
    ranges = np.where(np.abs(ranges) < _ROUNDING, 0.0, ranges)  # of a remainder
    spans = [
        translate("{} to {}").format(number_text(low, ".4g"), number_text(high, ".4g"))
        for low, high in ranges
    ]
    return translate("On the solid: {}").format(spans[0] if len(spans) == 2 else ", ".join(spans))


class PreviewBox(QtGui.QGroupBox):
    """Shows a solid coloured by its material. `looked_at` gives the lowest and the highest of each fraction, (k, 2),
    over the solid, inside and on its boundary, and the share of it where one is undefined; `failed` a core.Error.

    The solid is triangulated in a child process: colours and ranges come as soon as that has answered.
    """

    looked_at = QtCore.Signal(object, float)
    failed = QtCore.Signal(object)

    def __init__(self, solid, parent=None):
        super().__init__(translate("Show the material"), parent)
        self.setWindowTitle(translate("Preview"))
        self.setWindowIcon(QtGui.QIcon(icon("preview")))
        self.setObjectName("FGMeshPreview")
        self._solid, self._preview = solid, None
        self._surface = self._samples = self._fractions = None
        self._run = worker.start_surface(*surface_request(solid))
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(_POLL_MILLISECONDS)
        self._poll.timeout.connect(self._look_for_surface)
        self._poll.start()
        self._field = LiveField(self)
        self._field.ready.connect(self._show)
        self._field.failed.connect(self.failed)
        self.setToolTip(translate("Colours the solid in the 3D view"))
        self.setCheckable(True)
        self.setChecked(False)
        self.toggled.connect(self._toggle)
        self._quantities, self._count = [], 2
        self.quantity = WideCombo("FGMeshQuantity")
        self.quantity.setToolTip(
            translate("What the colours tell: a volume fraction, or a property of the mixture")
        )
        self.quantity.currentIndexChanged.connect(lambda: self._colour())
        self.section = SectionControls(solid, solid.Shape.BoundBox, "Section")
        self.section.changed.connect(self._cut)
        self.drag = QtGui.QCheckBox(translate("Drag in the view"))
        self.drag.setObjectName("FGMeshDragSection")
        self.drag.setToolTip(translate("Shows a handle by which the mouse shifts and turns the cut"))
        self.drag.toggled.connect(self._cut)
        self._lay_out()
        self.set_constituents([])

    def set_constituents(self, names, count=2):
        """How many constituents there are, and their names where they have some: from these follows what can be
        shown."""
        chosen, self._count = max(self.quantity.currentIndex(), 0), count
        with quiet(self.quantity):
            self._quantities = shown_quantities([name for name in names if name], count, self._solid.Document)
            self.quantity.clear()
            self.quantity.addItems([quantity.title(translate) for quantity in self._quantities])
            self.quantity.setCurrentIndex(min(chosen, len(self._quantities) - 1))
        self._colour()

    def set_materials(self, materials):
        """The core.Material of each solid, or one for all, as a list; empty where the formula is wrong: then
        nothing is shown in place of what it was before."""
        self._field.update(materials)
        if not materials and self._preview is not None:
            self._fractions = np.full((len(self._preview.points), self._count), np.nan)
            self._colour()

    def close_preview(self):
        """Leaves the view as it was."""
        self._field.close()
        self._end_run()
        if self._preview is not None:
            self._preview.close()
        self._preview = None

    def showEvent(self, event):
        super().showEvent(event)
        if self._fractions is None:
            self._new_points()

    def _look_for_surface(self):
        if not self._run.wait(0.0):
            return
        try:
            self._surface, self._samples = self._run.result()
        except (core.Error, RuntimeError) as error:
            self.failed.emit(error)
        self._end_run()
        if self._surface is None:
            return
        self._waiting.hide()
        if self.isChecked():
            self._toggle(True)
        else:
            self._new_points()

    def _end_run(self):
        self._poll.stop()
        if self._run is not None:
            self._run.close()
        self._run = None

    def _lay_out(self):
        form = QtGui.QFormLayout(self)
        form.setContentsMargins(4, 10, 4, 4)  # less would cut the title
        form.addRow(translate("Show"), self.quantity)
        form.addRow(translate("Section"), self.section)
        form.addRow("", self.drag)
        self._waiting = QtGui.QLabel(translate("The solid is being triangulated"))
        form.addRow(self._waiting)
        self._cut()

    def _toggle(self, on):
        if self._surface is None:
            return
        if on:
            self._preview = Preview(self._solid, on_new_points=self._new_points, surface=self._surface)
        elif self._preview is not None:
            self._preview.close()
            self._preview = None
        self._cut()
        self._new_points()

    def _new_points(self):
        if self._samples is None:
            return
        points, solids = self._samples
        if self._preview is not None:
            points = np.concatenate([self._preview.points, points])
            solids = np.concatenate([self._preview.solids, solids])
        self._field.set_points(points, solids)

    def _show(self, fractions):
        self._fractions = fractions
        defined = fractions[np.isfinite(fractions).all(axis=1)]
        missing = 1 - len(defined) / max(len(fractions), 1)
        self._colour()
        ranges = np.full((fractions.shape[1], 2), np.nan)
        if len(defined):
            ranges = np.column_stack([defined.min(axis=0), defined.max(axis=0)])
        self.looked_at.emit(ranges, missing)

    def _colour(self):
        if self._preview is None or self._fractions is None:
            return
        rows, columns = self._fractions.shape
        if rows < len(self._preview.points) or columns < self._count:
            return  # others are under way
        quantity = self._quantities[max(self.quantity.currentIndex(), 0)]
        values = quantity.values(self._fractions[: len(self._preview.points)])
        self._preview.set_values(values, quantity.title(translate), *quantity.range)

    def _cut(self):
        """Cuts the solid as the controls say."""
        plane = self.section.plane()
        self.drag.setEnabled(self._preview is not None and plane is not None)
        if self._preview is not None:
            self._preview.section = plane
            self._preview.drag_section(plane is not None and self.drag.isChecked())
