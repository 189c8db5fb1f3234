# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts in the user's language."""
import FreeCAD

CONTEXT = "FGMesh"


def translate(text):
    """`text`, English, in the user's language. Literals here are found by scripts/update-translations; others need
    model.texts.TRANSLATE_LATER where they are written."""
    return FreeCAD.Qt.translate(CONTEXT, text)
