# SPDX-License-Identifier: GPL-3.0-or-later
"""Scene nodes that draw triangles in the colours of values at their points."""
import ctypes
import functools

import numpy as np
from pivy import coin

from freecad.fgmesh import colours

# Values between low and high take the middle half of a texture, what lies outside is clamped to its ends: so a
# triangle changes its colour exactly where the value leaves the range.
_WIDTH, _FIRST, _LAST = 1024, 256, 767
_FARTHEST = 1e4

_GLOW, _SHADE = 0.78, 0.22
"""The share of a face's colour that is always there, and that which falls with the light: faces stay readable as a
shape, and no colour is taken for another of the scale."""


class ColouredFaces:
    """`root`, a scene node with faces, cut faces and edges over common points; it cannot be picked."""

    def __init__(self, edge_width=1.5):
        self._points, self._normals = coin.SoCoordinate3(), coin.SoNormal()
        self._places = coin.SoTextureCoordinate2()
        self._faces = _Faces(is_shaded=True)
        self._caps = []
        self._cap_group = coin.SoSeparator()
        self._edges = coin.SoIndexedLineSet()
        self._values = np.empty(0)
        self.root = coin.SoSeparator()
        for node in (
            unpickable(),
            _hints(),
            self._points,
            self._normals,
            _binding(coin.SoNormalBinding),
            self._places,
            _binding(coin.SoTextureCoordinateBinding),
            self._faces.root,
            self._cap_group,
            _edge_group(self._edges, edge_width),
        ):
            self.root.addChild(node)

    def set_points(self, points, normals, first=0):
        """points, normals (n, 3): take the places from `first` on, in place of all that was there; they have no
        values yet."""
        set_vectors(self._points.point, points, first)
        set_vectors(self._normals.vector, normals, first)
        known = self._values[:first]
        self._values = np.concatenate([known, np.full(first + len(points) - len(known), np.nan)])
        self._places.point.setNum(len(self._values))

    def set_faces(self, triangles, caps, edges):
        """triangles (m, 3); caps: list of such arrays, flat, each in front of those before it; edges (e, 2)."""
        self._faces.triangles = triangles
        self._cap_group.removeAllChildren()
        self._caps = [_Faces(is_shaded=False, layer=layer) for layer in range(len(caps))]
        for cap, own in zip(self._caps, caps):
            cap.triangles = own
            self._cap_group.addChild(cap.root)
        set_rows(self._edges, edges)
        self._show_faces()

    def set_values(self, values, low, high):
        """values (n,), one for each point."""
        self._values = colours.fraction_of_range(values, low, high)
        texels = _FIRST + 0.5 + np.clip(self._values, -_FARTHEST, _FARTHEST) * (_LAST - _FIRST)
        places = np.full((len(texels), 2), 0.5, np.float32)
        places[:, 0] = np.nan_to_num(texels / _WIDTH)
        set_vectors(self._places.point, places)
        self._show_faces()

    def _show_faces(self):
        unknown = np.isnan(self._values)
        for faces in (self._faces, *self._caps):
            faces.show(unknown if unknown.any() else None)


class _Faces:
    """Triangles, apart those that have a colour and those with a corner that has none."""

    def __init__(self, is_shaded, layer=0):
        self.triangles = np.empty((0, 3), np.int64)
        self.root = coin.SoSeparator()
        self._known, self._unknown = coin.SoIndexedFaceSet(), coin.SoIndexedFaceSet()
        self._shown = {}
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.PHONG if is_shaded else coin.SoLightModel.BASE_COLOR
        offset = coin.SoPolygonOffset()
        # Behind the edges; and of cut faces that lie upon each other the later is in front.
        offset.factor, offset.units = 1.0, max(6.0 - 2.0 * layer, -40.0)
        self.root.addChild(light)
        self.root.addChild(offset)
        for faces, colour, texture in (
            (self._unknown, colours.UNDEFINED, None),
            (self._known, (1, 1, 1), scale_texture()),
        ):
            group = coin.SoSeparator()
            group.addChild(_material(colour, is_shaded))
            if texture is not None:
                group.addChild(texture)
            group.addChild(faces)
            self.root.addChild(group)

    def show(self, unknown):
        """unknown (n,): which points have no value; None: none."""
        if unknown is None:
            known, rest = self.triangles, self.triangles[:0]
        else:
            without = unknown[self.triangles].any(axis=1)
            known, rest = self.triangles[~without], self.triangles[without]
        for node, rows in ((self._known, known), (self._unknown, rest)):
            if self._shown.get(id(node)) is not rows:
                set_rows(node, rows)
                self._shown[id(node)] = rows


@functools.lru_cache(maxsize=1)
def scale_texture():
    """The node with the colours of the scale along its first coordinate."""
    places = (np.arange(_WIDTH) - _FIRST) / (_LAST - _FIRST)
    pixels = np.rint(colours.rgb(places) * 255).astype(np.uint8)
    texture = coin.SoTexture2()
    texture.image.setValue(coin.SbVec2s(_WIDTH, 1), 3, pixels.tobytes())
    texture.wrapS = texture.wrapT = coin.SoTexture2.CLAMP
    texture.model = coin.SoTexture2.MODULATE
    return texture


def set_vectors(field, rows, first=0):
    """Gives `field` the vectors `rows` (n, k) from its place `first` on, and no others behind them."""
    _fill(field, np.ascontiguousarray(rows, np.float32), first)


def set_rows(node, rows):
    """Gives an indexed shape the polygons or lines `rows` (m, k)."""
    numbers = np.full((len(rows), rows.shape[1] + 1), -1, np.int32)
    numbers[:, :-1] = rows
    _fill(node.coordIndex, numbers.ravel(), 0)


def _fill(field, rows, first):
    field.setNum(first + len(rows))
    if len(rows):
        # Not setValues(): pivy loses the memory of the integers that it is given, and takes ten times as long.
        start = field.startEditing()
        address = int(getattr(start, "this", start)) + first * rows.strides[0]
        ctypes.memmove(address, rows.ctypes.data, rows.nbytes)
        field.finishEditing()


def _material(colour, is_shaded):
    material = coin.SoMaterial()
    shade, glow = (_SHADE, _GLOW) if is_shaded else (1.0, 0.0)
    material.ambientColor = (0, 0, 0)
    material.diffuseColor = tuple(shade * part for part in colour)
    material.emissiveColor = tuple(glow * part for part in colour)
    return material


def _edge_group(lines, width):
    group = coin.SoSeparator()
    light, colour, style = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb = (0.08, 0.08, 0.1)
    style.lineWidth = width
    for node in (light, colour, style, lines):
        group.addChild(node)
    return group


def unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def _hints():
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE  # both sides have a colour
    hints.faceType = coin.SoShapeHints.CONVEX
    return hints


def _binding(kind):
    binding = kind()
    binding.value = kind.PER_VERTEX_INDEXED
    return binding
