# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Analysis: makes or completes a FEM analysis of the selected mesh."""
from freecad.fgmesh.commands.command import Command, free_for_panel
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.selection import meshed, selected_mesh


class AnalysisCommand(Command):
    name, icon, shortcut = "FGMesh_Analysis", "analysis", "G, A"
    text = TRANSLATE_LATER("FGMesh_Analysis", "Create graded analysis ...")
    tip = TRANSLATE_LATER(
        "FGMesh_Analysis", "Makes or completes a FEM analysis of the selected mesh, with graded properties"
    )

    def IsActive(self):
        return free_for_panel() and selected_mesh() is not None

    def run(self):
        from freecad.fgmesh.panels.analysis_panel import AnalysisPanel
        from freecad.fgmesh.panels.showing import show

        show(AnalysisPanel(meshed(selected_mesh())), self.name)
