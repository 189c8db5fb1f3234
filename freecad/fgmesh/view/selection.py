# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user has selected, in the tree or in the 3D view, as this workbench understands it."""
import FreeCADGui

from freecad.fgmesh import core
from freecad.fgmesh.model.mesh_object import is_mesh
from freecad.fgmesh.view.texts import translate


def selected_solids():
    """The selected objects with solids, each once. A feature inside a body stands for the body."""
    found = {}  # a dictionary is a set in order
    for thing in FreeCADGui.Selection.getSelection():
        owner = solid_owner(thing)
        if owner is not None:
            found[owner] = None
    return list(found)


def selected_solid():
    """The one selected solid, with a graded material or without; else None."""
    solids = selected_solids()
    return solids[0] if len(solids) == 1 else None


def selected_mesh():
    """The one selected object, where it is a mesh of ours; else None."""
    chosen = FreeCADGui.Selection.getSelection()
    return chosen[0] if len(chosen) == 1 and is_mesh(chosen[0]) else None


def meshed(mesh):
    """`mesh` itself. Raises core.InvalidInput, for the user, where it has not been meshed yet."""
    if not mesh.Report:
        raise core.InvalidInput(translate("{} is not meshed yet: mesh it first").format(mesh.Label))
    return mesh


def solid_owner(thing):
    """The object to which a material of `thing` belongs: its body, else itself; None where it has no solid."""
    body = thing.getParentGeoFeatureGroup() if hasattr(thing, "getParentGeoFeatureGroup") else None
    if body is not None and body.isDerivedFrom("PartDesign::Body"):
        thing = body
    shape = getattr(thing, "Shape", None)
    return thing if getattr(shape, "Solids", None) else None


class Picker:
    """Waits for the user to click on something in the 3D view or the tree, once."""

    def __init__(self, picked):
        """picked(object, name): called with what was clicked on, name "" for an object as a whole."""
        self._picked = picked
        self.waiting = False

    def start(self):
        FreeCADGui.Selection.clearSelection()
        if not self.waiting:
            FreeCADGui.Selection.addObserver(self)
        self.waiting = True

    def stop(self):
        if self.waiting:
            FreeCADGui.Selection.removeObserver(self)
        self.waiting = False

    def addSelection(self, document, thing, name, position):
        """FreeCAD calls this."""
        for chosen in FreeCADGui.Selection.getSelectionEx(document):
            self.stop()
            names = [part for part in chosen.SubElementNames if part]
            self._picked(chosen.Object, names[-1] if names else "")
            return
