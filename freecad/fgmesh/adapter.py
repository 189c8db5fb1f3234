# SPDX-License-Identifier: GPL-3.0-or-later
"""All that differs between the versions of FreeCAD, 0.20 to 1.x, in names, places and modules.

Nothing else of FGMesh asks for a version, or tries one name after another. What a version lacks is found out by looking for
it, not by the version's number. Works without a GUI; functions for Qt take its objects.
"""
import importlib
import sys
from pathlib import Path

import FreeCAD


def fem_module(name):
    """The module of the FEM workbench with this name, as "ObjectsFem" or "femtools.ccxtools", which only FreeCAD's
    windows and its command line have on their path."""
    return _module_in(name, "Mod/Fem", "Ext")


def make_standard_solver(document):
    """FreeCAD's own solver object for CalculiX."""
    objects = fem_module("ObjectsFem")
    make = _first(objects, "makeSolverCalculixCcxTools", "makeSolverCalculiXCcxTools")  # FreeCAD 0.20, 1.x
    return make(document)


CARD_FOLDERS = ("Mod/Material/StandardMaterial", "Mod/Material/Resources/Materials")
"""Of FreeCAD's resources: where its material cards are in 0.20, in 1.x."""


def read_card(path):
    """{property: text with unit} of the material card at `path`; empty where FreeCAD does not know it."""
    try:
        import Materials  # FreeCAD 1.x
    except ImportError:
        return dict(_module_in("importFCMat", "Mod/Material").read(path))
    stem = Path(path).stem
    for material in Materials.MaterialManager().Materials.values():
        if material.Name in (stem, stem.replace("-", " ")):
            return {name: str(value) for name, value in material.Properties.items()}
    return {}


def _module_in(name, *folders):
    try:
        return importlib.import_module(name)
    except ImportError:
        paths = [str(Path(FreeCAD.getResourceDir()) / folder) for folder in folders]
        if set(paths) <= set(sys.path):
            raise
        sys.path += [path for path in paths if path not in sys.path]
        return importlib.import_module(name)


def _first(owner, *names):
    """What `owner` has by one of these names."""
    for name in names:
        if hasattr(owner, name):
            return getattr(owner, name)
    raise RuntimeError(f"this FreeCAD has none of {', '.join(names)}, of which FGMesh needs one")
