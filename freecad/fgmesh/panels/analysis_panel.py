# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel that makes or completes a FEM analysis of a graded mesh."""
import FreeCADGui
from PySide import QtCore, QtGui

from freecad.fgmesh import core, mixing
from freecad.fgmesh.fem.analysis import analyses_for
from freecad.fgmesh.fem.bins import MOST
from freecad.fgmesh.adapter import fem_module, flag_number
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.fem.graded_material import MODES, Request, graded_materials, plan, request_of
from freecad.fgmesh.model.macro_text import document_text, object_text
from freecad.fgmesh.model.shown_quantities import PROPERTIES
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.panels.law_choice import LawChoice
from freecad.fgmesh.panels import showing
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.panels.wide_combo import WideCombo
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.recording import recorded
from freecad.fgmesh.view.texts import number_text, translate

MODE_NAMES = {
    "bins": TRANSLATE_LATER("FGMesh", "Bins: elements share materials"),
    "continuous": TRANSLATE_LATER("FGMesh", "Continuous: inside elements, too"),
}
_PAUSE = 300
"""Milliseconds after the last change before the outcome is computed."""


class AnalysisPanel:
    """Nothing changes before OK."""

    def __init__(self, mesh):
        self.mesh = mesh
        self._fields = None
        self._make_widgets()
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Analysis of {}").format(mesh.Label))
        self.form.setWindowIcon(QtGui.QIcon(icon("analysis")))
        self._lay_out()
        self._fill()
        self._connect()
        self._look_ahead()

    # What FreeCAD asks of a panel.

    def getStandardButtons(self):
        return flag_number(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        try:
            self._run_lines()
        except Exception as error:  # FreeCAD turns ours into its own
            self.message.complain(str(error))
            return False
        self._close()
        return True

    def reject(self):
        self._close()
        return True

    def _close(self):
        self._timer.stop()
        showing.close()

    def _make_widgets(self):
        self.analysis = WideCombo("FGMeshAnalysis")
        self.mode = WideCombo("FGMeshMode")
        self.bins = QtGui.QSpinBox()
        self.bins.setObjectName("FGMeshBins")
        self.bins.setRange(1, MOST)
        self.error = QtGui.QDoubleSpinBox()
        self.error.setObjectName("FGMeshAllowedError")
        self.error.setRange(0, 50)
        self.error.setDecimals(3)
        self.error.setSuffix(" %")
        self.error.setSpecialValueText(translate("as Bins says"))
        self.laws = {name: LawChoice(name) for name in mixing.PROPERTIES}
        self.message = MessageLabel()
        self.message.setObjectName("FGMeshAnalysisMessage")
        self._give_tips()
        self._timer = QtCore.QTimer(self.message)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_PAUSE)
        self._timer.timeout.connect(self._look_ahead)

    def _give_tips(self):
        tips = {
            self.analysis: translate(
                "The analysis that the mesh and its materials are put into: a new one, or one that has no mesh yet"
            ),
            self.mode: translate(
                "Bins: elements of nearly the same properties share a material. "
                "Continuous: properties vary inside the elements, for two constituents"
            ),
            self.bins: translate("The most materials that the elements may share"),
            self.error: translate(
                "How far a property may be from that of its bin: there are as many bins as this needs; 0: as Bins says"
            ),
        }
        for field, tip in tips.items():
            field.setToolTip(tip)

    def _lay_out(self):
        layout = QtGui.QVBoxLayout(self.form)
        form = QtGui.QFormLayout()
        form.addRow(translate("Analysis"), self.analysis)
        form.addRow(translate("Properties"), self.mode)
        form.addRow(translate("Bins"), self.bins)
        form.addRow(translate("Allowed error"), self.error)
        layout.addLayout(form)
        box = QtGui.QGroupBox(translate("Mixing laws"))
        rows = QtGui.QFormLayout(box)
        for name, law in self.laws.items():
            title = translate(PROPERTIES[name][0])
            rows.addRow(title[0].upper() + title[1:], law)
        layout.addWidget(box)
        layout.addWidget(self.message)

    def _fill(self):
        self._analyses = analyses_for(self.mesh)
        self.analysis.addItems([one.Label if one else translate("New analysis") for one in self._analyses])
        self.mode.addItems([translate(MODE_NAMES[mode]) for mode in MODES])
        graded = graded_materials(self.mesh.Document, self.mesh)
        request = request_of(graded[0]) if graded else Request()
        self.analysis.setCurrentIndex(1 if len(self._analyses) == 2 else 0)
        self.mode.setCurrentIndex(MODES.index(request.mode))
        self.bins.setValue(request.bins)
        self.error.setValue(100 * request.allowed_error)
        for name, law in self.laws.items():
            law.set_text(request.mixing.get(name, ""))

    def _connect(self):
        self.mode.currentIndexChanged.connect(lambda: self._timer.start())
        self.bins.valueChanged.connect(lambda: self._timer.start())
        self.error.valueChanged.connect(lambda: self._timer.start())
        for law in self.laws.values():
            law.editTextChanged.connect(lambda: self._timer.start())

    def _request(self):
        laws = {name: law.text() for name, law in self.laws.items() if law.text()}
        return Request(
            MODES[self.mode.currentIndex()], self.bins.value(), round(self.error.value() / 100, 6), laws
        )

    def _look_ahead(self):
        """Tells what would come of it."""
        continuous = MODES[self.mode.currentIndex()] == "continuous"
        self.bins.setEnabled(not continuous and self.error.value() == 0)
        self.error.setEnabled(not continuous)
        try:
            if self._fields is None:
                self._fields = graded_mesh(self.mesh)
            parts = plan(self._fields, self._request())
        except core.Error as error:
            self.message.complain(str(error))
            return
        if continuous:
            self.message.say(translate("Properties vary inside the elements"))
            return
        count = len(parts.values["YoungsModulus"])
        self.message.say(
            translate("Materials: {}, properties within {} % of the mixtures").format(
                count, number_text(100 * parts.error, ".2g")
            )
        )

    def _run_lines(self):
        request, document = self._request(), self.mesh.Document
        chosen = self._analyses[self.analysis.currentIndex()]
        words = [object_text(self.mesh), f"mode={request.mode!r}"]
        if request.mode == "bins":
            words.append(
                f"allowed_error={request.allowed_error}" if request.allowed_error else f"bins={request.bins}"
            )
        if request.mixing:
            words.append(f"mixing={request.mixing!r}")
        if chosen is not None:
            words.append(f"analysis={object_text(chosen)}")
        with recorded(document, translate("Create graded analysis")) as line:
            present = set(document.Objects)
            line(f"analysis = freecad.fgmesh.make_analysis({', '.join(words)})")
            line(f"{document_text(document)}.recompute()")
        made = [
            one for one in document.Objects if one not in present and one.isDerivedFrom("Fem::FemAnalysis")
        ]
        # The commands of the FEM workbench put constraints into the active one.
        fem_module("FemGui").setActiveAnalysis(chosen or made[0])
