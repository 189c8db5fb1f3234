# SPDX-License-Identifier: GPL-3.0-or-later
"""To be imported first: puts FreeCAD, and FGMesh as ./scripts/build has made it, on Python's path."""
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(os.environ.get("FGMESH_BUILD", ROOT / "build"))
sys.path.insert(0, str(BUILD / "Mod" / "FGMesh"))
sys.path.append("/usr/lib/freecad-python3/lib")
# What FreeCAD's own workbenches need of each other.
sys.path += [f"/usr/share/freecad/{folder}" for folder in ("Mod", "Mod/Fem", "Mod/Part", "Ext")]
