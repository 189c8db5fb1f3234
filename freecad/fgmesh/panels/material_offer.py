# SPDX-License-Identifier: GPL-3.0-or-later
"""What a command does that needs a graded solid and has one without a material."""
import FreeCADGui
from PySide import QtGui

from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.panels import showing
from freecad.fgmesh.view.texts import translate


def has_or_gets_material(solid):
    """True where `solid` or its parts have materials; else the user is asked, and gets the panel for one."""
    if graded_parts(solid):
        return True
    question = translate("{} has no graded material yet. Give it one now?").format(solid.Label)
    buttons = QtGui.QMessageBox.Yes | QtGui.QMessageBox.No
    answer = QtGui.QMessageBox.question(
        FreeCADGui.getMainWindow(), translate("Graded material"), question, buttons
    )
    if answer == QtGui.QMessageBox.Yes:
        from freecad.fgmesh.panels.material_panel import MaterialPanel

        showing.show(MaterialPanel([solid]), "FGMesh_Material")
    return False
