# SPDX-License-Identifier: GPL-3.0-or-later
"""Named groups of a meshing result: SolidN, FaceN, EdgeN, VertexN, as FreeCAD numbers them."""
import numpy as np


def members(word, numbers):
    """Yield (name, indices) for each number that occurs: ("Face3", indices of the cells with number 3). The number
    0 is that of parts which the shape given has not, and gives no name."""
    numbers = np.asarray(numbers)
    order = np.argsort(numbers, kind="stable")
    found, starts = np.unique(numbers[order], return_index=True)
    for number, indices in zip(found, np.split(order, starts[1:])):
        if number > 0:
            yield f"{word}{number}", indices


def face_groups(result):
    """Yield ("FaceN", indices of its triangles, ascending) for each face that has some. Triangles where faces
    coincide are in the groups of all of them."""
    triangles = np.arange(len(result.triangle_faces))
    coincident = np.asarray(result.coincident_faces, int).reshape(-1, 2)
    places = np.concatenate([triangles, coincident[:, 0]])
    faces = np.concatenate([result.triangle_faces, coincident[:, 1]])
    for name, chosen in members("Face", faces):
        yield name, np.sort(places[chosen])


def cell_groups(result):
    """For solids, faces and edges, in this order: their cells (n, nodes), 0-based points, and a list of (name,
    indices of its cells)."""
    yield np.asarray(result.tets), list(members("Solid", result.tet_solids))
    yield np.asarray(result.triangles), list(face_groups(result))
    yield np.asarray(result.edges), list(members("Edge", result.edge_edges))


def node_groups(result):
    """Yield (name, 0-based points, sorted) for each solid, face, edge and vertex.

    Those of "FaceN" are all nodes of its triangles: those on its edges, too, and middle nodes even where they
    are straightened off the true face. A load or a support of a face acts on its facets, which without these
    nodes would be held or loaded at their corners alone. Likewise for the others.
    """
    for cells, groups in cell_groups(result):
        for name, chosen in groups:
            yield name, np.unique(cells[chosen])
    dimension, number = np.asarray(result.carriers).T
    vertices = np.flatnonzero(dimension == 0)
    for name, chosen in members("Vertex", number[vertices]):
        yield name, vertices[chosen]
