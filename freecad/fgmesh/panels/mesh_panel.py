# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel that meshes a graded solid, in the background. The document changes only when a mesh is there."""
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.adapter import flag_number
from freecad.fgmesh.fem import background
from freecad.fgmesh.model import mesh_object, options, preferences
from freecad.fgmesh.model.macro_text import document_text, object_text
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.panels.expectation import Expectation
from freecad.fgmesh.panels.mesh_options_box import MeshOptionsBox
from freecad.fgmesh.panels.mesh_runner import STORING, MeshRunner
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.panels import showing
from freecad.fgmesh.view import icon, mesh_look, mesh_view
from freecad.fgmesh.view.recording import recorded
from freecad.fgmesh.view.texts import in_user_units, number_text, translate
from freecad.fgmesh.worker.remaining import RemainingTime, rough_time

STAGES = {
    "": TRANSLATE_LATER("FGMesh", "starting"),
    "reading": TRANSLATE_LATER("FGMesh", "reading the shape"),
    "references": TRANSLATE_LATER("FGMesh", "measuring references"),
    "initial": TRANSLATE_LATER("FGMesh", "initial mesh"),
    "material": TRANSLATE_LATER("FGMesh", "material-oriented refinement"),
    "geometry": TRANSLATE_LATER("FGMesh", "geometry-oriented refinement"),
    "certificate": TRANSLATE_LATER("FGMesh", "proof between the corners"),
    "second order": TRANSLATE_LATER("FGMesh", "nodes in the middle of edges"),
    STORING: TRANSLATE_LATER("FGMesh", "taking the mesh into the document"),
}
"""What the stages of a run are called."""


def open_mesh_panel(thing):
    """Shows the panel for a mesh object, to be made again, or for a graded solid, to get its mesh."""
    if not mesh_object.is_mesh(thing):
        panel = MeshPanel(thing)
    elif thing.Shape is None:
        text = translate("{} has lost its solid: set its Shape to a graded solid")
        raise core.InvalidInput(text.format(thing.Label))
    else:
        mesh_object.revive(thing)
        panel = MeshPanel(thing.Shape, thing)
    showing.show(panel, "FGMesh_Mesh")


class MeshPanel:
    """Makes a mesh of `solid`, or `mesh` again, an existing one."""

    def __init__(self, solid, mesh=None):
        self.solid, self.mesh = solid, mesh
        self._document = solid.Document.Name
        self._stage = self._started = None
        self.options = MeshOptionsBox()
        self.expectation = Expectation(solid)
        self.runner = MeshRunner()
        self._make_widgets()
        self.form = [self._options_box(), self._run_box()]
        self._connect()
        values = options.default_values()
        values.update(options.option_values(mesh) if mesh else preferences.mesh_values())
        self.options.set_values(values)
        self._expect()

    # What FreeCAD asks of a panel.

    def getStandardButtons(self):
        return flag_number(QtGui.QDialogButtonBox.Close)

    def reject(self):
        self.runner.cancel()
        self.expectation.stop()
        showing.close()
        return True

    # The run.

    def start(self):
        """What the button Mesh does."""
        try:
            self.runner.start(self.solid, self.options.values(), preferences.limits())
        except Exception as error:  # a deleted solid is a ReferenceError, ours are core.Error
            self._tell_failure(error)
            return
        self._started, self._stage, self._remaining = time.monotonic(), None, RemainingTime()
        self.log.clear()
        self.message.say("")
        self._show_running(True)

    def cancel(self):
        self.runner.cancel()

    def _make_widgets(self):
        self.start_button = QtGui.QPushButton(translate("Mesh"))
        self.start_button.setObjectName("FGMeshStart")
        self.start_button.setToolTip(translate("Meshes in the background; one undo takes the mesh back"))
        self.start_button.setDefault(True)
        self.cancel_button = QtGui.QPushButton(translate("Cancel"))
        self.cancel_button.setObjectName("FGMeshCancel")
        self.cancel_button.setToolTip(translate("Stops the run; the mesh stays as it was"))
        self.report_button = QtGui.QPushButton(translate("Report ..."))
        self.report_button.setObjectName("FGMeshOpenReport")
        self.report_button.setToolTip(translate("Figures, histograms and the worst tetrahedra of the mesh"))
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setFormat("")
        self.times = QtGui.QLabel()
        self.times.setObjectName("FGMeshTimes")
        self.message = MessageLabel()
        self.message.setObjectName("FGMeshRunMessage")
        self.log = QtGui.QPlainTextEdit()
        self.log.setObjectName("FGMeshLog")
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(1000)
        self.log.setMinimumHeight(110)

    def _options_box(self):
        box = QtGui.QWidget()
        title = self.mesh.Label if self.mesh else translate("Mesh of {}").format(self.solid.Label)
        box.setWindowTitle(title)
        box.setWindowIcon(QtGui.QIcon(icon("mesh")))
        layout = QtGui.QVBoxLayout(box)
        layout.addWidget(self.options)
        layout.addWidget(self.expectation)
        return box

    def _run_box(self):
        box = QtGui.QWidget()
        box.setWindowTitle(translate("Run"))
        box.setWindowIcon(QtGui.QIcon(icon("mesh")))
        layout = QtGui.QVBoxLayout(box)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.start_button)
        row.addWidget(self.cancel_button)
        layout.addLayout(row)
        layout.addWidget(self.bar)
        layout.addWidget(self.times)
        layout.addWidget(self.message)
        layout.addWidget(self.report_button)
        layout.addWidget(self.log)
        self._show_running(False)
        return box

    def _connect(self):
        self.options.edited.connect(self._expect)
        self.expectation.chosen.connect(self._use_remedy)
        self.start_button.clicked.connect(self.start)
        self.cancel_button.clicked.connect(self.cancel)
        self.report_button.clicked.connect(self._open_report)
        self.runner.progressed.connect(self._tell_progress)
        self.runner.finished.connect(self._store)
        self.runner.failed.connect(self._tell_failure)

    def _expect(self):
        try:
            values = self.options.values()
            options.meshing_options(values)
        except core.Error as error:
            self.expectation.stop()
            self.message.complain(str(error))
            self.start_button.setEnabled(False)
            return
        self.start_button.setEnabled(not self.runner.running)
        if self.message.kind == "error":
            self.message.say("")
        self.expectation.expect(values)

    def _use_remedy(self, change):
        """change: {property: value} of a button below the expected number."""
        self.options.set_values({**self.options.values(), **change})
        self._expect()

    def _show_running(self, running):
        self.start_button.setEnabled(not running)
        self.options.setEnabled(not running)
        self.cancel_button.setEnabled(running)
        self.report_button.setEnabled(not running and bool(self.mesh and self.mesh.Report))
        self.bar.setValue(0)
        self.bar.setFormat("")
        self.times.setVisible(running)

    def _tell_progress(self, stage, fraction, tets):
        if stage != self._stage:
            self._stage = stage
            self._log(translate(STAGES.get(stage, stage)))
        self.bar.setValue(int(1000 * fraction))
        elapsed = time.monotonic() - self._started
        parts = [translate(STAGES.get(stage, stage)), *([number_text(tets, ",")] if tets else [])]
        self.bar.setFormat("  ".join(parts).replace("%", "%%"))
        left = self._remaining.seconds(stage, fraction, elapsed)
        times = translate("{} so far").format(rough_time(elapsed))
        if left is not None:
            times += translate("; this stage about {} more").format(rough_time(left))
        self.times.setText(times)

    def _log(self, text):
        passed = number_text(time.monotonic() - self._started, "6.1f")
        self.log.appendPlainText(f"{passed} s  {in_user_units(text)}")

    def _tell_failure(self, error):
        self._show_running(False)
        if isinstance(error, core.Cancelled):
            self.message.warn(translate("Nothing was changed: {}").format(error))
        else:
            self.message.complain(str(error))
            FreeCAD.Console.PrintError(f"FGMesh: {error}\n")

    def _store(self, run):
        with run:
            try:
                self._run_lines(run)
            except Exception as error:  # FreeCAD turns ours into its own; the document may be gone
                self._tell_failure(error)
                return
            result = run.result()
        for line in result.messages:
            self._log(line)
        self._show_running(False)
        self.bar.setValue(1000)
        self._tell_result()
        mesh_look.show_kept(self.mesh)

    def _run_lines(self, run):
        document = FreeCAD.getDocument(self._document)
        values = run.request.values
        background.adopt(run)
        with recorded(document, translate("Mesh graded solid")) as line:
            if self.mesh is None:
                present = set(document.Objects)
                line(f"mesh = freecad.fgmesh.make_mesh({document_text(document)}, {object_text(self.solid)})")
                (made,) = [thing for thing in document.Objects if thing not in present]
            else:
                made = self.mesh
                line(f"mesh = {object_text(made)}")
            is_first = not made.Fingerprint
            now = options.option_values(made)
            for name, value in values.items():
                if value != now[name]:
                    line(f"mesh.{name} = {value!r}")
            line("freecad.fgmesh.generate(mesh)")
            if is_first:
                # The solid's faces lie upon those of the mesh.
                line(f"{object_text(self.solid)}.Visibility = False")
                mesh_view.keep_coloured(made)
            line(f"{document_text(document)}.recompute()")
        self.mesh = made

    def _tell_result(self):
        mesh = self.mesh
        text = translate("{} tetrahedra, variation up to {}, angles from {} to {} degrees").format(
            number_text(mesh.TetCount, ","),
            number_text(mesh.VariationMax, ".3g"),
            number_text(mesh.DihedralMin, ".1f"),
            number_text(mesh.DihedralMax, ".1f"),
        )
        self._log(text)
        if mesh.Status == "ok":
            self.message.say(text)
        else:
            self.message.warn(f"{mesh.Status}\n{text}")

    def _open_report(self):
        from freecad.fgmesh.panels.report_panel import ReportPanel

        mesh = self.mesh
        self.reject()
        # Not at once: FreeCAD is still closing this panel.
        QtCore.QTimer.singleShot(0, lambda: showing.show(ReportPanel(mesh), "FGMesh_Report"))
