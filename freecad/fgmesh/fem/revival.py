# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of ours that come with a document which a FreeCAD without FGMesh has saved.

It keeps their properties and loses their proxies, so that nothing tells whether they still belong to their solids, which
may have changed meanwhile. They get proxies again, and a new `Status`, as soon as their document is there.
"""
import FreeCAD


class _Observer:
    def slotActivateDocument(self, document):
        # FreeCAD tells of a document that was opened in no other way, once all of it is there.
        if not document.Restoring:
            revive_all(document)


def watch():
    """From now on each document is looked at when it is opened."""
    FreeCAD.addDocumentObserver(_observer)


def revive_all(document):
    """Give proxies to the objects of ours in `document` that have lost theirs, and tell whether they are out of date."""
    meshes = [thing for thing in document.Objects if _has_lost_proxy(thing, "Fingerprint")]
    materials = [thing for thing in document.Objects if _has_lost_proxy(thing, "PropertyError")]
    if not meshes and not materials:
        return
    # Only here: FreeCAD starts more quickly without them.
    from freecad.fgmesh.fem import graded_material
    from freecad.fgmesh.model import mesh_object

    for mesh in meshes:
        mesh_object.revive(mesh)
        mesh_object.update_status(mesh)
    for graded in materials:
        graded_material.revive(graded)
        graded_material.update_status(graded)


def _has_lost_proxy(thing, mark):
    return mark in thing.PropertiesList and getattr(thing, "Proxy", None) is None


_observer = _Observer()
