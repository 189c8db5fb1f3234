# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of solids and sections through them, as triangles to be looked at. NumPy and SciPy, no FreeCAD."""
