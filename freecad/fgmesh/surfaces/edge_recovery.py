# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges that a Delaunay triangulation of the plane lacks, brought in by flips.

The method is that of S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations, Computers &
Structures 47 (1993), without the last step, which would make the triangles about the new edges even again.
"""
from collections import deque

import numpy as np

_MOST_TURNS = 50  # for each edge that is crossed


def with_edges(points, triangles, wanted):
    """`triangles` (t, 3) of plane `points` (n, 2), counterclockwise, flipped so that they have the edges `wanted`
    (w, 2). An edge that cannot be had, since it crosses another or meets a point, is left out."""
    keys = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2) @ [len(points), 1]
    has = np.isin(wanted @ [len(points), 1], keys) | np.isin(wanted @ [1, len(points)], keys)
    if has.all():
        return triangles
    a, b, c = triangles.T.tolist()
    tips = dict(
        zip(zip(a + b + c, b + c + a), c + a + b)
    )  # of the triangle to the left of each directed edge
    places = points.tolist()
    starts = dict(zip(a + b + c, zip(b + c + a, c + a + b)))
    for start, end in wanted[~has].tolist():
        first = starts.get(start)
        if first is not None and end in starts:
            _bring_in(start, end, tips, places, starts)
    return np.array([(a, b, c) for (a, b), c in tips.items() if a < b and a < c], np.int64).reshape(-1, 3)


def _bring_in(start, end, tips, places, starts):
    crossed = deque(_crossed(start, end, tips, places, starts))
    turns = _MOST_TURNS * len(crossed)
    while crossed and turns:
        turns -= 1
        p, q = crossed.popleft()
        r, s = tips[p, q], tips[q, p]
        if _side(places, s, q, r) <= 0 or _side(places, r, p, s) <= 0:
            crossed.append((p, q))  # not convex: others must be flipped first
            continue
        del tips[p, q], tips[q, p]
        for one, two, tip in ((s, q, r), (q, r, s), (r, s, q), (r, p, s), (p, s, r), (s, r, p)):
            tips[one, two] = tip
        starts[p], starts[q], starts[r], starts[s] = (s, r), (r, s), (s, q), (r, p)
        if not {r, s} & {start, end} and _crosses(places, start, end, r, s):
            crossed.append((r, s))


def _crossed(start, end, tips, places, starts):
    """The edges between `start` and `end`, in this order; none where a point lies in the way."""
    # Once around `start` for the triangle that looks towards `end`, first to one side and then to the other.
    right, left = first = starts[start]
    while not _looks(places, start, end, right, left):
        right, left = left, tips.get((start, left))
        if left is None or (right, left) == first:
            break
    if left is None:
        right, left = first
        while right is not None and not _looks(places, start, end, right, left):
            right, left = tips.get((right, start)), right
    if right is None or left is None or not _looks(places, start, end, right, left):
        return []
    found = []
    while True:
        found.append((right, left))
        tip = tips.get((left, right))
        if tip == end:
            return found
        side = 0 if tip is None else _side(places, start, end, tip)
        if side == 0:
            return []
        right, left = (right, tip) if side > 0 else (tip, left)


def _looks(places, start, end, right, left):
    """Whether the ray from `start` to `end` leaves between `right` and `left`."""
    return _side(places, start, end, right) < 0 < _side(places, start, end, left)


def _crosses(places, a, b, c, d):
    return (
        _side(places, a, b, c) * _side(places, a, b, d) < 0
        and _side(places, c, d, a) * _side(places, c, d, b) < 0
    )


def _side(places, a, b, c):
    """Positive where c lies to the left of the line from a to b."""
    (ax, ay), (bx, by), (cx, cy) = places[a], places[b], places[c]
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
