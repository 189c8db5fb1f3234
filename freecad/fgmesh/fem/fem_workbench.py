# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's FEM workbench, which only its windows and its command line have on their path."""
import importlib
import sys
from pathlib import Path

import FreeCAD


def module(name):
    """The module of the FEM workbench with this name, as "ObjectsFem" or "femtools.ccxtools"."""
    try:
        return importlib.import_module(name)
    except ImportError:
        folders = [str(Path(FreeCAD.getResourceDir()) / folder) for folder in ("Mod/Fem", "Ext")]
        if set(folders) <= set(sys.path):
            raise
        sys.path += [folder for folder in folders if folder not in sys.path]
        return importlib.import_module(name)


def make_standard_solver(document):
    """FreeCAD's own solver object for CalculiX."""
    objects = module("ObjectsFem")
    for name in ("makeSolverCalculixCcxTools", "makeSolverCalculiXCcxTools"):  # FreeCAD 0.20, 1.x
        if hasattr(objects, name):
            return getattr(objects, name)(document)
    raise RuntimeError("this FreeCAD has no CalculiX solver that FGMesh knows")
