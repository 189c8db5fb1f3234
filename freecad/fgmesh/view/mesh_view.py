# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh object in the tree and in the 3D view: FreeCAD's own Fem mesh display under an icon of ours, which tells
whether the mesh is up to date; and whether it is coloured by its composition, which the document keeps."""
from PySide import QtCore, QtGui

from freecad.fgmesh.model.stateless import Stateless
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.double_click import run_on
from freecad.fgmesh.view.texts import translate

_COLOURED = "ColourByFraction"
_LOOK_PROPERTIES = (
    (_COLOURED, "App::PropertyBool", "Colour the mesh by the volume fraction of a constituent"),
    ("ShownConstituent", "App::PropertyInteger", "Which constituent the colours tell of: 0 is the first"),
)


class MeshView(Stateless):
    """The proxy of the view provider. look: a mesh_look.MeshLook while the mesh has another look than FreeCAD's."""

    look = None

    def __init__(self, view):
        view.Proxy = self
        _add_missing_properties(view)

    def getIcon(self):
        return icon("mesh" if self._up_to_date() else "mesh-outdated")

    def attach(self, view):
        self._mesh = view.Object

    def updateData(self, mesh, name):
        if name == "Status":
            mesh.ViewObject.signalChangeIcon()
        elif name == "Fingerprint":  # set by a run, by undo and by redo
            if getattr(self, "look", None) is not None:
                self.look.close()  # it shows the mesh of before
                self.look = None
            show_kept_look(mesh)

    def onChanged(self, view, name):
        if name in (row[0] for row in _LOOK_PROPERTIES) and getattr(view, "Object", None) is not None:
            show_kept_look(view.Object, anew=True)

    def doubleClicked(self, view):
        return run_on(view.Object, "FGMesh_Mesh")

    def setupContextMenu(self, view, menu):
        action = QtGui.QAction(translate("Mesh again ..."), menu)
        action.triggered.connect(lambda: run_on(view.Object, "FGMesh_Mesh"))
        menu.addAction(action)
        colours = QtGui.QAction(translate("Colours of the composition"), menu)
        colours.setCheckable(True)
        colours.setChecked(bool(getattr(view, _COLOURED, False)))
        colours.setEnabled(bool(view.Object.Fingerprint))
        colours.toggled.connect(lambda on: keep_coloured(view.Object, on))
        menu.addAction(colours)

    def _up_to_date(self):
        # attach() has not been called where a document is being opened, nor on objects of old documents.
        mesh = getattr(self, "_mesh", None)
        return not getattr(mesh, "Status", "").startswith("out of date")


def show(mesh):
    """Gives `mesh` this view provider where it has none: made headless, or without this workbench."""
    view = mesh.ViewObject
    if view is None:
        return
    if not isinstance(view.Proxy, MeshView):
        MeshView(view)
        view.Visibility = True  # FreeCAD hides all that a headless program has saved
    _add_missing_properties(view)
    show_kept_look(mesh)


def keep_coloured(mesh, on=True):
    """Has `mesh` coloured by its composition from now on, in the document that is saved, too."""
    _add_missing_properties(mesh.ViewObject)
    setattr(mesh.ViewObject, _COLOURED, bool(on))


def is_kept_coloured(mesh):
    """Whether the document says that `mesh` is coloured."""
    return bool(getattr(mesh.ViewObject, _COLOURED, False))


def show_kept_look(mesh, anew=False):
    """Shows, as soon as FreeCAD is done with what it is at, the colours that the document keeps for `mesh`. anew: takes
    another look away, too."""
    document, name = mesh.Document.Name, mesh.Name
    QtCore.QTimer.singleShot(0, lambda: _show_kept_look(document, name, anew))


def _show_kept_look(document, name, anew):
    import FreeCAD

    from freecad.fgmesh.view import mesh_look  # only here, so that FreeCAD starts quickly

    document = FreeCAD.listDocuments().get(document)
    mesh = document and document.getObject(name)
    if mesh is None or mesh.ViewObject is None or not isinstance(mesh.ViewObject.Proxy, MeshView):
        return
    if anew or (is_kept_coloured(mesh) and getattr(mesh.ViewObject.Proxy, "look", None) is None):
        mesh_look.show_kept(mesh)


def _add_missing_properties(view):
    for name, kind, tip in _LOOK_PROPERTIES:
        if name not in view.PropertiesList:
            view.addProperty(kind, name, "FGMesh", tip)
