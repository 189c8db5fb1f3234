# SPDX-License-Identifier: GPL-3.0-or-later
"""What a FreeCAD document knows of graded solids and their meshes. Needs FreeCAD, never Qt."""
