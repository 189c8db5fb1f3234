# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Examples: opens a document with a graded solid, to begin with."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from freecad.fgmesh.commands.command import Command
from freecad.fgmesh.model.examples import EXAMPLES, open_example
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.texts import translate


class ExamplesCommand(Command):
    name, icon = "FGMesh_Examples", "examples"
    text = TRANSLATE_LATER("FGMesh_Examples", "Examples ...")
    tip = TRANSLATE_LATER("FGMesh_Examples", "Opens a document with graded solids, ready to be meshed")

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def run(self):
        titles = [translate(example.title) for example in EXAMPLES]
        title, chosen = QtGui.QInputDialog.getItem(
            FreeCADGui.getMainWindow(), translate("Examples"), translate("Open"), titles, 0, False
        )
        if not chosen:
            return
        document = open_example(EXAMPLES[titles.index(title)])
        FreeCAD.setActiveDocument(document.Name)
        view = FreeCADGui.getDocument(document.Name).activeView()
        view.viewIsometric()
        view.fitAll()
