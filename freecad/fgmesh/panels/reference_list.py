# SPDX-License-Identifier: GPL-3.0-or-later
"""The references of a formula: what d1, d2, ... are the distances to."""
from PySide import QtCore

from freecad.fgmesh.panels.numbered_list import NumberedList
from freecad.fgmesh.view.selection import Picker
from freecad.fgmesh.view.texts import translate


class ReferenceList(NumberedList):
    """Its entries are pairs: object, name of a part or ""."""

    def __init__(self, parent=None):
        super().__init__("d", "Reference", parent)
        self._picker = Picker(self._picked)
        self._wanted = 0
        self.list.setToolTip(
            translate("d1 is the distance to the first of them, d2 to the second, and so on")
        )
        self.add.setCheckable(True)
        self.add.setToolTip(
            translate("Then click on a face, an edge or a vertex in the 3D view, or on a solid in the tree")
        )
        self.add.toggled.connect(self._toggle_picking)

    def pick_until(self, count):
        """Waits for clicks until there are `count` references."""
        self._wanted = count
        if len(self._entries) < count:
            self.add.setChecked(True)
        self._show()

    def stop_picking(self):
        self._wanted = 0
        self.add.setChecked(False)

    def _toggle_picking(self, on):
        if on:
            self._picker.start()
        else:
            self._picker.stop()
        self._show()

    def _picked(self, thing, name):
        self.add.setChecked(False)
        if len(self._entries) + 1 < self._wanted:
            # Not at once: FreeCAD is still telling its observers of this click.
            QtCore.QTimer.singleShot(0, lambda: self.add.setChecked(True))
        self._append([(thing, name)])

    def _text(self, entry):
        thing, name = entry
        return f"{thing.Label}{'.' if name else ''}{name}"

    def _show(self):
        number = len(self._entries) + 1
        self.add.setText(
            translate("Click on d{} ...").format(number) if self.add.isChecked() else translate("Add")
        )
        super()._show()
