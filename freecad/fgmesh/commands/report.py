# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Report: shows how good the selected mesh is."""
from freecad.fgmesh.commands.command import Command, free_for_panel
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.selection import meshed, selected_mesh


class ReportCommand(Command):
    name, icon, shortcut = "FGMesh_Report", "report", "G, R"
    text = TRANSLATE_LATER("FGMesh_Report", "Report of the mesh")
    tip = TRANSLATE_LATER(
        "FGMesh_Report", "Figures of the selected mesh: stages, histograms, the worst tetrahedra, a cut"
    )

    def IsActive(self):
        return free_for_panel() and selected_mesh() is not None

    def run(self):
        from freecad.fgmesh.panels.report_panel import ReportPanel
        from freecad.fgmesh.panels.showing import show

        show(ReportPanel(meshed(selected_mesh())), self.name)
