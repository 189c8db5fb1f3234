# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that the context menu of the tree and of the 3D view offers."""
from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.view.selection import selected_mesh, selected_solids


def commands_for_selection():
    """Names of the commands that suit what is selected: a material for solids, meshing for those that have one."""
    if selected_mesh() is not None:
        return ["FGMesh_Mesh", "FGMesh_Report", "FGMesh_Analysis"]
    solids = selected_solids()
    if len(solids) == 1 and graded_parts(solids[0]):
        return ["FGMesh_Material", "FGMesh_Preview", "FGMesh_Mesh"]
    return ["FGMesh_Material"] if solids else []
