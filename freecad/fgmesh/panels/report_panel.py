# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel that shows how good a mesh is: the table of stages, histograms, the worst tetrahedra, a cut."""

import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad.fgmesh import pictures
from freecad.fgmesh.adapter import flag_number
from freecad.fgmesh.fem.fem_mesh import kept_points_and_tets
from freecad.fgmesh.io import stage_rows, write_report_table
from freecad.fgmesh.model.mesh_object import fractions_of, report_of
from freecad.fgmesh.model.shown_quantities import fraction_titles
from freecad.fgmesh.model.tet_figures import smallest_dihedral_angles, variations
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.panels import showing
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.panels.plot_canvas import plot_canvas, use_text_colour
from freecad.fgmesh.panels.section_controls import SectionControls
from freecad.fgmesh.panels.whole_table import WholeTable
from freecad.fgmesh.view import icon, mesh_look
from freecad.fgmesh.view.texts import number_text, translate

_WORST = 20  # tetrahedra that are shown
_SIZE = (4, 3)  # of histograms, inches

PLAIN, SMALLEST_ANGLES, LARGEST_VARIATION = range(3)  # looks behind the fractions
"""What the view shows."""

STAGES = {
    "initial": TRANSLATE_LATER("FGMesh", "initial"),
    "material": TRANSLATE_LATER("FGMesh", "material"),
    "geometry": TRANSLATE_LATER("FGMesh", "geometry"),
}
FIGURES = {
    "points": TRANSLATE_LATER("FGMesh", "points"),
    "facets": TRANSLATE_LATER("FGMesh", "facets"),
    "tetrahedra": TRANSLATE_LATER("FGMesh", "tetrahedra"),
    "variation min": TRANSLATE_LATER("FGMesh", "variation min"),
    "variation max": TRANSLATE_LATER("FGMesh", "variation max"),
    "variation mean": TRANSLATE_LATER("FGMesh", "variation mean"),
    "above threshold": TRANSLATE_LATER("FGMesh", "above threshold"),
    "angle min": TRANSLATE_LATER("FGMesh", "angle min"),
    "angle max": TRANSLATE_LATER("FGMesh", "angle max"),
    "seconds": TRANSLATE_LATER("FGMesh", "seconds"),
}
"""Heads and first column of the table of stages, which io writes in English."""


def certified(report):
    """Whether the threshold is proved; also where that was not asked for, which is no reason to warn."""
    return report.get("certified", {}).get("holds", True)


def certificate_text(report):
    """A line on what is proved between the corners of tetrahedra; reports of older versions do not know."""
    figures = report.get("certified")
    if not figures:
        return translate("The threshold is not proved between the corners of tetrahedra")
    if figures["holds"]:
        return translate("Proved over the whole of each tetrahedron: the variation is at most {}").format(
            number_text(figures["bound"], ".4f")
        )
    return translate(
        "Of {} tetrahedra {} break the threshold, at or between their corners; {} are not proved"
    ).format(figures["tets"], figures["broken"], figures["unproved"])


class ReportPanel:
    """Figures of `mesh`, a mesh object that has been generated; nothing in the document changes."""

    def __init__(self, mesh):
        self.mesh, self.report = mesh, report_of(mesh)
        self._titles = fraction_titles(mesh.Shape, 1 + fractions_of(mesh).shape[1], translate)
        self.form = [self._figures_box(), self._view_box()]
        self._show_look()

    # What FreeCAD asks of a panel.

    def getStandardButtons(self):
        return flag_number(QtGui.QDialogButtonBox.Close)

    def reject(self):
        mesh_look.show_kept(self.mesh)
        showing.close()
        return True

    # What the buttons do.

    def save_picture(self, path):
        """Writes the histogram that is shown, in the colours of paper."""
        from matplotlib.figure import Figure

        figure = Figure(figsize=_SIZE)
        self._fill(figure)
        figure.savefig(path, dpi=120)

    def save_table(self, path):
        write_report_table(self.report, path)

    def _figures_box(self):
        box = QtGui.QWidget()
        box.setWindowTitle(translate("Report of {}").format(self.mesh.Label))
        box.setWindowIcon(QtGui.QIcon(icon("report")))
        layout = QtGui.QVBoxLayout(box)
        self.message = MessageLabel()
        self.message.setObjectName("FGMeshStatus")
        (self.message.say if self.mesh.Status == "ok" else self.message.warn)(self.mesh.Status)
        layout.addWidget(self.message)
        layout.addWidget(self._table())
        layout.addWidget(self._certificate())
        self._label = QtGui.QLabel(translate("Histogram"))
        layout.addWidget(self._label)
        self.kind = QtGui.QComboBox()
        self.kind.setObjectName("FGMeshHistogram")
        self.kind.addItems([translate("Variation of composition"), translate("Dihedral angles")])
        self.kind.setToolTip(translate("What the histogram below counts in the tetrahedra"))
        self.kind.currentIndexChanged.connect(lambda: self._plot())
        layout.addWidget(self.kind)
        layout.addWidget(self._canvas())
        for line in self.report["messages"]:
            label = MessageLabel()
            label.say(line)
            layout.addWidget(label)
        row = QtGui.QHBoxLayout()
        picture_tip = translate("Writes the histogram that is shown as a picture")
        table_tip = translate("Writes the figures of the stages as a table that spreadsheets read")
        for title, tip, name, save in (
            (translate("Save picture ..."), picture_tip, "FGMeshSavePicture", self._ask_picture),
            (translate("Save table ..."), table_tip, "FGMeshSaveTable", self._ask_table),
        ):
            button = QtGui.QPushButton(title)
            button.setObjectName(name)
            button.setToolTip(tip)
            button.clicked.connect(save)
            row.addWidget(button)
        layout.addLayout(row)
        return box

    def _table(self):
        rows = stage_rows(self.report)
        table = WholeTable(len(rows), 1 + len(self.report["stages"]))
        table.setObjectName("FGMeshStages")
        table.setHorizontalHeaderLabels(
            ["", *(translate(STAGES[stage["name"]]) for stage in self.report["stages"])]
        )
        table.verticalHeader().hide()
        table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        for row, (title, figures, form) in enumerate(rows):
            texts = ["" if figure is None else number_text(figure, form) for figure in figures]
            for column, text in enumerate([translate(FIGURES[title]), *texts]):
                item = QtGui.QTableWidgetItem(text)
                if column:
                    item.setTextAlignment(flag_number(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
                table.setItem(row, column, item)
        for header in (table.horizontalHeader(), table.verticalHeader()):
            header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        return table

    def _certificate(self):
        label = MessageLabel()
        label.setObjectName("FGMeshCertificate")
        (label.say if certified(self.report) else label.warn)(certificate_text(self.report))
        return label

    def _canvas(self):
        from matplotlib.figure import Figure

        self.figure = Figure(figsize=_SIZE, dpi=80)  # small letters: the panel is narrow
        self.canvas = plot_canvas(self.figure)
        self.canvas.setObjectName("FGMeshPlot")
        self.canvas.setMinimumHeight(240)
        self._plot()
        return self.canvas

    def _plot(self):
        self.figure.clear()
        self._fill(self.figure)
        use_text_colour(self.figure, self._label)
        self.canvas.draw_idle()

    def _fill(self, figure):
        plot = pictures.plot_variation if self.kind.currentIndex() == 0 else pictures.plot_dihedral
        last = {**self.report, "stages": self.report["stages"][-1:]}
        plot(last, figure, translate)

    def _view_box(self):
        box = QtGui.QWidget()
        box.setWindowTitle(translate("In the view"))
        box.setWindowIcon(QtGui.QIcon(icon("preview")))
        form = QtGui.QFormLayout(box)
        self.look = QtGui.QComboBox()
        self.look.setObjectName("FGMeshLook")
        self.look.setToolTip(
            translate("What the mesh shows in the 3D view: its composition, or its worst tetrahedra")
        )
        # Two fractions tell the same.
        self._fractions = [translate("Fraction")] if len(self._titles) == 2 else self._titles
        self.look.addItems(self._fractions)
        self.look.addItems([translate("Plain"), translate("Smallest angles"), translate("Largest variation")])
        self.look.currentIndexChanged.connect(lambda: self._show_look())
        self.section = SectionControls(self.mesh, self.mesh.FemMesh.BoundBox, "Cut")
        self.section.changed.connect(self._show_look)
        form.addRow(translate("Show"), self.look)
        form.addRow(translate("Cut"), self.section)
        return box

    def _show_look(self):
        constituent = self.look.currentIndex()
        look = constituent - len(self._fractions)
        self.section.setEnabled(look < 0)
        if look < 0:
            mesh_look.cut(self.mesh, self.section.plane(), self._titles[constituent], constituent)
        elif look == PLAIN:
            mesh_look.show_plain(self.mesh)
        else:
            mesh_look.show_worst(self.mesh, self._worst(look))

    def _worst(self, look):
        """The tetrahedra that come first by smallest angle or by largest variation."""
        points, tets = kept_points_and_tets(self.mesh)
        if look == SMALLEST_ANGLES:
            order = smallest_dihedral_angles(points, tets)
        else:
            order = -variations(fractions_of(self.mesh), tets)
        return np.argsort(order, kind="stable")[:_WORST]

    def _ask_picture(self):
        self._ask(translate("Pictures (*.png *.svg *.pdf)"), ".png", self.save_picture)

    def _ask_table(self):
        self._ask(translate("Tables (*.csv)"), ".csv", self.save_table)

    def _ask(self, kinds, suffix, save):
        path, _ = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), translate("Save"), f"{self.mesh.Label}{suffix}", kinds
        )
        if path:
            self._save(path if "." in path.rsplit("/", 1)[-1] else path + suffix, save)

    def _save(self, path, save):
        try:
            save(path)
        except (OSError, ValueError) as error:
            self.message.complain(str(error))
