# SPDX-License-Identifier: GPL-3.0-or-later
# FreeCAD executes this file, and imports freecad.fgmesh.init_gui by itself too: a second import does nothing,
# so the workbench is registered once.
import freecad.fgmesh.init_gui  # noqa: F401
