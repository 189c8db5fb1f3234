# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers the workbench. FreeCAD imports this module when it starts with a GUI."""
import FreeCADGui

from freecad.fgmesh.model import presentation
from freecad.fgmesh.view import ICON, mesh_view, progress

presentation.show = mesh_view.show
presentation.progress = progress.progress


class FGMeshWorkbench(FreeCADGui.Workbench):
    MenuText = "FGMesh"
    ToolTip = "Tetrahedral FEM meshes of functionally graded solids"
    Icon = ICON

    def Initialize(self):
        # Only here, so that FreeCAD starts quickly, and starts where the compiled part is missing.
        from freecad.fgmesh.commands.mesh import MeshCommand

        FreeCADGui.addCommand("FGMesh_Mesh", MeshCommand())
        self.appendToolbar("FGMesh", ["FGMesh_Mesh"])
        self.appendMenu("&FGMesh", ["FGMesh_Mesh"])

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(FGMeshWorkbench())
