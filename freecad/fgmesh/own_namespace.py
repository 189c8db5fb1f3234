# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `freecad` a namespace of this process with FGMesh alone in it, where nothing has imported it yet.

Debian 13 has a `freecad/__init__.py`, which loads all of FreeCAD, with its handlers of signals, and prints a line: no
command line and no child process wants that. To be run as a file by its path (`runpy.run_path`), for the import of any
module of `freecad.fgmesh` is too late.
"""
import sys
from pathlib import Path
from types import ModuleType


def install():
    package = ModuleType("freecad")
    package.__path__ = [str(Path(__file__).resolve().parents[1])]
    sys.modules.setdefault("freecad", package)
