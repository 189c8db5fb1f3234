# SPDX-License-Identifier: GPL-3.0-or-later
"""What a solid is made of: constituents, and a formula for the volume fraction of each but the last."""
from PySide import QtCore, QtGui

from freecad.fgmesh.panels.add_remove_row import AddRemoveRow
from freecad.fgmesh.panels.formula_edit import FormulaEdit
from freecad.fgmesh.panels.wide_combo import WideCombo
from freecad.fgmesh.view.texts import translate


class CompositionBox(QtGui.QWidget):
    """Two constituents or more; `offered` are those to choose from, {name: how it is shown}, `between` is a widget to
    stand above the formulas.

    `edited` tells of a change of formulas, `renamed` of the constituents; of both where their number changes.
    """

    edited = QtCore.Signal()
    renamed = QtCore.Signal()

    def __init__(self, offered, between, parent=None):
        super().__init__(parent)
        self._offered = offered
        self._names = {shown: name for name, shown in offered.items()}
        self._combos, self._edits, self._labels = [], [], []
        self.current = 0  # index of the formula that was worked on last
        self._rows, self._formulas = QtGui.QFormLayout(), QtGui.QVBoxLayout()
        self._note = QtGui.QLabel()
        self._note.setObjectName("FGMeshConstituentNote")
        self._note.setWordWrap(True)
        self._note.hide()
        self.renamed.connect(self._tell_unknown)
        buttons = AddRemoveRow("Constituent")
        buttons.add.setToolTip(translate("One constituent more, and a formula for the one that was the last"))
        buttons.add.clicked.connect(self._add_by_hand)
        self._remove = buttons.remove
        self._remove.setToolTip(translate("Takes the last constituent away"))
        self._remove.clicked.connect(self._take_away)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for part in (self._rows, buttons):
            layout.addLayout(part)
        layout.addWidget(self._note)
        layout.addWidget(between)
        layout.addLayout(self._formulas)
        self._set_count(2)

    def count(self):
        """Of constituents."""
        return len(self._combos)

    def names(self):
        """Those of the constituents; none unless all have one."""
        names = [self._names.get(text, text) for text in self._texts()]
        return names if all(names) else []

    def objection(self):
        """What is wrong with the names, in words; "" where nothing is. No name at all is right."""
        texts = self._texts()
        for number, text in enumerate(texts, 1):
            if not text and any(texts):
                return translate("Constituent {} has no material: choose one, or clear the others").format(
                    number
                )
        return ""

    def fractions(self):
        """The formulas."""
        return [edit.formula() for edit in self._edits]

    def set_composition(self, names, fractions):
        """Shows what a material has; names may be missing, or of cards that are not on this computer."""
        self._set_count(len(fractions) + 1)
        for combo, name in zip(self._combos, names or [""] * self.count()):
            combo.setEditText(self._offered.get(name, name))
            combo.lineEdit().setCursorPosition(0)  # of a name too long its beginning is seen
        for edit, formula in zip(self._edits, fractions):
            edit.set_formula(formula)

    def set_formula(self, formula):
        """Writes into that which was worked on last."""
        self._edits[self.current].set_formula(formula)

    def mark(self, formula, position):
        """Underlines the place of an error in the formula with this index, and nothing else; None: nothing."""
        for index, edit in enumerate(self._edits):
            edit.mark(position if index == formula else None)

    def _texts(self):
        return [combo.currentText().strip() for combo in self._combos]

    def _tell_unknown(self):
        unknown = [text for text in self._texts() if text and text not in self._names]
        self._note.setText(
            translate(
                "There is no material card and no material object called {}: a mesh needs none, an analysis does"
            ).format(", ".join(unknown))
        )
        self._note.setVisible(bool(unknown))

    def _add_by_hand(self):
        self._set_count(self.count() + 1)
        self._edits[-1].setFocus()
        self._tell()

    def _take_away(self):
        self._set_count(self.count() - 1)
        self._tell()

    def _tell(self):
        self.renamed.emit()
        self.edited.emit()

    def _set_count(self, count):
        while self.count() < count:
            self._add_constituent()
        while self.count() > count:
            self._rows.removeRow(self.count() - 1)
            self._combos.pop()
        while len(self._edits) < count - 1:
            self._add_formula()
        while len(self._edits) > count - 1:
            for widget in (self._labels.pop(), self._edits.pop()):
                self._formulas.removeWidget(widget)
                widget.deleteLater()
        self.current = min(self.current, count - 2)
        self._remove.setEnabled(count > 2)

    def _add_constituent(self):
        number = self.count() + 1
        combo = WideCombo(f"FGMeshConstituent{number}")
        combo.setEditable(True)
        combo.addItem("")
        combo.addItems(list(self._offered.values()))
        combo.setToolTip(
            translate(
                "A material of FreeCAD or of the document, or any other name; only an analysis needs a material of that name"
            )
        )
        combo.currentTextChanged.connect(lambda _: self.renamed.emit())
        self._rows.addRow(translate("Constituent {}").format(number), combo)
        self._combos.append(combo)

    def _add_formula(self):
        index = len(self._edits)
        label = QtGui.QLabel(translate("Volume fraction of constituent {}").format(index + 1))
        edit = FormulaEdit()
        edit.setObjectName("FGMeshFormula" + (str(index + 1) if index else ""))
        edit.setToolTip(
            translate(
                "Volume fraction, 0 to 1, over x y z r theta d (mm, radians, in the material's frame), the parameters, "
                "d1 d2 ..., the distances to the references, and t1 t2 ..., the values of the tables; "
                "the last constituent is what the others leave"
            )
        )
        edit.textChanged.connect(self.edited)
        edit.focused.connect(lambda: setattr(self, "current", index))
        for widget in (label, edit):
            self._formulas.addWidget(widget)
        self._labels.append(label)
        self._edits.append(edit)
