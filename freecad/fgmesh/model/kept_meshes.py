# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets undo and redo bring Fem meshes back, which FreeCAD by itself does not.

FreeCAD's FemMesh property writes a new mesh into the place of the old one, so its undo step holds the new one
twice. Here the last few meshes of an object are kept in memory, by the fingerprint that was stored with
each: a property that undo does bring back.
"""
import Fem

_LIMIT = 4


class KeptMeshes:
    """The latest meshes of one mesh object, for as long as its document is open. arrays: (fingerprint, (points, tets)) of
    the last one whose arrays somebody had; None."""

    arrays = None

    def __init__(self):
        self._meshes = {"": Fem.FemMesh()}

    def keep(self, fingerprint, fem_mesh):
        self._meshes[fingerprint] = fem_mesh
        for oldest in list(self._meshes)[1 : 1 - _LIMIT]:  # the first is the empty mesh
            del self._meshes[oldest]

    def __contains__(self, fingerprint):
        return fingerprint in self._meshes

    def show(self, mesh):
        """Gives `mesh`, the object, the Fem mesh that belongs to its fingerprint, where it is still kept."""
        kept = self._meshes.get(mesh.Fingerprint)
        if kept is not None:
            mesh.FemMesh = kept
