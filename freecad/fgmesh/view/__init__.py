# SPDX-License-Identifier: GPL-3.0-or-later
"""How the objects of this workbench look in FreeCAD's GUI."""
from pathlib import Path

# Not resolved: a build links the Python files into the Mod folder, where the icons stand beside them.
ICON = str(Path(__file__).absolute().parents[3] / "icons" / "fgmesh.svg")
