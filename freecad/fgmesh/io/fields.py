# SPDX-License-Identifier: GPL-3.0-or-later
"""The fields of a meshing result, by name, for files that hold fields."""
import numpy as np

from freecad.fgmesh.io.boundary import element_sides


def point_data(result):
    """Fields of the points, by name, each (n,): volume fractions, which sum to one; `vertex` and `edge`, N of the
    VertexN that a point stands on or of the EdgeN that it lies on between its ends, 0 where there is none."""
    fractions = {
        f"fraction_{number}": column for number, column in enumerate(np.asarray(result.fractions).T, 1)
    }
    dimension, number = np.asarray(result.carriers).T
    vertex = np.where(dimension == 0, number, 0)
    edge = np.zeros_like(vertex)
    # Of those that meet at a vertex which the shape given has not, one with a number.
    np.maximum.at(edge, np.asarray(result.edges), np.asarray(result.edge_edges)[:, None])
    edge[vertex > 0] = 0
    return {**fractions, "vertex": vertex, "edge": edge}


def cell_data(result):
    """Fields of the cells, by name: one array for the tetrahedra, one for the triangles.

    Tetrahedra carry face 0, triangles solid 0. Triangles carry the variation and the angle of the tetrahedron
    behind them: viewers draw them in front of it.
    """
    behind, _ = element_sides(result)
    variation, angle = np.asarray(result.variation), np.asarray(result.dihedral_min)
    return {
        "solid": [np.asarray(result.tet_solids, np.int32), np.zeros(len(behind), np.int32)],
        "face": [np.zeros(len(variation), np.int32), np.asarray(result.triangle_faces, np.int32)],
        "variation": [variation, variation[behind]],
        "dihedral_min": [angle, angle[behind]],
    }
