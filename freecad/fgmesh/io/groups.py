# SPDX-License-Identifier: GPL-3.0-or-later
"""Named groups of a meshing result: SolidN, FaceN, as FreeCAD numbers them."""
import numpy as np


def members(word, numbers):
    """Yield (name, indices) for each number that occurs: ("Face3", indices of the cells with number 3)."""
    numbers = np.asarray(numbers)
    for number in np.unique(numbers):
        yield f"{word}{number}", np.flatnonzero(numbers == number)


def node_groups(result):
    """Yield ("FaceN", 0-based points of its triangles, middle nodes too, sorted) for each face."""
    triangles = np.asarray(result.triangles)
    for name, chosen in members("Face", result.triangle_faces):
        yield name, np.unique(triangles[chosen])
