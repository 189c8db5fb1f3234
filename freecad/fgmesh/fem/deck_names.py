# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that FreeCAD's writer of decks takes from the objects of an analysis as they are: refused where they would break
the deck, or tell CalculiX anything else."""
import os
import re

from freecad.fgmesh import core
from freecad.fgmesh.io.groups import WORDS
from freecad.fgmesh.io.names import LONGEST

_LONGEST_LINE = 1000
"""Characters: CalculiX reads lines in pieces of 1320, and takes the rest of a comment for a line of its own."""

_LONGEST_ENDING = len("FaceEdge")
"""Of what FreeCAD adds to the name of a constraint for its sets."""

_PART = re.compile(rf"({'|'.join(WORDS)})[1-9]\d*")


def check_names(analysis):
    """Raises core.InvalidInput for the first object of `analysis` whose names a deck cannot hold."""
    file_name = os.path.basename(analysis.Document.FileName)
    _check_text(
        file_name, f"the file name of the document {analysis.Document.Name}", "save it under another name"
    )
    seen = {}
    for thing in _members(analysis):
        _check_text(thing.Label, f"the label of {thing.Name}", "rename it")
        for text in _texts_of(thing):
            _check_text(text, f"{thing.Label}: {text[:40]!r}", "correct it")
        _check_name(thing, seen)


def _members(analysis):
    """The objects in an analysis and in its groups, each once."""
    pending, found = [analysis], []
    while pending:
        thing = pending.pop(0)
        if thing not in found:
            found.append(thing)
            pending += [one for one in getattr(thing, "Group", []) if one is not None]
    return found


def _texts_of(thing):
    """What becomes part of the deck beside names and labels."""
    card = getattr(thing, "Material", None)
    names = [card.get("Name", "")] if hasattr(card, "get") else []
    return [*names, *getattr(thing, "YieldPoints", [])]


def _check_text(text, what, cure):
    if len(text.splitlines()) > 1 or text.endswith(("\n", "\r")):
        raise core.InvalidInput(f"{what} has more than one line, which would break the deck: {cure}")
    if len(text) > _LONGEST_LINE:
        raise core.InvalidInput(
            f"{what} has {len(text)} characters, but a line of the deck holds {_LONGEST_LINE}: {cure}"
        )


def _check_name(thing, seen):
    """The internal name, by which the deck has sets and materials: CalculiX knows no capitals, nor the end of long
    ones; and FreeCAD takes a group of the mesh that begins with it for the nodes of a constraint."""
    name, anew = thing.Name, "delete it and make it anew under another name"
    if len(name) + _LONGEST_ENDING > LONGEST:
        raise core.InvalidInput(
            f"{thing.Label} has an internal name of {len(name)} characters, but CalculiX knows sets by at most "
            f"{LONGEST - _LONGEST_ENDING}: {anew}"
        )
    other = seen.setdefault(name.lower(), thing)
    if other is not thing:
        raise core.InvalidInput(
            f"the internal names {other.Name} and {name} differ in capitals only, which CalculiX does not tell "
            f"apart: of {thing.Label}, {anew}"
        )
    if _PART.fullmatch(name) and hasattr(thing, "References"):
        raise core.InvalidInput(
            f"{thing.Label} has the internal name {name}, which is that of a part of the mesh: FreeCAD would put it on "
            f"that part, wherever it belongs; {anew}"
        )
