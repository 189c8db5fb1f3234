# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts and numbers in the user's language."""
import re

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


def length_text(millimetres):
    """A length as one would type it in the user's unit schema: "4 in" for 101.6; in mm the number alone."""
    unit, factor = _preferred(millimetres)
    return f"{millimetres + 0.0:.6g}" if unit == "mm" else f"{millimetres / factor + 0.0:.6g} {unit}"


def quantity_text(value, dimension):
    """A value in mm to the power `dimension` (1, -1 or 0) as one would type it in the user's unit schema."""
    unit, factor = _preferred(value if dimension == 1 else 1 / value if dimension and value else 0.0)
    if unit == "mm" or not dimension:
        return f"{value + 0.0:.6g}"
    return length_text(value) if dimension == 1 else f"{value * factor:.6g} 1/{unit}"


def in_user_units(text):
    """`text` with each "... mm" in it, as messages of the core have, in the user's unit schema."""
    return _MILLIMETRES.sub(_shown_length, text)


_MILLIMETRES = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) mm(?![\w^/])")


def _shown_length(found):
    unit, factor = _preferred(float(found[1]))
    return found[0] if unit == "mm" else f"{float(found[1]) / factor:.4g} {unit}"


def _preferred(millimetres):
    """(unit, mm in one of it) in which the user's schema shows such a length."""
    quantity = FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length)
    _, factor, unit = quantity.getUserPreferred()
    unit = {'"': "in", "'": "ft"}.get(unit, unit)
    try:
        # Schemas of builders write feet and inches together, whose unit is none that can be read again.
        known = FreeCAD.Units.Quantity(f"1 {unit}")
    except Exception:  # FreeCAD's parser of quantities knows many
        return "in", 25.4
    is_length = known.Unit == FreeCAD.Units.Length and abs(known.Value - factor) < 1e-6 * factor
    return (unit, factor) if is_length else ("in", 25.4)
