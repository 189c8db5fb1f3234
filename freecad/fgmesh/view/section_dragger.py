# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles in the 3D view by which a plane is shifted and turned with the mouse."""
import weakref

import FreeCAD
from pivy import coin
from PySide import QtCore

_SIZE = 0.22  # of the part's diagonal
_COLOUR, _ACTIVE = (0.95, 0.55, 0.10), (1.0, 0.85, 0.30)


class SectionDragger:
    """`root`, a scene node: an arrow along the plane's normal shifts it, the ball at its tip turns it.

    size       the part's diagonal
    on_moved   called with origin and normal (FreeCAD.Vector) when the mouse has moved the plane
    """

    def __init__(self, size, on_moved):
        self._on_moved = on_moved
        self._place, self._scale = coin.SoTransform(), coin.SoScale()
        self._scale.scaleFactor = (_SIZE * size,) * 3
        self._shift, self._turn = coin.SoTranslate1Dragger(), coin.SoRotateSphericalDragger()
        for part, colour in (("translator", _COLOUR), ("translatorActive", _ACTIVE)):
            self._shift.setPart(part, _arrow(colour))
        self._shift.setPart("feedback", coin.SoSeparator())
        self._shift.setPart("feedbackActive", coin.SoSeparator())
        for part, colour in (("rotator", _COLOUR), ("rotatorActive", _ACTIVE)):
            self._turn.setPart(part, _ball(colour))
        self._turn.setPart("feedback", coin.SoSeparator())
        self._turn.setPart("feedbackActive", coin.SoSeparator())
        self.root = coin.SoSeparator()
        for node in (self._place, self._scale, self._shift, self._turn):
            self.root.addChild(node)
        me = weakref.ref(self)  # pivy never lets go of what a callback was given
        for dragger in (self._shift, self._turn):
            dragger.addMotionCallback(_moved, me)
        self._waits = False
        self._placing = False

    def place(self, origin, normal):
        """Puts the handles onto a plane."""
        self._origin, self._normal = FreeCAD.Vector(origin), FreeCAD.Vector(normal)
        self._placing = True
        self._place.translation = tuple(origin)
        self._place.rotation = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), normal).Q
        self._shift.translation = (0, 0, 0)
        self._turn.rotation = (0, 0, 0, 1)
        self._placing = False

    def close(self):
        """The handles do nothing from now on."""
        self._on_moved = None

    def moved(self):
        # Not at once: the mouse moves more often than a part can be cut.
        if not self._waits and not self._placing and self._on_moved is not None:
            self._waits = True
            QtCore.QTimer.singleShot(0, self._tell)

    def _tell(self):
        self._waits = False
        if self._on_moved is not None:
            self._on_moved(*self._plane())

    def _plane(self):
        """Origin and normal where the handles are now."""
        shift = self._shift.translation.getValue()[0] * self._scale.scaleFactor.getValue()[0]
        start = FreeCAD.Rotation(*self._place.rotation.getValue().getValue())
        turn = FreeCAD.Rotation(*self._turn.rotation.getValue().getValue())
        normal = start.multVec(turn.multVec(FreeCAD.Vector(1, 0, 0)))
        return self._origin + start.multVec(FreeCAD.Vector(1, 0, 0)) * shift, normal


def _moved(me, dragger):
    handles = me()
    if handles is not None:
        handles.moved()


def _arrow(colour):
    """Along x: a shaft from the plane, a head."""
    group = _coloured(colour)
    turn, shaft_place, head_place = coin.SoRotationXYZ(), coin.SoTranslation(), coin.SoTranslation()
    turn.axis, turn.angle = coin.SoRotationXYZ.Z, -1.5707963
    shaft, head = coin.SoCylinder(), coin.SoCone()
    shaft.radius, shaft.height = 0.035, 0.8
    head.bottomRadius, head.height = 0.11, 0.3
    shaft_place.translation, head_place.translation = (0, 0.4, 0), (0, 0.55, 0)
    for node in (turn, shaft_place, shaft, head_place, head):
        group.addChild(node)
    return group


def _ball(colour):
    group = _coloured(colour)
    place, ball = coin.SoTranslation(), coin.SoSphere()
    place.translation = (1.25, 0, 0)
    ball.radius = 0.1
    group.addChild(place)
    group.addChild(ball)
    return group


def _coloured(colour):
    group, material = coin.SoSeparator(), coin.SoMaterial()
    material.diffuseColor = colour
    material.emissiveColor = tuple(0.3 * part for part in colour)
    group.addChild(material)
    return group
