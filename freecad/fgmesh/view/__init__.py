# SPDX-License-Identifier: GPL-3.0-or-later
"""How the objects of this workbench look in FreeCAD's GUI."""
from pathlib import Path

_ICONS = Path(__file__).absolute().parents[3] / "icons"


def icon(name):
    """Path of the icon of that name."""
    return str(_ICONS / f"{name}.svg")


ICON = icon("preferences-fgmesh")  # by which name FreeCAD looks for it
