# SPDX-License-Identifier: GPL-3.0-or-later
"""The sampled tables of a formula: what t1, t2, ... are the values of."""
from pathlib import Path

import FreeCAD
from PySide import QtCore, QtGui

from freecad.fgmesh import core
from freecad.fgmesh.panels.numbered_list import NumberedList
from freecad.fgmesh.view.texts import number_text, translate


class TableList(NumberedList):
    """Its entries are texts of tables. `failed` tells what is wrong with a file."""

    failed = QtCore.Signal(str)

    def __init__(self, parent=None):
        super().__init__("t", "Table", parent)
        self.files = {}
        """{text: path that it was read from here}."""
        self.list.setToolTip(
            translate("t1 is the value of the first of them at a point, t2 of the second, and so on")
        )
        self.add.setText(translate("Add ..."))
        self.add.setToolTip(
            translate(
                "CSV files: a header such as r, z, value, then a row for each sample; the rows fill a grid"
            )
        )
        self.add.clicked.connect(self._choose)

    def _choose(self):
        folder = str(Path(next(reversed(self.files.values()))).parent) if self.files else _start_folder()
        kinds = translate("Tables (*.csv *.txt *.dat *.tsv);;All files (*)")
        paths, _ = QtGui.QFileDialog.getOpenFileNames(self, translate("Sampled tables"), folder, kinds)
        try:
            texts = [core.table_text(path) for path in paths]
            for text, path in zip(texts, paths):
                core.read_table(text, path)
        except core.InvalidInput as error:
            self.failed.emit(str(error))
            return
        self.files.update(zip(texts, paths))
        if texts:
            self._append(texts)

    def _text(self, text):
        file = Path(self.files[text]).name + ": " if text in self.files else ""
        try:
            table = core.read_table(text)
        except core.InvalidInput as error:  # someone has written into the property
            return str(error)
        counts = " × ".join(map(str, table.values.shape))
        low, high = (number_text(value, ".4g") for value in (table.values.min(), table.values.max()))
        return f"{file}{' × '.join(table.places)} ({counts}), {translate('{} to {}').format(low, high)}"


def _start_folder():
    """Where FreeCAD's own dialogs have been last."""
    return FreeCAD.ParamGet("User parameter:BaseApp/Preferences/General").GetString("FileOpenSavePath", "")
