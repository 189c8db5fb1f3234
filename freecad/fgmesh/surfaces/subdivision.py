# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles divided until their edges are short, without gaps between neighbours. NumPy and SciPy alone."""
import numpy as np

_COARSER = 1.25


def subdivide(rows, triangles, limit, most):
    """`rows` (n, 3 or more) and `triangles` (m, 3), with edges no longer than `limit`.

    rows   position in the first three columns; what else a point has is interpolated with it
    most   triangles: the limit grows where there would be more

    Whether an edge is halved depends on its own ends alone, so that triangles stay neighbours even where their
    points are not the same but only equal. The old rows stay in front.
    """
    done = []
    while len(triangles):
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2)
        squares = ((rows[edges[:, :, 0], :3] - rows[edges[:, :, 1], :3]) ** 2).sum(axis=2)
        is_long = squares > limit**2
        room = most - sum(map(len, done)) - len(triangles)
        while is_long.sum() > max(room, 0):
            limit *= _COARSER
            is_long = squares > limit**2
        active = is_long.any(axis=1)
        done.append(triangles[~active])
        triangles, edges, is_long = triangles[active], edges[active], is_long[active]
        if not len(triangles):
            break
        chosen, places = np.unique(edges[is_long] @ [len(rows), 1], return_inverse=True)
        middles = np.full(is_long.shape, -1)
        middles[is_long] = len(rows) + places.ravel()
        rows = np.concatenate([rows, (rows[chosen // len(rows)] + rows[chosen % len(rows)]) / 2])
        triangles = _divided(rows, triangles, middles)
    return rows, np.concatenate(done) if done else triangles


def weld(rows):
    """(n,): the same number for equal rows, numbers from 0 without gaps."""
    order = np.lexsort(rows.T)
    is_new = (rows[order[1:]] != rows[order[:-1]]).any(axis=1)
    numbers = np.empty(len(rows), np.int64)
    numbers[order] = np.concatenate([[0], np.cumsum(is_new)])
    return numbers


def merged(points, tolerance):
    """The same number for all of `points` (n, 3) that lie within `tolerance` of each other, and the points made equal."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    pairs = cKDTree(points).query_pairs(tolerance, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs), bool), pairs.T), shape=(len(points),) * 2)
    places = connected_components(links, directed=False)[1]
    first = np.unique(places, return_index=True)[1]
    return places, points[first[places]]


def _divided(rows, triangles, middles):
    """The pieces of `triangles`; `middles` (m, 3) of their edges 01, 12, 20, negative where an edge stays whole."""
    halved = middles >= 0
    count = halved.sum(axis=1)
    # Turned so that of one halved edge it is 01, and of two they are 01 and 12.
    first = np.where(count == 1, halved.argmax(axis=1), (halved.argmin(axis=1) + 1) % 3)
    turn = (first[:, None] + np.arange(3)) % 3
    corners = np.take_along_axis(triangles, turn, axis=1)
    middles = np.take_along_axis(middles, turn, axis=1)

    a, b, c, ab = *corners[count == 1].T, middles[count == 1, 0]
    pieces = [(a, ab, c), (ab, b, c)]
    a, b, c, ab, bc = *corners[count == 2].T, *middles[count == 2, :2].T
    pieces.append((ab, b, bc))
    straight = _distance(rows, ab, c) <= _distance(rows, a, bc)
    pieces += [(a, ab, np.where(straight, c, bc)), (np.where(straight, ab, a), bc, c)]
    a, b, c, ab, bc, ca = *corners[count == 3].T, *middles[count == 3].T
    pieces += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([np.column_stack(piece) for piece in pieces])


def _distance(rows, start, end):
    return ((rows[start, :3] - rows[end, :3]) ** 2).sum(axis=1)
