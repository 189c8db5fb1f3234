# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with named groups: SolidN, FaceN, EdgeN, VertexN, as FreeCAD numbers them, and others of a user's."""
import re
from typing import NamedTuple

import numpy as np

WORDS = ("Vertex", "Edge", "Face", "Solid")
"""What a part of the shape is called, by its dimension."""

_PART = re.compile(rf"({'|'.join(WORDS)})([1-9]\d{{0,8}})")


class Group(NamedTuple):
    """Some of the cells of a mesh, or of its points."""

    name: str
    dimension: int  # 3: tetrahedra, 2: triangles, 1: edges, 0: points
    members: np.ndarray  # 0-based, ascending

    @property
    def number(self):
        """N, where it is the SolidN, FaceN, EdgeN or VertexN that its dimension has; 0 for any other."""
        part = _PART.fullmatch(self.name)
        return int(part[2]) if part and part[1] == WORDS[self.dimension] else 0


class GroupedMesh(NamedTuple):
    """What is written to files: a mesh whose names are clean, as names.clean_names makes them."""

    points: np.ndarray  # (n, 3), mm
    tets: np.ndarray  # (m, 4 or 10), 0-based, in the order of VTK; so are the others
    triangles: np.ndarray  # (t, 3 or 6): the boundary and the interfaces
    edges: np.ndarray  # (e, 2 or 3): along edges of the shape
    groups: list  # of Group; solids, then faces, edges, vertices, then others

    def cells(self, dimension):
        """The cells (n, nodes) of a dimension; of dimension 0 the points."""
        return (
            np.arange(len(self.points))[:, None],
            self.edges,
            self.triangles,
            self.tets,
        )[dimension]

    def of(self, dimension):
        """The groups of cells of a dimension, a list."""
        return [group for group in self.groups if group.dimension == dimension]

    def nodes(self, group):
        """The 0-based points of a group, sorted.

        Those of "FaceN" are all nodes of its triangles: those on its edges, too, and middle nodes even where they
        are straightened off the true face. A load or a support of a face acts on its facets, which without these
        nodes would be held or loaded at their corners alone. Likewise for the others.
        """
        return np.unique(self.cells(group.dimension)[group.members])

    def numbers(self, dimension):
        """(n,) int32: for each cell of a dimension the lowest N of the SolidN, FaceN, EdgeN or VertexN that it is in, 0
        where it is in none."""
        numbers = np.zeros(len(self.cells(dimension)), np.int32)
        for group in sorted(self.of(dimension), key=lambda group: -group.number):
            if group.number:
                numbers[group.members] = group.number
        return numbers


def grouped(result):
    """The GroupedMesh of a core.MeshingResult: a group for each part of the shape that has some of the mesh.

    Triangles where faces coincide are in the groups of all of them. Parts that the shape given has not have none.
    """
    triangles = np.arange(len(result.triangle_faces))
    coincident = np.asarray(result.coincident_faces, int).reshape(-1, 2)
    dimension, number = np.asarray(result.carriers).T
    vertices = np.flatnonzero(dimension == 0)
    of_dimension = (
        (vertices, number[vertices]),
        (np.arange(len(result.edge_edges)), result.edge_edges),
        (
            np.concatenate([triangles, coincident[:, 0]]),
            np.concatenate([result.triangle_faces, coincident[:, 1]]),
        ),
        (np.arange(len(result.tet_solids)), result.tet_solids),
    )
    groups = [group for dimension in (3, 2, 1, 0) for group in _numbered(dimension, *of_dimension[dimension])]
    cells = (np.asarray(cells) for cells in (result.tets, result.triangles, result.edges))
    return GroupedMesh(np.asarray(result.points), *cells, groups)


def groups_by_number(dimension, numbers):
    """The Groups of the cells of a dimension with these numbers (n,): FaceN of those with N, none for 0."""
    return list(_numbered(dimension, np.arange(len(numbers)), numbers))


def _numbered(dimension, places, numbers):
    numbers = np.asarray(numbers)
    order = np.argsort(numbers, kind="stable")
    found, starts = np.unique(numbers[order], return_index=True)
    for number, chosen in zip(found, np.split(order, starts[1:])):
        if number > 0:
            yield Group(f"{WORDS[dimension]}{number}", dimension, np.sort(places[chosen]))
