# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts for users, in English here; a GUI translates them when it shows them."""
import FreeCAD

TRANSLATE_LATER = FreeCAD.Qt.QT_TRANSLATE_NOOP
"""TRANSLATE_LATER(context, text) gives the text. scripts/update-translations finds texts by it; the context is FGMesh,
or the name of a command where FreeCAD itself translates."""
