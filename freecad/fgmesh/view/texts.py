# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts and numbers in the user's language."""
import FreeCAD
from PySide import QtCore

CONTEXT = "FGMesh"


def translate(text):
    """`text`, English, in the user's language. Literals here are found by scripts/update-translations; others need
    model.texts.TRANSLATE_LATER where they are written."""
    return FreeCAD.Qt.translate(CONTEXT, text)


def number_text(value, form):
    """`value` as format() writes it, with the separators of the user's language: in German 1.234 tetrahedra."""
    locale = QtCore.QLocale()
    # + 0 turns -0.0 into 0.0.
    return format(value + 0, form).translate(
        {ord(","): locale.groupSeparator(), ord("."): locale.decimalPoint()}
    )
