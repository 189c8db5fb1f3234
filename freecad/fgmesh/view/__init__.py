# SPDX-License-Identifier: GPL-3.0-or-later
"""How the objects of this workbench look in FreeCAD's GUI."""
from pathlib import Path

ICON = str(Path(__file__).absolute().parents[3] / "icons" / "fgmesh.svg")
