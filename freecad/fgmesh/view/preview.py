# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid coloured by a field in its 3D view."""
import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from freecad.fgmesh import core
from freecad.fgmesh.model.preview_shape import surface_of
from freecad.fgmesh.surfaces.surface import FINENESS
from freecad.fgmesh.view.background_cut import BackgroundCut
from freecad.fgmesh.view.colour_bar import ColourBar
from freecad.fgmesh.view.coloured_faces import ColouredFaces
from freecad.fgmesh.view.hidden import Hidden
from freecad.fgmesh.view.section_dragger import SectionDragger


class Preview:
    """`thing` coloured by a field in its 3D view until close().

    The document is not changed in any way (no undo step, no 'modified' mark): an overlay in the scene graph
    replaces the look of the solid.

    thing           a document object with solids
    view            the 3D view; None: that of the document
    on_new_points   called when `points` have changed, since the section moved
    surface         its surfaces.surface.Surface, where the caller has it already

    points (n, 3) and solids (n,), numbers from 0: where values are wanted, in the coordinates of thing.Shape. The first
    `fixed` of them are always there and never change. Raises core.InvalidInput where there is no solid or no 3D view.
    """

    def __init__(self, thing, view=None, on_new_points=None, surface=None):
        self._surface = surface or surface_of(thing)
        self._on_new_points = on_new_points or (lambda: None)
        self._section = self._dragger = self._cut = None
        self._background = BackgroundCut(self._take_cut)
        self._layers = _drawing_order(thing)
        self.fixed = len(self._surface.points)
        self.points, self.solids = self._surface.points, self._surface.solids

        self._faces, self._bar = ColouredFaces(), ColourBar(thing.Document.Name)
        self._moved = coin.SoSeparator()
        self._moved.addChild(_to_global(thing))
        self._moved.addChild(self._faces.root)
        self._root = coin.SoSeparator()
        self._root.addChild(self._moved)
        self._root.addChild(self._bar.root)
        self._faces.set_points(self._surface.points, self._surface.normals)
        self._show_faces()

        view = view_of(thing) if view is None else view
        self._scene = view.getSceneGraph()  # this reference keeps it where the view is closed meanwhile
        self._scene.addChild(self._root)
        self._hidden = Hidden(thing)

    def set_values(self, values, title, low=0.0, high=1.0):
        """values (n,), one for each of `points`; NaN has a colour of its own. Those from low to high have the colours
        of the scale, those outside are marked. title: text of the colour bar."""
        values = np.asarray(values, float)
        if values.shape != (len(self.points),):
            raise ValueError(f"{len(self.points)} points need as many values, not {values.shape}")
        if self._scene is not None:
            self._faces.set_values(values, low, high)
            self._bar.show(title, low, high, values)

    @property
    def section(self):
        """None, or the plane (origin, normal) that cuts the solid, in the coordinates of thing.Shape; what lies on the
        side to which the normal points is not shown."""
        return self._section

    @section.setter
    def section(self, plane):
        if self._scene is None:
            return
        self._section = plane and (FreeCAD.Vector(plane[0]), FreeCAD.Vector(plane[1]).normalize())
        if self._dragger and plane:
            self._dragger.place(*self._section)
        self._cut_here()

    def drag_section(self, on=True):
        """Shows handles by which the plane is shifted and turned with the mouse. Where there is no section yet, one
        through the middle of the solid is made."""
        if self._scene is None or bool(self._dragger) == bool(on):
            return
        if not on:
            self._moved.removeChild(self._dragger.root)
            self._dragger.close()
            self._dragger = None
            return
        if self._section is None:
            low, high = self._surface.points.min(axis=0), self._surface.points.max(axis=0)
            normal = FreeCAD.Vector(0, -1, 0)
            self.section = (FreeCAD.Vector(*(low + high) / 2), normal)
        self._dragger = SectionDragger(self._surface.diagonal, self._dragged)
        self._dragger.place(*self._section)
        self._moved.addChild(self._dragger.root)

    def close(self):
        """All is as before. Does nothing the second time."""
        if self._scene is None:
            return
        self.drag_section(False)
        self._background.stop()
        self._background = None  # it leads back here
        place = self._scene.findChild(self._root)
        if place >= 0:
            self._scene.removeChild(place)
        self._scene = None
        self._bar.close()
        self._hidden.show()

    def _dragged(self, origin, normal):
        self._section = (origin, normal)
        self._cut_here()

    def _cut_here(self):
        surface = self._surface
        self._hidden.is_pickable = self._section is None
        if self._section is None:
            self._background.stop()
            self._take_cut(None)
        else:
            self._background.cut(surface, *self._section, surface.diagonal / FINENESS)

    def _take_cut(self, cut):
        """cut: a section.Section; None: the whole solid."""
        surface, self._cut = self._surface, cut
        if cut is None:
            self.points, self.solids = surface.points, surface.solids
            self._faces.set_points(np.empty((0, 3)), np.empty((0, 3)), self.fixed)
        else:
            self.points = np.concatenate([surface.points, cut.points])
            self.solids = np.concatenate([surface.solids, cut.solids])
            self._faces.set_points(cut.points, cut.normals, self.fixed)
        self._show_faces()
        self._on_new_points()

    def _show_faces(self):
        if self._cut is None:
            self._faces.set_faces(self._surface.triangles, [], self._surface.edges)
            return
        caps = sorted(self._cut.caps, key=lambda cap: self._layers[cap[0]])
        self._faces.set_faces(self._cut.triangles, [triangles for _, triangles in caps], self._cut.edges)


def view_of(thing):
    """The active 3D view of the document of `thing`, or else the first that it has."""
    document = FreeCADGui.getDocument(thing.Document.Name)
    views = document.mdiViewsOfType("Gui::View3DInventor")
    active = document.activeView()
    if hasattr(active, "getSceneGraph"):
        return active
    if not views:
        raise core.InvalidInput(f"{thing.Document.Label} has no 3D view")
    return views[0]


def _to_global(thing):
    """The node that leads from the coordinates of thing.Shape, which know only its own placement, to those of the
    document."""
    placement = thing.getGlobalPlacement().multiply(thing.Placement.inverse())
    transform = coin.SoMatrixTransform()
    rows = np.array(placement.toMatrix().A).reshape(4, 4).T  # Coin multiplies from the other side
    transform.matrix.setValue(coin.SbMatrix(*rows.ravel().tolist()))
    return transform


def _drawing_order(thing):
    """For each solid when its cut faces are drawn, the later in front: where solids overlap a point belongs to the
    lowest, except that one inside another is seen, too."""
    boxes = [solid.BoundBox for solid in thing.Shape.Solids]
    depths = [sum(outer.isInside(box) for outer in boxes if outer is not box) for box in boxes]
    order = sorted(range(len(boxes)), key=lambda number: (depths[number], -number))
    return {number: layer for layer, number in enumerate(order)}
