# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers the workbench. FreeCAD imports this module when it starts with a GUI: nothing heavy is loaded here."""
from pathlib import Path

import FreeCADGui

from freecad.fgmesh.model import presentation
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view import ICON, analysis_view, mesh_view, progress

presentation.show = mesh_view.show
presentation.show_graded_material = analysis_view.show_graded_material
presentation.show_graded_solver = analysis_view.show_graded_solver
presentation.progress = progress.progress

_ROOT = Path(__file__).absolute().parents[2]

FreeCADGui.addLanguagePath(str(_ROOT / "translations"))
FreeCADGui.updateLocale()


class FGMeshWorkbench(FreeCADGui.Workbench):
    MenuText = TRANSLATE_LATER("Workbench", "FGMesh")
    ToolTip = TRANSLATE_LATER("Workbench", "Tetrahedral FEM meshes of functionally graded solids")
    Icon = ICON

    def Initialize(self):
        # Only here, so that FreeCAD starts quickly, and starts where the compiled part is missing.
        from freecad.fgmesh import commands

        names = commands.add_all()
        self.appendToolbar("FGMesh", names)
        self.appendMenu("&FGMesh", names)

    def ContextMenu(self, recipient):
        from freecad.fgmesh.commands.for_selection import commands_for_selection

        names = commands_for_selection()
        if names:
            self.appendContextMenu("", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(FGMeshWorkbench())
# Not addIcon(), which ends with an error where Qt has no plugin that reads SVG.
FreeCADGui.addIconPath(str(Path(ICON).parent))
FreeCADGui.addPreferencePage(str(Path(__file__).absolute().parent / "panels" / "preferences.ui"), "FGMesh")
