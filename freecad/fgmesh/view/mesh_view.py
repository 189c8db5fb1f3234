# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh object in the tree and in the 3D view: FreeCAD's own Fem mesh display under an icon of ours."""
from freecad.fgmesh.model.stateless import Stateless
from freecad.fgmesh.view import ICON


class MeshView(Stateless):
    """The proxy of the view provider."""

    def __init__(self, view):
        view.Proxy = self

    def getIcon(self):
        return ICON

    def attach(self, view):
        pass


def show(mesh):
    """Gives `mesh` this view provider where it has none: made headless, or without this workbench."""
    view = mesh.ViewObject
    if view is not None and not isinstance(view.Proxy, MeshView):
        MeshView(view)
        view.Visibility = True  # FreeCAD hides all that a headless program has saved
