# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Preview: shows a graded solid coloured by its material."""
from freecad.fgmesh.commands.command import Command, free_for_panel
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.selection import selected_solid


class PreviewCommand(Command):
    name, icon, shortcut = "FGMesh_Preview", "preview", "G, P"
    text = TRANSLATE_LATER("FGMesh_Preview", "Preview of the material")
    tip = TRANSLATE_LATER(
        "FGMesh_Preview", "Colours the selected graded solid by its material, whole or cut open"
    )

    def IsActive(self):
        return free_for_panel() and selected_solid() is not None

    def run(self):
        from freecad.fgmesh.panels.material_offer import has_or_gets_material
        from freecad.fgmesh.panels.preview_panel import PreviewPanel
        from freecad.fgmesh.panels.showing import show

        if has_or_gets_material(selected_solid()):
            show(PreviewPanel(selected_solid()), self.name)
