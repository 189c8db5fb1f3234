# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of a formula as rows: name, number or expression, and the value that comes of it."""
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.model.material_draft import parameter_quantity
from freecad.fgmesh.panels.add_remove_row import AddRemoveRow
from freecad.fgmesh.panels.quiet import quiet
from freecad.fgmesh.view.texts import length_text, translate

_NAME, _TEXT, _VALUE = range(3)


class ParameterTable(QtGui.QWidget):
    """`edited` tells of every change that the user makes."""

    edited = QtCore.Signal()

    def __init__(self, solid, parent=None):
        super().__init__(parent)
        self._solid = solid
        self.table = QtGui.QTableWidget(0, 3)
        self.table.setObjectName("FGMeshParameters")
        self.table.setHorizontalHeaderLabels([translate("Parameter"), translate("Value"), translate("Is")])
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(_TEXT, QtGui.QHeaderView.Stretch)
        rows = self.table.verticalHeader()
        rows.hide()
        rows.setSectionResizeMode(QtGui.QHeaderView.Fixed)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setToolTip(
            translate(
                "Values are numbers (0.08), numbers with units (2 cm) or expressions of FreeCAD "
                "(Height/2, Spreadsheet.alpha), which then drive the parameter"
            )
        )
        self.table.itemChanged.connect(self._item_changed)
        buttons = AddRemoveRow("Parameter")
        buttons.add.clicked.connect(lambda: self.add(self._free_name()))
        buttons.remove.clicked.connect(self._remove_selected)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table)
        layout.addLayout(buttons)
        self._fit()

    def parameters(self):
        """{name: text}. Raises core.InvalidInput where a name is missing or there twice."""
        result = {}
        for name, text in self.rows():
            if not name:
                raise core.InvalidInput(
                    translate("A parameter has no name: write one beside its value {}, or remove it").format(
                        text
                    )
                )
            if name in result:
                raise core.InvalidInput(
                    translate("Two parameters are called {}: rename or remove one").format(name)
                )
            result[name] = text
        return result

    def rows(self):
        """(name, text) of each, whatever is written."""
        return [(self._text(row, _NAME), self._text(row, _TEXT)) for row in range(self.table.rowCount())]

    def set_parameters(self, parameters):
        """{name: number or text}; tells nobody."""
        with quiet(self.table):
            self.table.setRowCount(0)
            for name, value in parameters.items():
                self._append(name, value if isinstance(value, str) else f"{value:.6g}")
        self._fit()
        self.show_values()

    def add(self, name, text="1"):
        """A further row, its value ready to be typed over."""
        with quiet(self.table):
            self._append(name, text)
        self._fit()
        self.table.setCurrentCell(self.table.rowCount() - 1, _TEXT)
        self.table.setFocus()
        self.show_values()
        self.edited.emit()

    def show_values(self):
        """What the texts come to, beside them; what is wrong with them as tool tips."""
        with quiet(self.table):
            for row in range(self.table.rowCount()):
                shown, tip = self._outcome(row)
                item = self.table.item(row, _VALUE)
                item.setText(shown)
                item.setToolTip(tip)

    def showEvent(self, event):
        super().showEvent(event)
        self._fit()  # style sheets have set fonts and margins by now

    def _outcome(self, row):
        name, text = self._text(row, _NAME), self._text(row, _TEXT)
        try:
            value, is_length = parameter_quantity(self._solid, name, text)
            return length_text(value) if is_length else f"{value:.6g}", ""
        except core.InvalidInput as error:
            return "?", str(error)

    def _append(self, name, text):
        row = self.table.rowCount()
        self.table.insertRow(row)
        value = QtGui.QTableWidgetItem()
        value.setFlags(QtCore.Qt.ItemIsEnabled)
        for column, item in enumerate((QtGui.QTableWidgetItem(name), QtGui.QTableWidgetItem(text), value)):
            self.table.setItem(row, column, item)

    def _remove_selected(self):
        rows = {index.row() for index in self.table.selectedIndexes()} or {self.table.rowCount() - 1}
        for row in sorted(rows, reverse=True):
            self.table.removeRow(row)
        self._fit()
        self.edited.emit()

    def _item_changed(self, item):
        self.show_values()
        self.edited.emit()

    def _text(self, row, column):
        return self.table.item(row, column).text().strip()

    def _free_name(self):
        taken = dict(self.rows())
        return next(name for number in range(1, 1000) if (name := f"p{number}") not in taken)

    def _fit(self):
        """As high as its rows, up to six; away where it has none."""
        rows = min(self.table.rowCount(), 6)
        self.table.setVisible(rows > 0)
        height = self.table.fontMetrics().height() + 8
        self.table.verticalHeader().setDefaultSectionSize(height)
        around = self.table.horizontalHeader().sizeHint().height() + 2 * self.table.frameWidth()
        self.table.setFixedHeight(around + rows * height + 2)
