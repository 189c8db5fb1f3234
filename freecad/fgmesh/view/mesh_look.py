# SPDX-License-Identifier: GPL-3.0-or-later
"""How a mesh object is coloured in the 3D view, in the colours of previews and without an analysis.

An overlay inside the nodes of the view provider replaces FreeCAD's own look of the mesh: it is seen where and when the
mesh is. The document keeps whether there is one, in properties of the view provider (mesh_view), and what it is made of.
"""
import numpy as np
from pivy import coin

from freecad.fgmesh import colours
from freecad.fgmesh.fem.fem_mesh import kept_points_and_tets
from freecad.fgmesh.model.mesh_object import fractions_of
from freecad.fgmesh.model.tet_faces import TetFaces
from freecad.fgmesh.model.shown_quantities import fraction_titles
from freecad.fgmesh.model.texts import TRANSLATE_LATER
from freecad.fgmesh.view.colour_bar import ColourBar
from freecad.fgmesh.view.coloured_faces import ColouredFaces, set_rows, set_vectors, unpickable
from freecad.fgmesh.view.hidden import Hidden
from freecad.fgmesh.view.mesh_view import MeshView, is_kept_coloured
from freecad.fgmesh.view.mesh_view import show as show_in_view
from freecad.fgmesh.view.texts import translate

TITLE = TRANSLATE_LATER("FGMesh", "volume fraction")


def colour_by_fraction(mesh, title=TITLE, constituent=0):
    """Colours the mesh by the fraction of a constituent, told by its index, at its nodes."""
    cut(mesh, None, title, constituent)


def cut(mesh, plane, title=TITLE, constituent=0):
    """Shows the whole tetrahedra behind `plane`, coloured likewise: (origin, normal) in the coordinates of the
    mesh, which are those of its solid's shape; those whose centre lies on the side to which the normal points
    are not shown. None: shows all."""
    look = _look_of(mesh)
    shown = None
    if plane is not None:
        origin, normal = (np.array(tuple(vector)) for vector in plane)
        shown = (look.faces.centres - origin) @ normal <= 0
    look.show_fraction(constituent, shown, title)


def show_worst(mesh, numbers):
    """Shows the tetrahedra `numbers` (indices, as in core.MeshingResult) in a strong colour, each with a dot so that the
    smallest is found, and the others faintly."""
    _look_of(mesh).show_worst(np.asarray(numbers, int).reshape(-1))


def show_plain(mesh):
    """Gives back FreeCAD's own look of the mesh."""
    holder = _holder(mesh)
    if getattr(holder, "look", None) is not None:
        holder.look.close()
        holder.look = None


def show_kept(mesh):
    """Gives the mesh the look that its document keeps: colours, or FreeCAD's own."""
    # Of a mesh that undo cannot bring back there is but the figures.
    is_whole = bool(mesh.Fingerprint) and mesh.FemMesh.VolumeCount == mesh.TetCount
    if not (is_whole and is_kept_coloured(mesh)):
        show_plain(mesh)
        return
    titles = fraction_titles(mesh.Shape, 1 + fractions_of(mesh).shape[1], translate)
    constituent = min(max(mesh.ViewObject.ShownConstituent, 0), len(titles) - 1)
    colour_by_fraction(mesh, titles[constituent], constituent)


def _look_of(mesh):
    """The look of `mesh`, made anew where the mesh is another than before."""
    holder = _holder(mesh)
    look = holder.look
    if look is None or look.fingerprint != mesh.Fingerprint:
        show_plain(mesh)
        look = holder.look = MeshLook(mesh)
    return look


def _holder(mesh):
    if not isinstance(mesh.ViewObject.Proxy, MeshView):
        show_in_view(mesh)
    return mesh.ViewObject.Proxy  # it lives as long as the nodes that the look is in


class MeshLook:
    """The overlay of one mesh."""

    def __init__(self, mesh):
        self.fingerprint = mesh.Fingerprint
        self.faces = TetFaces(*kept_points_and_tets(mesh))
        fractions = fractions_of(mesh)
        self._fractions = np.column_stack([fractions, 1 - fractions.sum(axis=1)])
        self._values = self._fractions[:, 0]
        self._coloured, self._bar, self._marks = (
            ColouredFaces(edge_width=1.0),
            ColourBar(mesh.Document.Name),
            coin.SoSeparator(),
        )
        self._hidden = Hidden(mesh)
        content = coin.SoSeparator()
        for node in (
            self._coloured.root,
            self._marks,
            self._bar.root,
        ):
            content.addChild(node)
        self._root = mesh.ViewObject.RootNode
        self._switch = _like_the_mesh(self._root, content)
        # In front of the style that hides the mesh.
        self._root.insertChild(self._switch, 0)

    def show_fraction(self, constituent, shown, title):
        """constituent: index; shown (m,): which tetrahedra, None: all."""
        self._values = self._fractions[:, constituent]
        self._marks.removeAllChildren()
        self._show(*self.faces.seen(shown))
        self._bar.show(translate(title), 0.0, 1.0, self._values)

    def show_worst(self, numbers):
        """numbers (w,): which tetrahedra stand out."""
        self._marks.removeAllChildren()
        self._bar.close()
        is_worst = np.zeros(len(self.faces.tets), bool)
        is_worst[numbers] = True
        nothing = np.empty((0, 3), int)
        self._show(nothing, nothing[:, :2])
        for node in (
            *_faint(self.faces.points, *self.faces.seen()),
            *_strong(self.faces.points, *self.faces.seen(is_worst)),
            *_dots(self.faces.centres[numbers]),
        ):
            self._marks.addChild(node)

    def close(self):
        """All is as before."""
        self._bar.close()
        self._hidden.show()
        place = self._root.findChild(self._switch)
        if place >= 0:
            self._root.removeChild(place)

    def _show(self, triangles, edges):
        """Flat triangles, each with corners of its own, and edges."""
        rim, corners = self.faces.points, self.faces.points[triangles]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
        used, numbers = np.unique(edges, return_inverse=True)
        points = np.concatenate([corners.reshape(-1, 3), rim[used]])
        normals = np.concatenate([np.repeat(normals, 3, axis=0), np.zeros((len(used), 3))])
        self._coloured.set_points(points, normals)
        first = 3 * len(triangles)
        self._coloured.set_faces(np.arange(first).reshape(-1, 3), [], numbers.reshape(-1, 2) + first)
        values = self._values[np.concatenate([triangles.ravel(), used])]
        self._coloured.set_values(values, 0.0, 1.0)


def _like_the_mesh(root, content):
    """A node with `content` that is seen whenever the view provider with `root` shows the mesh in any of its modes, and
    placed like it."""
    children = [root.getChild(number) for number in range(root.getNumChildren())]
    modes = next(child for child in children if child.isOfType(coin.SoSwitch.getClassTypeId()))
    place = next(child for child in children if child.isOfType(coin.SoTransform.getClassTypeId()))
    content.insertChild(place, 0)
    switch = coin.SoSwitch()
    for _ in range(modes.getNumChildren()):
        mode = coin.SoGroup()  # the same child again and again would have the switch miss its changes
        mode.addChild(content)
        switch.addChild(mode)
    switch.whichChild.connectFrom(modes.whichChild)
    return switch


def _strong(points, triangles, edges):
    depth = coin.SoDepthBuffer()
    depth.write = True
    yield depth
    yield _drawn(points, coin.SoIndexedFaceSet(), triangles, colours.ABOVE)
    yield _drawn(points, coin.SoIndexedLineSet(), edges, (0.25, 0, 0), width=1.5)


def _faint(points, triangles, edges):
    # At once and without depth, so that what comes later stands in front of it in its full colour.
    kind, depth = coin.SoTransparencyType(), coin.SoDepthBuffer()
    kind.value = coin.SoTransparencyType.BLEND
    depth.write = False
    yield kind
    yield depth
    yield _drawn(points, coin.SoIndexedLineSet(), edges, (0.7, 0.7, 0.75), transparency=0.7)
    yield _drawn(points, coin.SoIndexedFaceSet(), triangles, (0.7, 0.7, 0.75), transparency=0.85)


def _dots(centres):
    group, depth, style, dots = (
        coin.SoSeparator(),
        coin.SoDepthBuffer(),
        coin.SoDrawStyle(),
        coin.SoPointSet(),
    )
    depth.test = False
    style.pointSize = 5
    light, colour, places = coin.SoLightModel(), coin.SoBaseColor(), coin.SoCoordinate3()
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb = colours.ABOVE
    set_vectors(places.point, centres)
    for node in (unpickable(), depth, style, light, colour, places, dots):
        group.addChild(node)
    yield group


def _drawn(points, shape, rows, colour, transparency=0.0, width=1.0):
    """A node with the polygons or lines `rows` in one colour."""
    group, light, look = coin.SoSeparator(), coin.SoLightModel(), coin.SoMaterial()
    light.model = coin.SoLightModel.BASE_COLOR
    look.diffuseColor, look.transparency = colour, transparency
    style, offset, places = coin.SoDrawStyle(), coin.SoPolygonOffset(), coin.SoCoordinate3()
    style.lineWidth = width
    used, numbers = np.unique(rows, return_inverse=True)
    set_vectors(places.point, points[used])
    set_rows(shape, numbers.reshape(rows.shape))
    for node in (unpickable(), light, look, style, offset, places, shape):
        group.addChild(node)
    return group
