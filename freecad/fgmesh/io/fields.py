# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields by name, for files that hold fields."""
from typing import NamedTuple

import numpy as np

from freecad.fgmesh.io.boundary import element_sides


class Fields(NamedTuple):
    """Numbers at the points and in the cells of a GroupedMesh."""

    at_points: dict  # {name: (n,)}
    in_cells: dict  # {name: [(m,) of the tetrahedra, (t,) of the triangles]}


def fields_of(mesh, result):
    """Those of a core.MeshingResult, whose GroupedMesh is `mesh`: volume fractions, which sum to one; variation and
    smallest dihedral angle; and those of `fields_with`."""
    fractions = {
        f"fraction_{number}": column for number, column in enumerate(np.asarray(result.fractions).T, 1)
    }
    of_tets = {"variation": result.variation, "dihedral_min": result.dihedral_min}
    return fields_with(mesh, fractions, of_tets)


def fields_with(mesh, at_points, of_tets):
    """Fields with the values `at_points`, {name: (n,)}, and those `of_tets`, {name: (m,)}; and what part of the shape
    each point and cell belongs to.

    At points `vertex` and `edge`: N of the VertexN that a point stands on or of the EdgeN that it lies on between its
    ends, 0 where there is none. In cells `solid` and `face`: tetrahedra carry face 0, triangles solid 0. Triangles
    carry the other values of the tetrahedron behind them: viewers draw them in front of it.
    """
    vertex = mesh.numbers(0)
    edge = np.zeros_like(vertex)
    # Of those that meet at a vertex which the shape given has not, one with a number.
    np.maximum.at(edge, mesh.edges, mesh.numbers(1)[:, None])
    edge[vertex > 0] = 0
    behind, _ = element_sides(mesh)
    in_cells = {
        "solid": [mesh.numbers(3), np.zeros(len(behind), np.int32)],
        "face": [np.zeros(len(mesh.tets), np.int32), mesh.numbers(2)],
        **{name: [np.asarray(values), np.asarray(values)[behind]] for name, values in of_tets.items()},
    }
    return Fields({**at_points, "vertex": vertex, "edge": edge}, in_cells)
