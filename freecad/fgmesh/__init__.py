# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedral FEM meshes of functionally graded solids.

The functions of this package work on FreeCAD documents, with or without a GUI:

    attach_material   gives a solid its material, as properties
    make_mesh         adds a mesh object that follows a solid
    generate          fills a mesh object
    make_analysis     makes or completes a FEM analysis of a mesh
    solve             has CalculiX solve such an analysis

`freecad.fgmesh.core` meshes without FreeCAD; so nothing that needs it is imported before it is asked for.
"""
import importlib

_HOMES = {
    "attach_material": "freecad.fgmesh.model.graded_solid",
    "make_mesh": "freecad.fgmesh.model.mesh_object",
    "generate": "freecad.fgmesh.fem.generate",
    "make_analysis": "freecad.fgmesh.fem.analysis",
    "solve": "freecad.fgmesh.fem.solving",
}

__all__ = sorted(_HOMES)


def __getattr__(name):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(_HOMES[name]), name)


def __dir__():
    return sorted(set(globals()) | set(_HOMES))
