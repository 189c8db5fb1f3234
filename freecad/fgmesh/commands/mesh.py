# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh_Mesh: meshes the selected graded solid, or meshes a selected mesh again."""
import FreeCAD
import FreeCADGui

from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.model.mesh_object import is_mesh
from freecad.fgmesh.view import ICON


class MeshCommand:
    def GetResources(self):
        return {
            "Pixmap": ICON,
            "MenuText": "Mesh graded solid",
            "ToolTip": "Makes the mesh of the selected graded solid, or makes the selected mesh again. "
            "attach_material() in a macro gives a solid its material.",
        }

    def IsActive(self):
        chosen = FreeCADGui.Selection.getSelection()
        return len(chosen) == 1 and (is_mesh(chosen[0]) or bool(graded_parts(chosen[0])))

    def Activated(self):
        (chosen,) = FreeCADGui.Selection.getSelection()
        target = f"FreeCAD.getDocument({chosen.Document.Name!r}).getObject({chosen.Name!r})"
        FreeCADGui.addModule("freecad.fgmesh")
        FreeCADGui.doCommand(f"target = {target}")
        try:
            if not is_mesh(chosen):
                FreeCADGui.doCommand("target = freecad.fgmesh.make_mesh(target.Document, target)")
            FreeCADGui.doCommand("freecad.fgmesh.generate(target)")
            FreeCADGui.doCommand("target.Document.recompute()")
        except (
            Exception
        ) as error:  # a dialog would be better company than a traceback, the report view will do
            FreeCAD.Console.PrintError(f"FGMesh: {error}\n")
