# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of objects with several solids: one for all, or those of the objects that they were made of, each where
its copy stands."""
import FreeCAD

from freecad.fgmesh import core
from freecad.fgmesh.model import instances
from freecad.fgmesh.model.graded_solid import HOW_TO_GIVE_ONE, has_material, material_of


def graded_parts(thing):
    """[(object, user)]: the objects whose materials hold in `thing`, in the order of its parts, each with the link,
    array or compound that it is a part of.

    `thing` alone where it has a material itself; else those of its parts, and of theirs, that have one.
    """
    return list(_graded_parts(thing, thing))


def _graded_parts(thing, user):
    if _has_own_material(thing):
        yield thing, user
        return
    for part in instances.sources_of(thing)[1]:
        yield from _graded_parts(part, thing)


def owners_of(thing):
    """[(object, placement)] for each solid of thing.Shape, in order: whose material holds there, and what leads from
    the coordinates of object.Shape to those of thing.Shape. The same pair where both are the same.

    Raises core.InvalidInput where a solid has none."""
    owners = _owners(thing)
    if not any(owners):
        raise core.InvalidInput(no_material(thing))
    if None in owners:
        raise core.InvalidInput(
            f"Solid{owners.index(None) + 1} of {thing.Label} lies in no object with a graded material: give its object "
            f"one {HOW_TO_GIVE_ONE}, or {thing.Label} itself one for all solids"
        )
    return owners


def materials_of(thing):
    """What `core.generate_mesh` takes as material for thing.Shape: a core.Material, or a list with that of each
    solid. Raises core.InvalidInput where a solid has none."""
    if _has_own_material(thing):
        return material_of(thing)
    owners = owners_of(thing)
    made = {id(part): material_of(*part) for part in owners}  # a part may stand in two places
    return [made[id(part)] for part in owners]


def no_material(thing):
    """What is said of an object that has no material."""
    graded = [part.Label for part in getattr(thing, "OutListRecursive", []) if has_material(part)]
    if graded:
        return (
            f"{thing.Label} does not take over the material of {graded[0]}, from which it is made: give {thing.Label} a "
            f"graded material of its own {HOW_TO_GIVE_ONE}; its coordinates are those of {thing.Label}"
        )
    return f"{thing.Label} has no graded material: give it one {HOW_TO_GIVE_ONE}"


def _has_own_material(thing):
    return (
        has_material(thing) and "FGMFractions" in thing.PropertiesList
    )  # links show their originals' properties


def _owners(thing):
    """As owners_of() gives them, but None for a solid without a material."""
    solids = thing.Shape.Solids
    if _has_own_material(thing):
        return [(thing, FreeCAD.Placement())] * len(solids)
    kind, sources = instances.sources_of(thing)
    originals = [
        (solid, owner)
        for source in sources
        if graded_parts(source)
        for solid, owner in zip(source.Shape.Solids, _owners(source))
    ]
    if not originals:
        return [None] * len(solids)
    if kind == instances.COPIES:
        return _owners_of_copies(thing, solids, sources)
    moved = _moved(originals, thing.Placement)
    return [_owner_in_place(solid, moved, kind) for solid in solids]


def _owners_of_copies(thing, solids, sources):
    instances.check_not_scaled(thing)
    for element in getattr(thing, "ElementList", []):
        if element.TypeId.startswith("App::Link") and _has_own_material(element):
            raise core.InvalidInput(
                f"{element.Label}, an element of {thing.Label}, has a material of its own beside that of its original: "
                f"put {element.Label} and the others into a compound and mesh that, or take its material away"
            )
    originals = [pair for source in sources for pair in zip(source.Shape.Solids, _owners(source))]
    found, made = [], {}
    for number, solid in enumerate(solids):
        original, owner = originals[number % len(originals)]
        move = instances.move_of(solid, original) if len(solids) % len(originals) == 0 else None
        if move is None:
            raise core.InvalidInput(
                f"Solid{number + 1} of {thing.Label} is no copy of a solid of {sources[0].Label}, whose material it would "
                f"have: recompute the document, or give {thing.Label} a graded material of its own"
            )
        key = (id(owner), *move.Base, *move.Rotation.Q)
        if owner is not None and key not in made:
            made[key] = (owner[0], move.multiply(owner[1]))
        found.append(made.get(key))
    return found


def _moved(originals, placement):
    """[(solid, owner)] with both moved by `placement`; one that stands in several pairs stays one."""
    found, made = [], {None: None}
    for original, owner in originals:
        shape = original.copy(False)
        shape.Placement = placement.multiply(shape.Placement)
        key = owner and id(owner)
        if key not in made:
            made[key] = (owner[0], placement.multiply(owner[1]))
        found.append((shape, made[key]))
    return found


def _owner_in_place(solid, originals, kind):
    """The owner of the original that `solid` is, or else of the first that it is a piece of."""
    tests = [instances.is_same] + ([instances.lies_in] if kind == instances.FRAGMENTS else [])
    for test in tests:
        for shape, owner in originals:
            if test(solid, shape):
                return owner
    return None
