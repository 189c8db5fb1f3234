# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of an object's solids as small triangles, to be coloured by a field. No Qt, no Coin."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.model.subdivision import merged, subdivide, weld

FINENESS = 50
"""Edges of the triangles are at most the diagonal of the shape divided by this."""

MOST_TRIANGLES = 200_000

# Of the diagonal, and between neighbouring chords, radians: a little finer than FreeCAD's own display.
_DEFLECTION, _ANGLE = 1 / 500, 0.3
_COARSER = 3
_SAME = 1e-8  # of the diagonal


@dataclass
class Surface:
    """Closed surfaces of solids, in the coordinates of thing.Shape.

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


def surface_of(thing, fineness=FINENESS, most=MOST_TRIANGLES):
    """The Surface of all solids of thing.Shape. Where a shape has so many details that there would be more than `most`
    triangles it is coarser. Raises core.InvalidInput where there is no solid."""
    # FreeCAD keeps triangles in the shape that it was asked for: the document's own shall not have others.
    shape = thing.Shape.cleaned()
    if shape.isNull() or not shape.Solids:
        raise core.InvalidInput(f"{thing.Label} has no solid")
    diagonal = shape.BoundBox.DiagonalLength
    parts = _parts(shape, _DEFLECTION * diagonal, _ANGLE)
    if sum(len(triangles) for _, triangles in parts) > most:
        parts = _parts(thing.Shape.cleaned(), _COARSER * _DEFLECTION * diagonal, _COARSER * _ANGLE)
    rows, triangles = _joined(
        [(np.column_stack([own, np.full(len(own), number)]), t) for number, (own, t) in enumerate(parts)]
    )
    rows, triangles = subdivide(rows, triangles, diagonal / fineness, most)
    lengths = np.linalg.norm(rows[:, 3:6], axis=1, keepdims=True)
    normals = np.divide(rows[:, 3:6], lengths, out=np.zeros((len(rows), 3)), where=lengths > 0)
    points = np.ascontiguousarray(rows[:, :3])
    return Surface(points, normals, rows[:, 6].astype(np.int32), triangles, diagonal)


def _parts(shape, deflection, angle):
    """For each solid rows (n, 6) of positions and normals, and triangles (m, 3), face by face."""
    import MeshPart  # as FreeCAD itself does, late: it brings the module Mesh

    # Leaves triangles in the faces. tessellate(), too, but with an angle that makes ten times as many.
    MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=angle, Relative=False)
    return [_solid_triangles(solid, deflection) for solid in shape.Solids]


def _solid_triangles(solid, deflection):
    solid.tessellate(
        deflection
    )  # where there still are none: of all faces at once, which share their edges then
    rows, triangles = _joined([_face_triangles(face, deflection) for face in solid.Faces])
    # Faces that were moved differently know the same point in a slightly different place.
    rows[:, :3] = merged(rows[:, :3], _SAME * solid.BoundBox.DiagonalLength)[1]
    return rows, triangles


def _face_triangles(face, deflection):
    points, triangles = face.tessellate(deflection)
    points = np.array([tuple(point) for point in points], float).reshape(-1, 3) + 0.0  # no negative zero
    triangles = np.array(triangles, np.int64).reshape(-1, 3)
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
