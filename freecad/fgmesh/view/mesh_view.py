# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh object in the tree and in the 3D view: FreeCAD's own Fem mesh display under an icon of ours, which tells
whether the mesh is up to date."""
from PySide import QtGui

from freecad.fgmesh.model.stateless import Stateless
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.double_click import run_on
from freecad.fgmesh.view.texts import translate


class MeshView(Stateless):
    """The proxy of the view provider. look: a mesh_look.MeshLook while the mesh has another look than FreeCAD's."""

    look = None

    def __init__(self, view):
        view.Proxy = self

    def getIcon(self):
        return icon("mesh" if self._up_to_date() else "mesh-outdated")

    def attach(self, view):
        self._mesh = view.Object

    def updateData(self, mesh, name):
        if name == "Status":
            mesh.ViewObject.signalChangeIcon()
        elif name == "Fingerprint" and getattr(self, "look", None) is not None:
            self.look.close()  # it shows the mesh of before
            self.look = None

    def doubleClicked(self, view):
        return run_on(view.Object, "FGMesh_Mesh")

    def setupContextMenu(self, view, menu):
        action = QtGui.QAction(translate("Mesh again ..."), menu)
        action.triggered.connect(lambda: run_on(view.Object, "FGMesh_Mesh"))
        menu.addAction(action)

    def _up_to_date(self):
        # attach() has not been called where a document is being opened, nor on objects of old documents.
        mesh = getattr(self, "_mesh", None)
        return not getattr(mesh, "Status", "").startswith("out of date")


def show(mesh):
    """Gives `mesh` this view provider where it has none: made headless, or without this workbench."""
    view = mesh.ViewObject
    if view is not None and not isinstance(view.Proxy, MeshView):
        MeshView(view)
        view.Visibility = True  # FreeCAD hides all that a headless program has saved
