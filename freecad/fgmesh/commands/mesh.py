# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Mesh: meshes the selected graded solid, or the selected mesh again."""
from freecad.fgmesh.commands.command import Command, free_for_panel
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.selection import selected_mesh, selected_solid


class MeshCommand(Command):
    name, icon, shortcut = "FGMesh_Mesh", "mesh", "G, T"
    text = TRANSLATE_LATER("FGMesh_Mesh", "Mesh graded solid ...")
    tip = TRANSLATE_LATER(
        "FGMesh_Mesh", "Makes the mesh of the selected graded solid, or makes the selected mesh again"
    )

    def IsActive(self):
        return free_for_panel() and (selected_mesh() or selected_solid()) is not None

    def run(self):
        from freecad.fgmesh.panels.material_offer import has_or_gets_material
        from freecad.fgmesh.panels.mesh_panel import open_mesh_panel

        thing = selected_mesh() or selected_solid()
        if selected_mesh() or has_or_gets_material(thing):
            open_mesh_panel(thing)
