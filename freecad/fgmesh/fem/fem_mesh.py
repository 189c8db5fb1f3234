# SPDX-License-Identifier: GPL-3.0-or-later
"""A meshing result as a Fem mesh of FreeCAD's, with groups for solids, faces, edges and vertices."""
import Fem
import numpy as np

from freecad.fgmesh.io.groups import cell_groups, node_groups
from freecad.fgmesh.model.options import GROUP_KINDS

# FreeCAD numbers the nodes of a tetrahedron in the opposite sense to VTK: given in VTK's order, CalculiX
# finds a negative Jacobian in each. Each of these orders takes itself back.
_NODES = {4: [1, 0, 2, 3], 10: [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]}


def to_fem_mesh(result, kinds=GROUP_KINDS):
    """Fem.FemMesh of a core.MeshingResult.

    Point i becomes node i + 1, tetrahedron i becomes volume i + 1; the boundary triangles follow, then the mesh
    edges along edges of the shape. Groups, N being the number that FreeCAD gives the part of the shape: `SolidN`
    (volumes), `FaceN` (triangles), `EdgeN` (edges), and `SolidN_Nodes`, `FaceN_Nodes`, `EdgeN_Nodes`,
    `VertexN_Nodes`, as io.groups tells of them; of `kinds` alone. Seams and the edges that are but a point have no group.
    """
    mesh = Fem.FemMesh()
    for number, (x, y, z) in enumerate(result.points.tolist(), 1):
        mesh.addNode(x, y, z, number)
    adders = (("Volume", mesh.addVolume), ("Face", mesh.addFace), ("Edge", mesh.addEdge))
    first = 1
    for (kind, add), (cells, groups) in zip(adders, cell_groups(result)):
        nodes = cells[:, _NODES[cells.shape[1]]] if kind == "Volume" else cells
        for number, row in enumerate((nodes + 1).tolist(), first):
            add(row, number)
        for name, chosen in _of(kinds, groups):
            _add_group(mesh, name, kind, chosen + first)
        first += len(cells)
    for name, nodes in _of(kinds, node_groups(result)):
        _add_group(mesh, f"{name}_Nodes", "Node", nodes + 1)
    return mesh


def points_and_tets(mesh):
    """Points (n, 3) and tets (m, 4 or 10), as in the core.MeshingResult that `mesh`, a Fem.FemMesh, was made of."""
    points = np.array([tuple(point) for point in mesh.Nodes.values()]).reshape(-1, 3)
    rows = [mesh.getElementNodes(number) for number in mesh.Volumes]
    tets = np.array(rows, np.int32).reshape(len(rows), len(rows[0]) if rows else 4) - 1
    return points, tets[:, _NODES[tets.shape[1]]]


def _of(kinds, groups):
    return [(name, chosen) for name, chosen in groups if name.rstrip("0123456789") in kinds]


def _add_group(mesh, name, kind, numbers):
    mesh.addGroupElements(mesh.addGroup(name, kind), numbers.tolist())
