# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of a document as the core takes them."""


def brep_text(shape):
    """BREP text of `shape` without the triangles that looking at it may have left there: they would give
    another mesh for the same solid. FaceN keep their numbers."""
    return shape.cleaned().exportBrepToString().encode()
