# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing result as a Fem mesh of FreeCAD's, with groups for faces and solids."""
import Fem
import numpy as np

# FreeCAD numbers the nodes of a tetrahedron in the opposite sense to VTK: given in VTK's order, CalculiX
# finds a negative Jacobian in each.
_NODES = {4: [1, 0, 2, 3], 10: [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]}


def to_fem_mesh(result):
    """Fem.FemMesh of a core.MeshingResult.

    Point i becomes node i + 1, tetrahedron i becomes volume i + 1; the boundary triangles follow. Groups, N
    being the number that FreeCAD gives the face or solid: `SolidN` (volumes), `FaceN` (triangles) and
    `FaceN_Nodes` (all nodes on the face, those on its edges too).
    """
    mesh = Fem.FemMesh()
    for number, (x, y, z) in enumerate(result.points.tolist(), 1):
        mesh.addNode(x, y, z, number)
    tets = np.asarray(result.tets)
    volumes = tets[:, _NODES[tets.shape[1]]] + 1
    for number, nodes in enumerate(volumes.tolist(), 1):
        mesh.addVolume(nodes, number)
    triangles = np.asarray(result.triangles) + 1
    for number, nodes in enumerate(triangles.tolist(), len(volumes) + 1):
        mesh.addFace(nodes, number)
    _add_groups(mesh, np.asarray(result.tet_solids), triangles, np.asarray(result.triangle_faces))
    return mesh


def _add_groups(mesh, tet_solids, triangles, triangle_faces):
    for solid in np.unique(tet_solids).tolist():
        _add_group(mesh, f"Solid{solid}", "Volume", np.flatnonzero(tet_solids == solid) + 1)
    first_triangle = len(tet_solids) + 1
    for face in np.unique(triangle_faces).tolist():
        of_face = np.flatnonzero(triangle_faces == face)
        _add_group(mesh, f"Face{face}", "Face", of_face + first_triangle)
        _add_group(mesh, f"Face{face}_Nodes", "Node", np.unique(triangles[of_face]))


def _add_group(mesh, name, kind, numbers):
    mesh.addGroupElements(mesh.addGroup(name, kind), numbers.tolist())
