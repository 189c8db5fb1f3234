# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh with named groups as a Fem mesh of FreeCAD's, with groups for solids, faces, edges and vertices, and back."""
import Fem
import numpy as np

from freecad.fgmesh.io.groups import WORDS, Group, GroupedMesh, grouped, groups_by_number
from freecad.fgmesh.io.names import clean_names
from freecad.fgmesh.model.options import GROUP_KINDS

# FreeCAD numbers the nodes of a tetrahedron in the opposite sense to VTK: given in VTK's order, CalculiX
# finds a negative Jacobian in each. Each of these orders takes itself back.
_NODES = {4: [1, 0, 2, 3], 10: [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]}

_KINDS = ("Node", "Edge", "Face", "Volume")
"""What FreeCAD calls the members of a group, by their dimension."""

_OF_NODES = "_Nodes"
"""How the name of a group of nodes ends that belongs to one of elements, or to a vertex."""

_CHUNK = 5000
"""Nodes or elements between two steps: some hundredths of a second."""


def to_fem_mesh(result, kinds=GROUP_KINDS):
    """Fem.FemMesh of a core.MeshingResult.

    Point i becomes node i + 1, tetrahedron i becomes volume i + 1; the boundary triangles follow, then the mesh
    edges along edges of the shape. Groups, N being the number that FreeCAD gives the part of the shape: `SolidN`
    (volumes), `FaceN` (triangles), `EdgeN` (edges), and `SolidN_Nodes`, `FaceN_Nodes`, `EdgeN_Nodes`,
    `VertexN_Nodes`, as io.groups tells of them; of `kinds` alone. Seams and the edges that are but a point have no group.
    """
    mesh = Fem.FemMesh()
    for _ in fill(mesh, result, kinds):
        pass
    return mesh


def fill(mesh, result, kinds=GROUP_KINDS):
    """Makes `mesh`, an empty Fem.FemMesh, what to_fem_mesh() gives, in steps of some hundredths of a second: yields the
    share that is done after each, from 0 to 1."""
    source = grouped(result)
    wanted = [group for group in source.groups if WORDS[group.dimension] in kinds]
    total = len(source.points) + sum(len(source.cells(dimension)) for dimension in (1, 2, 3))
    total += sum(len(source.nodes(group)) + len(group.members) * (group.dimension > 0) for group in wanted)
    done = 0
    for step in _steps(mesh, source, wanted):
        done += step
        yield done / max(total, 1)


def _steps(mesh, source, wanted):
    """Yields how many nodes, elements or members of groups each step has added."""
    for first, rows in _chunks(source.points):
        for number, (x, y, z) in enumerate(rows.tolist(), 1 + first):
            mesh.addNode(x, y, z, number)
        yield len(rows)
    start = 1
    for dimension, add in ((3, mesh.addVolume), (2, mesh.addFace), (1, mesh.addEdge)):
        cells = source.cells(dimension)
        nodes = cells[:, _NODES[cells.shape[1]]] if dimension == 3 else cells
        for first, rows in _chunks(nodes):
            for number, row in enumerate((rows + 1).tolist(), start + first):
                add(row, number)
            yield len(rows)
        for group in wanted:
            if group.dimension == dimension:
                yield from _add_group(mesh, group.name, _KINDS[dimension], group.members + start)
        start += len(cells)
    for group in wanted:
        yield from _add_group(mesh, f"{group.name}{_OF_NODES}", _KINDS[0], source.nodes(group) + 1)


def points_and_tets(mesh):
    """Points (n, 3) and tets (m, 4 or 10), as in the core.MeshingResult that `mesh`, a Fem.FemMesh, was made of."""
    points = np.array([tuple(point) for point in mesh.Nodes.values()]).reshape(-1, 3)
    tets = _cells(mesh, mesh.Volumes, 4)
    return points, tets[:, _NODES[tets.shape[1]]]


def kept_points_and_tets(mesh):
    """points_and_tets() of mesh.FemMesh, `mesh` being a mesh object: kept, since FreeCAD gives them slowly."""
    kept = mesh.Proxy.kept.arrays
    if kept is None or kept[0] != mesh.Fingerprint:
        kept = mesh.Proxy.kept.arrays = mesh.Fingerprint, points_and_tets(mesh.FemMesh)
    return kept[1]


def from_fem_mesh(mesh, solids, without=(), taken=()):
    """The GroupedMesh of `mesh`, a Fem.FemMesh that to_fem_mesh() made and whose groups others may have changed.

    solids (m,): N of the SolidN of each tetrahedron. Of the groups those of a name in `without` are left out. Names
    that are no SolidN, FaceN, EdgeN or VertexN become clean ones (io.names), which differ from those `taken`.
    """
    points, tets = points_and_tets(mesh)
    ids = [
        np.arange(1, len(points) + 1),
        *(np.array(found, int) for found in (mesh.Edges, mesh.Faces, mesh.Volumes)),
    ]
    found = []
    for key in mesh.Groups:
        name, dimension = mesh.getGroupName(key), _KINDS.index(mesh.getGroupElementType(key))
        if name not in without:
            members = np.searchsorted(ids[dimension], sorted(mesh.getGroupElements(key)))
            found.append(Group(name, dimension, members))
    parts, others = _parts_and_others(found)
    parts = [*groups_by_number(3, solids), *(part for part in parts if part.dimension < 3)]
    others = [group for group in others if len(group.members)]
    names = clean_names([group.name for group in others], [*taken, *(part.name for part in parts)])
    others = [group._replace(name=name) for group, name in zip(others, names)]
    triangles, edges = _cells(mesh, mesh.Faces, 3), _cells(mesh, mesh.Edges, 2)
    return GroupedMesh(points, tets, triangles, edges, parts + others)


def _parts_and_others(groups):
    """Those of parts of the shape, by dimension and number; and all others but the nodes of groups of elements."""
    elements = {group.name for group in groups if group.dimension > 0}
    parts, others = [], []
    for group in groups:
        if group.dimension == 0 and group.name.endswith(_OF_NODES):
            group = group._replace(name=group.name.removesuffix(_OF_NODES))
            if group.name in elements:
                continue
        (parts if group.number else others).append(group)
    return sorted(parts, key=lambda part: (-part.dimension, part.number)), others


def _cells(mesh, ids, corners):
    """(n, nodes), 0-based."""
    rows = [mesh.getElementNodes(number) for number in ids]
    return np.array(rows, np.int32).reshape(len(rows), len(rows[0]) if rows else corners) - 1


def _add_group(mesh, name, kind, numbers):
    group = mesh.addGroup(name, kind)
    for _, some in _chunks(numbers):
        mesh.addGroupElements(group, some.tolist())
        yield len(some)


def _chunks(rows):
    """(index of the first, some of `rows`) again and again."""
    for first in range(0, len(rows), _CHUNK):
        yield first, rows[first : first + _CHUNK]
