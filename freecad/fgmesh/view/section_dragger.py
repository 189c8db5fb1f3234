# SPDX-License-Identifier: GPL-3.0-or-later
"""Handles in the 3D view by which a plane is shifted and turned with the mouse."""
import FreeCAD
from pivy import coin
from PySide import QtCore

_SIZE = 0.22  # of the part's diagonal
_INTERVAL = 30  # milliseconds
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
        for dragger, part, shape in ((self._shift, "translator", _arrow), (self._turn, "rotator", _ball)):
            dragger.setPart(part, shape(_COLOUR))
            dragger.setPart(part + "Active", shape(_ACTIVE))
            dragger.setPart("feedback", coin.SoSeparator())
            dragger.setPart("feedbackActive", coin.SoSeparator())
        self.root = coin.SoSeparator()
        # Each goes along with the other.
        arrow, turned, shifted = coin.SoSeparator(), coin.SoRotation(), coin.SoTranslation()
        turned.rotation.connectFrom(self._turn.rotation)
        shifted.translation.connectFrom(self._shift.translation)
        arrow.addChild(turned)
        arrow.addChild(self._shift)
        for node in (self._place, self._scale, arrow, shifted, self._turn):
            self.root.addChild(node)
        # Draggers have callbacks, too, but pivy calls them without Python's lock, which ends the program.
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)

    def place(self, origin, normal):
        """Puts the handles onto a plane."""
        self._origin, self._normal = FreeCAD.Vector(origin), FreeCAD.Vector(normal)
        self._place.translation = tuple(origin)
        self._place.rotation = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), normal).Q
        self._shift.translation = (0, 0, 0)
        self._turn.rotation = (0, 0, 0, 1)
        self._start = self._known = self._state()
        self._timer.start(_INTERVAL)

    def close(self):
        """The handles do nothing from now on."""
        self._timer.stop()

    def _look(self):
        state = self._state()
        if state != self._known:
            self._known = state
            self._on_moved(*self._plane())
        elif state != self._start and not (self._shift.isActive.getValue() or self._turn.isActive.getValue()):
            self.place(*self._plane())  # the mouse has let go: the next turn is about the new place

    def _state(self):
        return self._shift.translation.getValue().getValue(), self._turn.rotation.getValue().getValue()

    def _plane(self):
        """Origin and normal where the handles are now."""
        shift = self._shift.translation.getValue()[0] * self._scale.scaleFactor.getValue()[0]
        start = FreeCAD.Rotation(*self._place.rotation.getValue().getValue())
        turn = FreeCAD.Rotation(*self._turn.rotation.getValue().getValue())
        normal = start.multVec(turn.multVec(FreeCAD.Vector(1, 0, 0)))
        return self._origin + start.multVec(FreeCAD.Vector(1, 0, 0)) * shift, normal


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
