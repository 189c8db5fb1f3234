# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces of a tetrahedral mesh that are seen when some of its tetrahedra are shown. NumPy alone."""
import numpy as np

# Corners of the faces of a tetrahedron in VTK's order, outward; then the nodes in the middle of their edges, of ten.
_FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
_MIDDLES = np.array([[6, 5, 4], [4, 8, 7], [5, 9, 8], [6, 7, 9]])


class TetFaces:
    """points (n, 3); tets (m, 4 or 10), in VTK's order."""

    def __init__(self, points, tets):
        self.points, self.tets = points, tets
        faces = tets[:, _FACES].reshape(-1, 3)
        if tets.shape[1] == 10:
            faces = np.column_stack([faces, tets[:, _MIDDLES].reshape(-1, 3)])
        size = len(points)
        keys = np.sort(faces[:, :3], axis=1).astype(np.int64) @ [size * size, size, 1]
        order = np.argsort(keys, kind="stable")
        twice = np.flatnonzero(keys[order][1:] == keys[order][:-1])
        self._faces = faces
        self._neighbours = np.full(len(faces), -1)
        self._neighbours[order[twice]] = order[twice + 1] // 4
        self._neighbours[order[twice + 1]] = order[twice] // 4

    @property
    def centres(self):
        """(m, 3): of the tetrahedra."""
        return self.points[self.tets[:, :4]].mean(axis=1)

    def seen(self, shown=None):
        """Triangles (t, 3) and edges (e, 2) around the tetrahedra `shown` (m,); None: all. A face of a tetrahedron of
        ten nodes is four triangles."""
        if shown is None:
            chosen = self._neighbours < 0
        else:
            beyond = np.append(shown, False)[self._neighbours]  # -1 finds the last: nobody
            chosen = np.repeat(shown, 4) & ~beyond
        faces = self._faces[chosen]
        edges = _once(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), len(self.points))
        if faces.shape[1] == 3:
            return faces, edges
        parts = faces[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]].reshape(-1, 3)
        halves = faces[:, [[0, 3], [3, 1], [1, 4], [4, 2], [2, 5], [5, 0]]].reshape(-1, 2)
        return parts, _once(halves, len(self.points))


def _once(edges, size):
    keys = np.unique(np.sort(edges, axis=1).astype(np.int64) @ [size, 1])
    return np.column_stack([keys // size, keys % size])
