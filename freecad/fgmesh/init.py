# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD imports this module when it starts, with or without a GUI: nothing heavy is loaded here."""
from freecad.fgmesh.fem import revival

revival.watch()
