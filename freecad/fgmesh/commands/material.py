# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Material: gives the selected solids a graded material."""
from freecad.fgmesh.commands.command import Command, free_for_panel
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.selection import selected_solids


class MaterialCommand(Command):
    name, icon, shortcut = "FGMesh_Material", "material", "G, M"
    text = TRANSLATE_LATER("FGMesh_Material", "Graded material ...")
    tip = TRANSLATE_LATER(
        "FGMesh_Material", "Gives the selected solids a material that changes by a formula, or changes theirs"
    )

    def IsActive(self):
        return free_for_panel() and bool(selected_solids())

    def run(self):
        from freecad.fgmesh.panels.material_panel import MaterialPanel
        from freecad.fgmesh.panels.showing import show

        show(MaterialPanel(selected_solids()), self.name)
