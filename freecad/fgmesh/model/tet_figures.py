# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of single tetrahedra of a mesh that is in a document, which keeps those of the whole mesh alone."""
from itertools import combinations

import numpy as np


def smallest_dihedral_angles(points, tets):
    """(m,) degrees, of points (n, 3) and tets (m, 4 or more), corners first."""
    corners = points[tets[:, :4]]
    smallest = np.full(len(tets), 180.0)
    for start, end in combinations(range(4), 2):
        others = [corner for corner in range(4) if corner not in (start, end)]
        along = corners[:, end] - corners[:, start]
        first, second = (np.cross(along, corners[:, other] - corners[:, start]) for other in others)
        # Not by arccos, which loses the digits of small angles.
        sine = np.linalg.norm(np.cross(first, second), axis=1)
        smallest = np.minimum(smallest, np.degrees(np.arctan2(sine, (first * second).sum(axis=1))))
    return smallest


def variations(fractions, tets):
    """(m,): the largest difference of composition between corners (paper, equations 2.2 and 2.3), of the fractions
    (n, k - 1) of all constituents but the last."""
    corners = fractions[tets[:, :4]]
    if corners.shape[2] == 1:
        return np.ptp(corners[:, :, 0], axis=1)
    whole = np.concatenate([corners, 1 - corners.sum(axis=2, keepdims=True)], axis=2)
    pairs = combinations(range(4), 2)
    return np.max([np.linalg.norm(whole[:, i] - whole[:, j], axis=1) for i, j in pairs], axis=0)
