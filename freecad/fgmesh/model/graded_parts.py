# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of objects with several solids: one for all, or those of the objects that they were made of."""
import FreeCAD

from freecad.fgmesh import core
from freecad.fgmesh.model.graded_solid import has_material, material_of

_PART_LISTS = ("Links", "Objects")
"""Properties with the objects that a Part compound, or Boolean fragments, an XOR or a slice, is made of."""

_SAME = 1e-6  # of the size: solids that differ by less are the same


def graded_parts(thing):
    """[(object, placement)]: the objects whose materials hold in `thing`, in the order of its parts.

    `thing` alone where it has a material itself; else those of its parts, and of theirs, that have one. The
    placement leads from the coordinates of object.Shape to those of thing.Shape.
    """
    return list(_graded_parts(thing, FreeCAD.Placement()))


def _graded_parts(thing, placement):
    if has_material(thing):
        yield thing, placement
        return
    lists = [getattr(thing, name, None) for name in _PART_LISTS]
    for part in [part for parts in lists if isinstance(parts, list) for part in parts]:
        if hasattr(part, "Shape"):
            yield from _graded_parts(part, placement.multiply(thing.Placement))


def owners_of(thing):
    """[(object, placement)] for each solid of thing.Shape, in order: whose material holds there, as graded_parts()
    gives it. Raises core.InvalidInput where a solid has none."""
    parts = graded_parts(thing)
    if not parts:
        raise core.InvalidInput(f"{thing.Label} has no graded material: give it one with attach_material()")
    solids = thing.Shape.Solids
    if parts[0][0] == thing:
        return parts * len(solids)
    return [parts[_owner(solid, number, parts, thing)] for number, solid in enumerate(solids, 1)]


def materials_of(thing):
    """What `core.generate_mesh` takes as material for thing.Shape: a core.Material, or a list with that of each
    solid. Raises core.InvalidInput where a solid has none."""
    if has_material(thing):
        return material_of(thing)
    owners = owners_of(thing)
    made = {id(part): material_of(*part) for part in owners}  # a part may stand in two places
    return [made[id(part)] for part in owners]


def _owner(solid, number, parts, thing):
    """Which of `parts` a solid is, or else the first that it lies in: a fragment of it."""
    shapes = []
    for part, placement in parts:
        shape = part.Shape.copy(False)
        shape.Placement = placement.multiply(shape.Placement)
        shapes.append(shape)
    for place, shape in enumerate(shapes):
        if any(_is_same(solid, other) for other in shape.Solids):
            return place
    point = _inner_point(solid)
    tolerance = _SAME * solid.BoundBox.DiagonalLength
    for place, shape in enumerate(shapes):
        if point and any(other.isInside(point, tolerance, False) for other in shape.Solids):
            return place
    raise core.InvalidInput(
        f"Solid{number} of {thing.Label} lies in no object with a graded material: give its object one with "
        f"attach_material(), or {thing.Label} itself one for all solids"
    )


def _is_same(solid, other):
    size = solid.BoundBox.DiagonalLength
    return (
        abs(solid.Volume - other.Volume) < _SAME * solid.Volume
        and abs(solid.Area - other.Area) < _SAME * solid.Area
        and solid.CenterOfMass.distanceToPoint(other.CenterOfMass) < _SAME * size
    )


def _inner_point(solid):
    """A point inside, a little below a face; None where none is found."""
    size = solid.BoundBox.DiagonalLength
    for depth in (1e-2, 1e-3, 1e-4):
        for face in solid.Faces:
            u_low, u_high, v_low, v_high = face.ParameterRange
            for u_part, v_part in ((0.5, 0.5), (0.3, 0.4), (0.6, 0.7)):
                u, v = u_low + u_part * (u_high - u_low), v_low + v_part * (v_high - v_low)
                if not face.isPartOfDomain(u, v):
                    continue
                point = face.valueAt(u, v) - face.normalAt(u, v) * (depth * size)
                if solid.isInside(point, _SAME * size, False):
                    return point
    return None
