# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane loops filled with even triangles. NumPy and SciPy alone."""
import numpy as np

from freecad.fgmesh.surfaces.edge_recovery import with_edges

_SPACING = 0.9  # of the limit; the longest edges between points of the grid stay below it
_CLEARANCE = 0.55  # to the rim, of the limit: a point nearer could come between the ends of a segment
_AROUND = 2.0  # of the limit, how far outside there are points


def filled(points, segments, normal, limit):
    """Points (p, 3), the given ones in front, and triangles (t, 3) that fill the closed loops of directed `segments`
    (s, 2) between plane `points` (n, 3), holes left out; seen from where `normal` points they go counterclockwise,
    as the outer loops do. No edge is much longer than `limit`, if no segment is.
    """
    from scipy.spatial import Delaunay, QhullError

    across = _across(normal)
    origin = points.mean(axis=0)
    flat = (points - origin) @ across.T / limit
    flat = np.concatenate([flat, _grid(flat, segments)])
    try:
        triangles = Delaunay(flat).simplices.astype(np.int64)
    except QhullError:  # a loop without an area
        return points, np.empty((0, 3), np.int64)
    a, b, c = flat[triangles].transpose(1, 0, 2)
    (u, v), (s, t) = (b - a).T, (c - a).T
    clockwise = u * t < v * s
    triangles[clockwise] = triangles[clockwise][:, ::-1]
    triangles = with_edges(flat, triangles, segments)
    has_all = np.isin(
        segments @ [len(flat), 1], triangles[:, [[0, 1], [1, 2], [2, 0]]] @ [len(flat), 1]
    ).all()
    inside = (
        _is_left(triangles, segments, len(flat)) if has_all else _is_surrounded(flat, triangles, segments)
    )
    triangles = triangles[inside]
    used = np.zeros(len(flat), bool)
    used[: len(points)] = used[triangles] = True
    new = origin + (flat[len(points) :] * limit) @ across
    return np.concatenate([points, new])[used], (np.cumsum(used) - 1)[triangles]


def _across(normal):
    """Two unit vectors (2, 3) across `normal`, in the right-handed order."""
    axis = np.eye(3)[np.abs(normal).argmin()]
    first = np.cross(axis, normal)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(normal, first)])


def _grid(flat, segments):
    """Points (g, 2) in regular triangles inside the loops and about them, except too near to the segments."""
    from scipy.spatial import cKDTree

    # Outside, too: along the border of what is triangulated rounding would decide about edges.
    low, high = flat.min(axis=0) - _AROUND, flat.max(axis=0) + _AROUND
    x, y = np.meshgrid(
        np.arange(low[0], high[0], _SPACING), np.arange(low[1], high[1], _SPACING * np.sqrt(0.75))
    )
    x[1::2] += _SPACING / 2
    (ax, ay), (bx, by) = flat[segments].transpose(1, 2, 0)
    inside = np.empty(x.shape, bool)
    for row, height in enumerate(y[:, 0]):
        crosses = (ay <= height) != (by <= height)
        share = (height - ay[crosses]) / (by - ay)[crosses]
        inside[row] = np.searchsorted(np.sort(ax[crosses] + share * (bx - ax)[crosses]), x[row]) % 2
    grid = np.column_stack([x.ravel(), y.ravel()])
    rim = np.concatenate([flat, flat[segments].mean(axis=1)])
    distance = cKDTree(rim).query(grid, distance_upper_bound=_AROUND)[0]  # infinite where it is more
    return grid[(distance > _CLEARANCE) & (inside.ravel() | (distance <= _AROUND))]


def _is_left(triangles, segments, size):
    """(t,): which of the triangles lie to the left of the segments, or hang together with such without a segment in
    between."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    owners = np.repeat(np.arange(len(triangles)), 3)
    keys, backs = edges @ [size, 1], edges @ [1, size]
    order = np.argsort(keys)
    place = np.minimum(np.searchsorted(keys[order], backs), len(keys) - 1)
    neighbours = np.where(keys[order][place] == backs, owners[order][place], -1)
    left, right = (np.isin(keys, segments @ pair) for pair in ([size, 1], [1, size]))
    joined = (neighbours >= 0) & ~left & ~right
    links = (np.ones(joined.sum(), bool), (owners[joined], neighbours[joined]))
    _, part = connected_components(coo_matrix(links, shape=(len(triangles),) * 2), directed=False)
    return np.bincount(part[owners], weights=left)[part] > 0


def _is_surrounded(flat, triangles, segments):
    """(t,): which of the triangles have a centre that the loops go around, even where they cross themselves, as those of
    two faces of a thin wall do whose triangles are too coarse for it."""
    (ax, ay), (bx, by) = flat[segments].transpose(1, 2, 0)
    slopes = (bx - ax) / np.where(by == ay, 1, by - ay)
    turns = [
        (((ay <= y) & (y < by)).astype(int) - ((by <= y) & (y < ay)))[ax + (y - ay) * slopes > x].sum()
        for x, y in flat[triangles].mean(axis=1)
    ]
    return np.array(turns) > 0
