# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of solids as small triangles, to be coloured by a field."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.surfaces.subdivision import merged, subdivide, weld

FINENESS = 50
"""Edges of the triangles are at most the diagonal of the shape divided by this."""

MOST_TRIANGLES = 200_000

# Of the diagonal, and between neighbouring chords, radians: a little finer than FreeCAD's own display.
_DEFLECTION, _ANGLE = 1 / 500, 0.3
_COARSER = 3
_SAME = 1e-8  # of the diagonal


@dataclass
class Surface:
    """Closed surfaces of solids, in the coordinates of the shape.

    points (n, 3); normals (n, 3), outward; solids (n,), number of the solid, from 0. Each face has its own points, so
    that normals can differ along its edges; equal points of a solid are exactly equal. triangles (m, 3), outward.
    diagonal: of the bounding box.
    """

    points: np.ndarray
    normals: np.ndarray
    solids: np.ndarray
    triangles: np.ndarray
    diagonal: float

    @cached_property
    def welded(self):
        """(n,): the same number for all points of one solid in the same place."""
        return weld(np.column_stack([self.points, self.solids]))

    @cached_property
    def edges(self):
        """(e, 2): pieces of the edges between faces, each once."""
        pairs = self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        ordered = np.sort(pairs, axis=1) @ [len(self.points), 1]
        _, first, count = np.unique(ordered, return_index=True, return_counts=True)
        rims = pairs[first[count == 1]]
        places = np.sort(self.welded[rims], axis=1) @ [len(self.points), 1]
        return rims[np.unique(places, return_index=True)[1]]


def shown_surface(brep, diagonal, fineness=FINENESS, most=MOST_TRIANGLES, control=None):
    """The Surface of all solids in a BREP or STEP text (bytes), whose bounding box has this diagonal, mm. Where a shape
    has so many details that there would be more than `most` triangles it is coarser. control: core.RunControl. Raises
    core.InvalidInput, core.GeometryError, core.Cancelled."""
    parts = _parts(brep, _DEFLECTION * diagonal, _ANGLE, control)
    if sum(len(triangles) for _, triangles in parts) > most:
        parts = _parts(brep, _COARSER * _DEFLECTION * diagonal, _COARSER * _ANGLE, control)
    rows, triangles = _joined(
        [(np.column_stack([own, np.full(len(own), number)]), t) for number, (own, t) in enumerate(parts)]
    )
    rows, triangles = subdivide(rows, triangles, diagonal / fineness, most)
    lengths = np.linalg.norm(rows[:, 3:6], axis=1, keepdims=True)
    normals = np.divide(rows[:, 3:6], lengths, out=np.zeros((len(rows), 3)), where=lengths > 0)
    points = np.ascontiguousarray(rows[:, :3])
    return Surface(points, normals, rows[:, 6].astype(np.int32), triangles, diagonal)


def _parts(brep, deflection, angle, control):
    """For each solid rows (n, 6) of positions and normals, and triangles (m, 3), face by face."""
    faces = core.shown_triangles(brep, deflection, angle, control)
    solids = {}
    for solid, points, triangles in faces:
        solids.setdefault(solid, []).append(_face_triangles(points, triangles))
    return [_solid_triangles(own) for _, own in sorted(solids.items())]


def _solid_triangles(faces):
    rows, triangles = _joined(faces)
    if len(rows):
        # Faces that were moved differently know the same point in a slightly different place.
        size = np.linalg.norm(np.ptp(rows[:, :3], axis=0))
        rows[:, :3] = merged(rows[:, :3], _SAME * size)[1]
    return rows, triangles


def _face_triangles(points, triangles):
    points = points + 0.0  # no negative zero
    numbers = weld(points) if len(points) else np.empty(0, np.int64)  # along a seam points stand twice
    positions = np.empty((numbers.max(initial=-1) + 1, 3))
    positions[numbers] = points
    triangles = numbers[triangles]
    a, b, c = triangles.T
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    a, b, c = positions[triangles].transpose(1, 0, 2)
    areas = np.cross(b - a, c - a)
    normals = np.zeros_like(positions)
    for corner in triangles.T:
        np.add.at(normals, corner, areas)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    np.divide(normals, lengths, out=normals, where=lengths > 0)
    return np.column_stack([positions, normals]), triangles


def _joined(parts):
    """One (rows, triangles) of several."""
    starts = np.cumsum([0] + [len(rows) for rows, _ in parts])
    moved = [triangles + start for (_, triangles), start in zip(parts, starts)]
    return np.concatenate([rows for rows, _ in parts]), np.concatenate(moved)
