# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands have in common."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from freecad.fgmesh.view import icon
from freecad.fgmesh.view.help_pages import page_address
from freecad.fgmesh.view.texts import translate


class Command:
    """name: as FreeCAD knows it; icon, text, tip: English, marked for translation in the context of that name."""

    name = icon = text = tip = shortcut = ""

    def GetResources(self):
        return {
            "Pixmap": icon(self.icon),
            "MenuText": self.text,
            "ToolTip": self.tip,
            "WhatsThis": page_address(self.name) or self.tip,
            "Accel": self.shortcut,
        }

    def Activated(self):
        try:
            self.run()
        except Exception as error:  # of whatever kind: a user gets a sentence, not a traceback
            FreeCAD.Console.PrintError(f"FGMesh: {error}\n")
            QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), translate("FGMesh"), str(error))

    def run(self):
        """What the command does; its errors are shown to the user."""
        raise NotImplementedError


def free_for_panel():
    """True where a document is open and no other task panel is."""
    return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()
