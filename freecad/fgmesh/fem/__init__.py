# SPDX-License-Identifier: GPL-3.0-or-later
"""From plain arrays to FreeCAD's FEM objects. Needs FreeCAD, never Qt."""
