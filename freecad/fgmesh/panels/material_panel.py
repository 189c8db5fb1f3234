# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel in which a solid gets its graded material. The document changes on OK alone."""
import re

import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.adapter import flag_number
from freecad.fgmesh.model import constituents, gradings, preferences
from freecad.fgmesh.model.macro_text import document_text
from freecad.fgmesh.model.material_draft import MaterialDraft
from freecad.fgmesh.panels.composition_box import CompositionBox
from freecad.fgmesh.panels.frame_box import FrameBox
from freecad.fgmesh.panels import showing
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.panels.parameter_table import ParameterTable
from freecad.fgmesh.panels.preview_box import PreviewBox, range_text
from freecad.fgmesh.panels.reference_list import ReferenceList
from freecad.fgmesh.panels.table_list import TableList
from freecad.fgmesh.panels.wide_combo import WideCombo
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.recording import recorded
from freecad.fgmesh.view.texts import number_text, quantity_text, translate

_SLACK = 1e-9
"""Rounding that is no reason for a warning about fractions outside [0, 1]."""

_WAIT_MILLISECONDS = 30  # for the next key; the preview follows within 200


class MaterialPanel:
    """The material of `solids`, one for all of them; what the first has is shown at the start, a linear grading where
    it has none."""

    def __init__(self, solids):
        self.solids, self._first = solids, solids[0]
        self._missing_name = None
        self._undefined = False  # the formula is so on all of the solid
        self._brought = set()  # parameters of a ready grading, which a formula of the user's may not need
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.setInterval(_WAIT_MILLISECONDS)
        self._timer.timeout.connect(self._refresh)
        self._make_widgets()
        self.form = [self._material_box(), self.preview]
        self._connect()
        self._show(MaterialDraft.of(self._first))
        if not any(self.composition.fractions()):
            self._use_grading(gradings.to_begin_with(self._first.Shape, self._frame()))
        self.preview.setChecked(preferences.preview_at_start())
        self._refresh()

    # What FreeCAD asks of a panel.

    def getStandardButtons(self):
        return flag_number(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        if self._undefined:
            return False  # the message says so
        if objection := self.composition.objection():
            self.message.complain(objection)
            return False
        try:
            draft = self.draft()
            with recorded(self._first.Document, translate("Set graded material")) as run:
                for solid in self.solids:
                    for line in draft.script(solid):
                        run(line)
                run(f"{document_text(self._first.Document)}.recompute()")
        except Exception as error:  # FreeCAD turns ours into its own
            self.message.complain(str(error))
            return False
        return self._close()

    def reject(self):
        return self._close()

    # What the panel shows.

    def draft(self):
        """The MaterialDraft that is shown. Raises core.InvalidInput where a field makes no sense."""
        names, formulas = self.composition.names(), self.composition.fractions()
        parameters = self.parameters.parameters()
        for name in self._brought - _words(formulas):
            parameters.pop(name, None)
        return MaterialDraft(
            names,
            formulas,
            parameters,
            self.frame.frame(),
            self.references.entries(),
            self.tables.entries(),
            self.tables.files,
        )

    def _show(self, draft):
        self.composition.set_composition(draft.constituents, draft.fractions)
        self.parameters.set_parameters(draft.parameters)
        self.frame.set_frame(draft.frame)
        self.references.set_entries(draft.references)
        self.tables.set_entries(draft.tables)

    def _make_widgets(self):
        self.grading = WideCombo("FGMeshGrading")
        self.grading.addItem(translate("Ready gradings ..."))
        for number, grading in enumerate(gradings.GRADINGS, 1):
            self.grading.addItem(translate(grading.name))
            self.grading.setItemData(number, translate(grading.tip), QtCore.Qt.ToolTipRole)
        self.composition = CompositionBox(constituents.available(self._first.Document), self.grading)
        self.message = MessageLabel()
        self.message.setObjectName("FGMeshFormulaMessage")
        self.make_parameter = QtGui.QPushButton()
        self.make_parameter.setObjectName("FGMeshMakeParameter")
        self.make_parameter.hide()
        self.parameters = ParameterTable(self._first)
        self.frame = FrameBox(self._first)
        self.references = ReferenceList()
        self.tables = TableList()
        self.preview = PreviewBox(self._first)

    def _material_box(self):
        box = QtGui.QWidget()
        names = ", ".join(solid.Label for solid in self.solids)
        box.setWindowTitle(translate("Graded material of {}").format(names))
        box.setWindowIcon(QtGui.QIcon(icon("material")))
        form = QtGui.QFormLayout(box)
        form.setContentsMargins(4, 4, 4, 4)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.addRow(self.composition)
        form.addRow(self.message)
        form.addRow(self.make_parameter)
        form.addRow(self.parameters)
        form.addRow(QtGui.QLabel(translate("Frame of x y z r theta d")))
        form.addRow(self.frame)
        form.addRow(QtGui.QLabel(translate("References of d1 d2 ...")))
        form.addRow(self.references)
        form.addRow(QtGui.QLabel(translate("Tables of t1 t2 ...")))
        form.addRow(self.tables)
        return box

    def _connect(self):
        self.grading.activated.connect(self._grading_chosen)
        self.composition.edited.connect(self._timer.start)
        self.parameters.edited.connect(self._timer.start)
        self.frame.edited.connect(self._timer.start)
        self.frame.failed.connect(self.message.complain)
        self.references.edited.connect(self._timer.start)
        self.tables.edited.connect(self._timer.start)
        self.tables.failed.connect(self.message.complain)
        self.make_parameter.clicked.connect(self._add_missing_parameter)
        self.composition.renamed.connect(self._constituents_changed)
        self.preview.looked_at.connect(self._tell_range)
        self.preview.failed.connect(lambda error: self.message.complain(str(error)))

    def _constituents_changed(self):
        self.preview.set_constituents(self.composition.names(), self.composition.count())
        self._timer.start()  # an objection to the former names goes

    def _frame(self):
        """That of the material, in the coordinates of the solid's shape; the last good one while it is being typed."""
        return self._first.Placement.multiply(self.frame.last())

    def _grading_chosen(self, row):
        if row > 0:
            self._use_grading(gradings.GRADINGS[row - 1])
            self._refresh()

    def _use_grading(self, grading):
        self.grading.setCurrentIndex(1 + gradings.GRADINGS.index(grading))
        others = self.composition.fractions()
        number = self.composition.current + 1
        del others[number - 1]
        formula, parameters = gradings.numbered(
            grading.formula, gradings.fitted(grading, self._first.Shape, self._frame()), number
        )
        kept = {name: text for name, text in self.parameters.rows() if name in _words(others)}
        self._brought |= set(parameters)
        texts = {name: quantity_text(value, gradings.dimension(name)) for name, value in parameters.items()}
        self.parameters.set_parameters({**kept, **texts})
        self.composition.set_formula(formula)
        self.references.pick_until(grading.references)

    def _refresh(self):
        """Checks what is written, marks what is wrong, has the preview follow."""
        self._timer.stop()
        self._missing_name, self._undefined = None, False
        wrong = position = None
        try:
            material = self.draft().material(self._first)
        except core.FormulaError as error:
            wrong, position = error.formula, error.position
            self._complain_of_formula(error)
        except core.Error as error:
            self.message.complain(str(error))
        else:
            self.message.say("")
            self.preview.set_materials([material])
        self.composition.mark(wrong, position)
        self.make_parameter.setVisible(self._missing_name is not None)
        # Of a formula that is not there yet, too: a surface that comes late would tell the range of the former one.
        if wrong is not None or self.message.kind == "error":
            self.preview.set_materials([])

    def _complain_of_formula(self, error):
        formula = self.composition.fractions()[error.formula]
        if not formula:
            self.message.say(translate("Write a formula, or choose a ready grading above"))
            return
        self.message.complain(str(error))
        word = re.match(rb"[A-Za-z]\w*(?!\w*\s*\()", formula.encode()[error.position :])
        if word and not re.fullmatch(rb"[dst][0-9]+", word.group()) and "unknown name" in str(error):
            self._missing_name = word.group().decode()
            self.make_parameter.setText(translate("Make {} a parameter").format(self._missing_name))

    def _add_missing_parameter(self):
        if self._missing_name is not None:
            self.parameters.add(self._missing_name)

    def _tell_range(self, ranges, missing):
        if self.message.kind == "error":
            return
        self._undefined = bool(np.isnan(ranges).any())
        if self._undefined:
            self.message.complain(translate("The formula is not defined anywhere on the solid"))
            return
        text = range_text(ranges)
        if missing > 0:
            self.message.warn(
                text + translate("; not defined in {} % of it").format(number_text(100 * missing, ".2g"))
            )
        elif ranges.min() < -_SLACK or ranges.max() > 1 + _SLACK:
            self.message.warn(text + translate("; a volume fraction must stay between 0 and 1"))
        else:
            self.message.say(text)

    def _close(self):
        self._timer.stop()
        self.frame.stop_picking()
        self.references.stop_picking()
        self.preview.close_preview()
        showing.close()
        return True


def _words(formulas):
    return set(re.findall(r"\w+", " ".join(formulas)))
