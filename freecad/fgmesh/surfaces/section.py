# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane cuts closed triangulated solids: what lies behind it, and the cut faces. Knows neither FreeCAD nor Qt."""
from dataclasses import dataclass

import numpy as np

from freecad.fgmesh.surfaces.filling import filled
from freecad.fgmesh.surfaces.subdivision import merged

_ON_PLANE = 1e-9  # of the diagonal
_SAME = 1e-4  # of the limit


@dataclass
class Section:
    """What is left of a Surface. The points of the surface keep their numbers, the new ones follow them.

    points (n, 3), normals (n, 3), solids (n,): the new points alone. triangles (m, 3): what is left of the surface.
    caps: [(number of a solid, its cut faces (c, 3), seen from the removed side)]. edges (e, 2): pieces of the edges of
    the faces that are left, and of the caps. Triangles and caps together are closed; their points along the cut are
    equal, not the same.
    """

    points: np.ndarray
    normals: np.ndarray
    solids: np.ndarray
    triangles: np.ndarray
    caps: list
    edges: np.ndarray


def cut(surface, origin, normal, limit):
    """The Section of `surface`, a surface.Surface, by the plane through `origin`; what lies on the side to
    which `normal` points is removed. Edges of the caps are no longer than `limit`, or than those around them.
    """
    origin, normal = np.asarray(origin, float), np.asarray(normal, float)
    normal = normal / np.linalg.norm(normal)
    # Not a matrix product: it may round equal points differently.
    heights = ((surface.points - origin) * normal).sum(axis=1)
    heights[np.abs(heights) < _ON_PLANE * surface.diagonal] = 0
    removed = heights >= 0  # what lies in the plane is removed: the cap takes its place
    pieces, rims, solids = _cut_triangles(surface, removed)
    keys, rims = np.unique(rims, return_inverse=True)
    rims = rims.reshape(-1, 2)
    size = len(surface.points)
    kept, gone = keys // size, keys % size
    share = (heights[kept] / (heights[kept] - heights[gone]))[:, None]
    points = (1 - share) * surface.points[kept] + share * surface.points[gone]
    normals = (1 - share) * surface.normals[kept] + share * surface.normals[gone]
    places, points = merged(points, _SAME * limit)

    def numbered(corners):  # those below zero are edges that the plane cuts
        return np.where(corners >= 0, corners, size + np.searchsorted(keys, -1 - corners))

    whole = surface.triangles[~removed[surface.triangles].any(axis=1)]
    found = [_cap(rims[solids == solid], points, places, normal, limit) for solid in np.unique(solids)]
    caps, edges, first = [], [numbered(_cut_edges(surface, removed))], size + len(points)
    for solid, (rows, triangles, rim) in zip(np.unique(solids).tolist(), found):
        caps.append((solid, triangles + first))
        edges.append(rim + first)
        first += len(rows)
    return Section(
        np.concatenate([points, *(rows for rows, _, _ in found)]),
        np.concatenate([normals, *(np.broadcast_to(normal, rows.shape) for rows, _, _ in found)]),
        np.concatenate([surface.solids[kept]] + [np.full(len(f[0]), s) for f, (s, _) in zip(found, caps)]),
        np.concatenate([whole, numbered(pieces)]),
        caps,
        np.concatenate(edges),
    )


def _cut_triangles(surface, removed):
    """Pieces (p, 3) that are left of the triangles on both sides, with -1 - key for a point on an edge; keys (r, 2) of
    the segments where they were cut, as the cap goes around; the solid (r,) of each segment."""
    count = removed[surface.triangles].sum(axis=1)
    triangles = surface.triangles[(count == 1) | (count == 2)]
    odd = removed[triangles] == (removed[triangles].sum(axis=1, keepdims=True) == 1)
    turn = (odd.argmax(axis=1)[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(triangles, turn, axis=1).T  # a is alone on its side
    is_tip = ~removed[a]
    size = len(surface.points)
    ab, ca = (np.where(is_tip, a * size + other, other * size + a) for other in (b, c))
    pieces = np.concatenate(
        [
            np.column_stack([a, -1 - ab, -1 - ca])[is_tip],
            np.column_stack([-1 - ab, b, c])[~is_tip],
            np.column_stack([-1 - ab, c, -1 - ca])[~is_tip],
        ]
    )
    rims = np.where(is_tip[:, None], np.column_stack([ca, ab]), np.column_stack([ab, ca]))
    return pieces, rims, surface.solids[a]


def _cut_edges(surface, removed):
    """What is left of the edges, with -1 - key for a point on a cut one."""
    start, end = surface.edges.T
    start, end = np.where(removed[start], end, start), np.where(removed[start], start, end)
    left = ~removed[start]
    start, end = start[left], end[left]
    return np.column_stack([start, np.where(removed[end], -1 - (start * len(surface.points) + end), end)])


def _cap(rims, points, places, normal, limit):
    """Points, triangles and rim segments of the cut faces of one solid.

    rims (r, 2): the segments around them; equal `places` tell which of `points` are the same.
    """
    _, first, corners = np.unique(places[rims], return_index=True, return_inverse=True)
    rows, corners = points[rims.ravel()[first]], _without_returns(corners.reshape(-1, 2))
    if not len(corners):
        return rows, np.empty((0, 3), np.int64), corners
    longest = np.sqrt(((rows[corners[:, 0]] - rows[corners[:, 1]]) ** 2).sum(axis=1).max())
    rows, triangles = filled(rows, corners, normal, max(limit, longest))
    return rows, triangles, corners


def _without_returns(segments):
    """Directed `segments` (s, 2) without those of no length, and without pairs that go there and back."""
    segments = segments[segments[:, 0] != segments[:, 1]]
    size = segments.max(initial=0) + 1
    keys, counts = np.unique(segments @ [size, 1], return_counts=True)
    back_keys, back_counts = np.unique(segments @ [1, size], return_counts=True)
    backs = np.zeros_like(counts)
    _, here, there = np.intersect1d(keys, back_keys, return_indices=True)
    backs[here] = back_counts[there]
    keys = np.repeat(keys, np.maximum(counts - backs, 0))
    return np.column_stack([keys // size, keys % size])
