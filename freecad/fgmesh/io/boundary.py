# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tetrahedron stands behind a boundary triangle."""
import numpy as np

# Corners of S1 to S4 of a C3D4 or C3D10 (CalculiX manual, "Four-node tetrahedral element").
SIDES = np.array([(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])


def element_sides(result):
    """For each triangle one tetrahedron that has it as a side, and which of its SIDES (0 to 3) it is.

    Two arrays (t,). Raises ValueError where a triangle is no side of a tetrahedron.
    """
    tets, triangles = np.asarray(result.tets)[:, :4], np.asarray(result.triangles)[:, :3]
    on_triangles = np.zeros(tets.max(initial=-1) + 1, bool)
    on_triangles[triangles] = True
    sides = tets[:, SIDES].reshape(-1, 3)
    candidates = np.flatnonzero(on_triangles[sides].all(axis=1))
    corners = np.sort(np.vstack([sides[candidates], triangles]), axis=1)
    _, identity = np.unique(corners, axis=0, return_inverse=True)
    identity = identity.reshape(-1)
    side_of = np.full(len(corners), -1)
    side_of[identity[: len(candidates)]] = candidates
    found = side_of[identity[len(candidates) :]]
    if (found < 0).any():
        raise ValueError("a boundary triangle is the side of no tetrahedron")
    return found // 4, found % 4
