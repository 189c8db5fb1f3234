# SPDX-License-Identifier: GPL-3.0-or-later
"""The colour bar in the 3D view, a part of the scene, so that pictures have it, too."""
import weakref

import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from freecad.fgmesh import colours
from freecad.fgmesh.view.texts import number_text, translate

# Lengths are pixels of a view less than _COMMON_HEIGHT high; the picture has twice as many, for sharp letters.
_SHARPNESS = 2
_CANVAS = (512, 1024)  # of the picture; powers of two, or Coin would stretch it
_PADDING, _BAR_WIDTH, _BAR_HEIGHT, _TEXT, _GAP = 12, 20, 200, 13, 8
_WIDEST_TITLE = 150
_MARGIN = 16  # to the view's edge
_COMMON_HEIGHT, _SMALL_HEIGHT = 1000, 480
_STEPS = 5


class ColourBar:
    """`root`, a scene node that draws the bar at the left of any viewport, whatever the camera of the scene. Of the bars
    of one document only that which was shown last is seen."""

    _shown = []  # weak references, the latest last

    def __init__(self, document):
        """document: its name."""
        self._document = document
        self._ratio = FreeCADGui.getMainWindow().devicePixelRatioF()  # as large as other text on the screen
        self._camera, self._switch = coin.SoOrthographicCamera(), coin.SoSwitch()
        self._camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self._texture, self._corners = coin.SoTexture2(), coin.SoCoordinate3()
        self._texture_corners = coin.SoTextureCoordinate2()
        self._size, self._content = (1, 1), None
        self._callback = coin.SoCallback()
        # pivy never lets go of what a callback was given.
        self._callback.setCallback(_fit, weakref.ref(self))
        panel, overlay = coin.SoSeparator(), coin.SoAnnotation()
        for node in (self._texture, self._texture_corners, self._corners, coin.SoFaceSet()):
            panel.addChild(node)
        look = coin.SoResetTransform(), self._callback, self._camera, *_plain_look()
        for node in (*look, panel, *_something_opaque()):
            overlay.addChild(node)
        self._switch.addChild(overlay)
        self.root = coin.SoSeparator()
        self.root.addChild(_without_bounds(self._switch))

    def show(self, title, low, high, values):
        """Draws the scale from `low` to `high` under `title`, and a legend of the marks that `values` (n,) need."""
        places = colours.fraction_of_range(values, low, high)
        marks = [
            (colours.ABOVE, translate("above {}").format(number_text(high, ".4g")), (places > 1).any()),
            (colours.BELOW, translate("below {}").format(number_text(low, ".4g")), (places < 0).any()),
            (colours.UNDEFINED, translate("no value"), np.isnan(places).any()),
        ]
        content = title, low, high, [mark[:2] for mark in marks if mark[2]]
        if content != self._content:
            self._content = content
            self._paint(*content)
        self._take_turns(True)

    def _paint(self, *content):
        image, self._size = _painted(*content)
        pixels = bytes(image.mirrored().constBits())
        self._texture.image.setValue(coin.SbVec2s(*_CANVAS), 4, pixels)
        right, bottom = (self._size[i] * _SHARPNESS / _CANVAS[i] for i in (0, 1))
        corners = [(0, 1 - bottom), (right, 1 - bottom), (right, 1), (0, 1)]
        self._texture_corners.point.setValues(0, 4, corners)
        width, height = self._size
        self._corners.point.setValues(0, 4, [(0, 0, 0), (width, 0, 0), (width, height, 0), (0, height, 0)])

    def close(self):
        """Nothing is drawn until show() is called again."""
        self._take_turns(False)

    def _take_turns(self, is_shown):
        others = [ref for ref in ColourBar._shown if ref() not in (None, self)]
        ColourBar._shown[:] = others + [weakref.ref(self)] * is_shown
        mine = [bar for bar in (ref() for ref in ColourBar._shown) if bar._document == self._document]
        self._switch.whichChild = coin.SO_SWITCH_NONE
        for bar in mine:
            bar._switch.whichChild = coin.SO_SWITCH_ALL if bar is mine[-1] else coin.SO_SWITCH_NONE

    def fit(self, width, height):
        """Sets the camera for a viewport of so many pixels."""
        common, small = _COMMON_HEIGHT, _SMALL_HEIGHT * self._ratio
        scale = max(self._ratio, height / common) if height >= small else height / _SMALL_HEIGHT
        width, height = width / scale, height / scale
        left, bottom = -_MARGIN, -round((height - self._size[1]) / 2)
        camera = self._camera
        camera.enableNotify(False)  # a change while the scene is drawn would have it drawn again
        camera.position = (left + width / 2, bottom + height / 2, 1)
        camera.nearDistance, camera.farDistance = 0.5, 2
        camera.height, camera.aspectRatio = height, width / height
        camera.enableNotify(True)


def _fit(reference, action):
    bar = reference()
    if bar is not None and action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        size = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
        bar.fit(size[0], size[1])  # pivy of FreeCAD 1.1 gives no numbers by getValue()


def _painted(title, low, high, marks):
    """The picture, a QImage, and the size (width, height) of the panel in its upper left corner."""
    image = QtGui.QImage(*_CANVAS, QtGui.QImage.Format_RGBA8888)
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.setRenderHints(QtGui.QPainter.Antialiasing | QtGui.QPainter.TextAntialiasing)
    painter.scale(_SHARPNESS, _SHARPNESS)
    font = painter.font()
    font.setPixelSize(_TEXT)
    painter.setFont(font)
    steps = np.linspace(high, low, _STEPS + 1) if high > low else [low]
    labels = [number_text(step, ".4g") for step in steps]
    metrics = QtGui.QFontMetricsF(font, image)
    title_box = metrics.boundingRect(QtCore.QRectF(0, 0, _WIDEST_TITLE, 200), QtCore.Qt.TextWordWrap, title)
    texts = [*labels, *(text for _, text in marks)]
    widest = max(metrics.horizontalAdvance(text) for text in texts)
    width = 2 * _PADDING + max(title_box.width(), _BAR_WIDTH + _GAP + widest) + 2
    line = metrics.height() + 4
    top = _PADDING + title_box.height() + _GAP + line / 4
    below = top + _BAR_HEIGHT + line / 2 + (_GAP if marks else 0)
    height = below + line * len(marks) + _PADDING - 4
    width, height = int(width + 0.5), int(height + 0.5)

    painter.setPen(QtGui.QPen(QtGui.QColor(255, 255, 255, 70), 1))
    painter.setBrush(QtGui.QColor(24, 28, 40, 185))
    painter.drawRoundedRect(QtCore.QRectF(0.5, 0.5, width - 1, height - 1), 7, 7)
    painter.setPen(QtGui.QColor("white"))
    painter.drawText(QtCore.QRectF(_PADDING, _PADDING, width, 200), QtCore.Qt.TextWordWrap, title)
    _paint_scale(painter, top, labels)
    for number, (colour, text) in enumerate(marks):
        _paint_box(painter, QtCore.QRectF(_PADDING, below + number * line + 2, _BAR_WIDTH, line - 7), colour)
        place = QtCore.QRectF(_PADDING + _BAR_WIDTH + _GAP, below + number * line - 1, width, line)
        painter.drawText(place, QtCore.Qt.AlignVCenter, text)
    painter.end()
    return image, (width, height)


def _paint_scale(painter, top, labels):
    bar = QtCore.QRectF(_PADDING, top, _BAR_WIDTH, _BAR_HEIGHT)
    gradient = QtGui.QLinearGradient(bar.bottomLeft(), bar.topLeft())
    places = np.linspace(0, 1, 65)
    for place, colour in zip(places.tolist(), colours.rgb(places).tolist()):
        gradient.setColorAt(place, QtGui.QColor.fromRgbF(*colour))
    if len(labels) == 1:  # one value alone: its colour alone
        gradient = QtGui.QColor.fromRgbF(*colours.rgb([0.5])[0].tolist())
    painter.fillRect(bar, gradient)
    pen = painter.pen()
    for number, text in enumerate(labels):
        share = number / (len(labels) - 1) if len(labels) > 1 else 0.5
        middle = bar.top() + share * bar.height()
        painter.drawText(
            QtCore.QRectF(bar.right() + _GAP, middle - 10, 200, 20), QtCore.Qt.AlignVCenter, text
        )
        painter.setPen(QtGui.QPen(QtGui.QColor(255, 255, 255, 180), 1))
        painter.drawLine(QtCore.QPointF(bar.right(), middle), QtCore.QPointF(bar.right() + 4, middle))
        painter.setPen(pen)


def _paint_box(painter, box, colour):
    painter.fillRect(box, QtGui.QColor.fromRgbF(*colour))


def _plain_look():
    """Nodes for a picture that looks as it was painted, in front of all."""
    light, depth, colour, style = (
        coin.SoLightModel(),
        coin.SoDepthBuffer(),
        coin.SoMaterial(),
        coin.SoPickStyle(),
    )
    light.model = coin.SoLightModel.BASE_COLOR
    depth.test = depth.write = False
    colour.diffuseColor = (1, 1, 1)
    style.style = coin.SoPickStyle.UNPICKABLE
    draw, hints, complexity = coin.SoDrawStyle(), coin.SoShapeHints(), coin.SoComplexity()
    draw.style = coin.SoDrawStyle.FILLED
    hints.faceType = coin.SoShapeHints.CONVEX
    complexity.textureQuality = 0.5  # mipmaps would blur letters
    return light, depth, colour, style, draw, hints, complexity


def _something_opaque():
    """Nodes that draw nothing, and have Coin switch blending off. Annotations end a frame, and FreeCAD switches it off
    behind Coin's back after that: in the next frame Coin would take it for on, and all that is transparent would be
    opaque."""
    places = coin.SoCoordinate3()
    places.point.setValues(0, 3, [(0, 0, 0)] * 3)
    return places, coin.SoFaceSet()


def _without_bounds(content):
    """A group with `content` that does not count when the view is fitted to what it shows."""
    kind = coin.SoType.fromName(coin.SbName("SoSkipBoundingGroup"))  # FreeCAD's own
    group = coin.SoSeparator() if kind.isBad() else kind.createInstance()
    group.addChild(content)
    return group
