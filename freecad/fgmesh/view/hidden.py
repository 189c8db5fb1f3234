# SPDX-License-Identifier: GPL-3.0-or-later
"""An object's own look in the 3D view taken away for a while, without a change of the document."""
from pivy import coin


class Hidden:
    """Nothing of `thing` is drawn until show(); it can be selected still, unless `is_pickable` is set to False.

    A style that overrules all others is put in front of what the view provider draws: FreeCAD, which sets
    visibility and display mode of its own, never notices.
    """

    def __init__(self, thing):
        # These references keep the nodes where the object is deleted meanwhile.
        self._roots = [part.ViewObject.RootNode for part in _drawn(thing)]
        self._style, self._pick = coin.SoDrawStyle(), coin.SoPickStyle()
        self._style.style = coin.SoDrawStyle.INVISIBLE
        self._style.setOverride(True)
        self._group = coin.SoGroup()
        self._group.addChild(self._style)
        self._group.addChild(self._pick)
        for root in self._roots:
            root.insertChild(self._group, 0)
        self.is_pickable = True

    @property
    def is_pickable(self):
        return not self._pick.isOverride()

    @is_pickable.setter
    def is_pickable(self, value):
        self._pick.style = coin.SoPickStyle.SHAPE if value else coin.SoPickStyle.UNPICKABLE
        self._pick.setOverride(not value)

    def show(self):
        """Gives the look back; again and again, if you like."""
        for root in self._roots:
            place = root.findChild(self._group)
            if place >= 0:
                root.removeChild(place)
        self._roots = []


def _drawn(thing):
    """The objects whose view providers draw the shape of `thing`: a body shows one of its features in its place."""
    features = getattr(thing, "Group", []) if thing.isDerivedFrom("PartDesign::Body") else []
    through = getattr(thing.ViewObject, "DisplayModeBody", "") == "Through"
    if not features or not through:
        return [thing]
    return [part for part in features if part.isDerivedFrom("Part::Feature") and part.Shape.Solids]
