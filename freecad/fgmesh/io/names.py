# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of sets and groups, made so that no file that holds them can be broken, or told anything else, by one."""
import re
import unicodedata

LONGEST = 80
"""Characters: what CalculiX and Abaqus take of a name; MED files the same, gmsh 127."""

_FORBIDDEN = re.compile(r"[^A-Za-z0-9_-]+")
_NAMELESS = "Group"


def clean_names(names, taken=()):
    """For each of `names`, any texts, one of ASCII letters, digits, `_` and `-`, that begins with a letter, has at most
    LONGEST characters and differs from all others and from those `taken` by more than its case.

    A name that is like that already stays as it is, unless it comes after its equal: then a number is added. Accents
    are left out, anything else becomes `_`.
    """
    found, used = [], {name.lower() for name in taken}
    for name in names:
        base = _clean(name)
        unique, number = base, 1
        while unique.lower() in used:
            number += 1
            tail = f"_{number}"
            unique = base[: LONGEST - len(tail)] + tail
        used.add(unique.lower())
        found.append(unique)
    return found


def _clean(name):
    plain = unicodedata.normalize("NFKD", str(name))
    plain = "".join(letter for letter in plain if not unicodedata.combining(letter))
    clean = _FORBIDDEN.sub("_", plain)
    if not any(letter.isalnum() for letter in clean):
        return _NAMELESS
    if not clean[0].isalpha():
        clean = f"{_NAMELESS}_{clean.lstrip('_-')}"
    return clean[:LONGEST]
