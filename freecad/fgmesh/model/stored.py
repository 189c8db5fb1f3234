# SPDX-License-Identifier: GPL-3.0-or-later
"""What a document holds, read with checks: it may come from a stranger, from another version, or from an editor of texts.

Properties can have another type than ours, and texts need not be the JSON that was written. Each function raises
core.InvalidInput that names the object, the property and a cure.
"""
import json

import FreeCAD

from freecad.fgmesh import core


def texts(thing, name):
    """The list of texts in the property `name` of `thing`; empty where it has none."""
    value = getattr(thing, name, [])
    if not isinstance(value, (list, tuple)) or not all(isinstance(text, str) for text in value):
        raise _wrong(thing, name, "a list of texts")
    return list(value)


def placement(thing, name):
    """The Placement in the property `name` of `thing`; the identity where it has none."""
    value = getattr(thing, name, FreeCAD.Placement())
    if not isinstance(value, FreeCAD.Placement):
        raise _wrong(thing, name, "a placement")
    return value


def links(thing, name):
    """[(object, names of parts)] in the property `name` of `thing`; empty where it has none."""
    value = getattr(thing, name, [])
    pairs = isinstance(value, (list, tuple)) and all(isinstance(p, tuple) and len(p) == 2 for p in value)
    if not pairs:
        raise _wrong(thing, name, "a list of links")
    return [(linked, (names,) if isinstance(names, str) else tuple(names)) for linked, names in value]


def document_in(thing, name):
    """The object of JSON in the text property `name` of `thing`, as a dict."""
    try:
        value = json.loads(getattr(thing, name))
        if isinstance(value, dict):
            return value
    except (TypeError, ValueError, RecursionError):
        pass
    raise damaged(thing, name)


def damaged(thing, name):
    """The InvalidInput that tells of a text that has not the content that it was written with."""
    return core.InvalidInput(f"the property {name} of {thing.Label} is damaged")


def restore_property(thing, kind, name, *arguments):
    """Have `thing` have a property of this kind, with the arguments of addProperty() behind its name.

    One of another kind is replaced, and its value kept where the new one takes it. True where the property is new and
    has no value yet.
    """
    kept = []
    if name in thing.PropertiesList:
        if thing.getTypeIdOfProperty(name) == kind:
            return False
        kept.append(getattr(thing, name))
        thing.removeProperty(name)
    thing.addProperty(kind, name, *arguments)
    for value in kept:
        try:
            setattr(thing, name, value)
            return False
        except (TypeError, ValueError, OverflowError):
            FreeCAD.Console.PrintWarning(
                f"the property {name} of {thing.Label} was of another kind and has its default now\n"
            )
    return True


def _wrong(thing, name, wanted):
    return core.InvalidInput(
        f"the property {name} of {thing.Label} is no longer {wanted}: give it its graded material again"
    )
