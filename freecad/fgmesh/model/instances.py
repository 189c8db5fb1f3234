# SPDX-License-Identifier: GPL-3.0-or-later
"""What objects are made of: links, arrays, clones and compounds of copies; fragments of others; groups of them."""
import FreeCAD

from freecad.fgmesh import core

COPIES, FRAGMENTS, WHOLE = "copies", "fragments", "whole"
"""What the solids of an object are: those of its sources in order, perhaps several times; pieces of those; some of
those, where they stand."""

_DRAFT_ARRAYS = ("Array", "PathArray", "PathTwistedArray", "PointArray")
_SAME = 1e-6  # of the size: points and solids that differ by less are the same


def sources_of(thing):
    """(kind, [object]): what the solids of `thing` are, and of which objects; (None, []) where they are new ones."""
    if thing.TypeId.startswith("App::Link"):
        # A link with several elements gives itself for what it links to.
        linked = thing.getLinkedObject(False)
        linked = getattr(thing, "LinkedObject", None) if linked == thing else linked
        return COPIES, _with_shapes([linked] if linked else getattr(thing, "ElementList", []))
    if thing.isDerivedFrom("App::Part"):  # assemblies of FreeCAD 1.x, too
        return WHOLE, _with_shapes(thing.Group)
    proxy = getattr(thing, "Proxy", None)
    kind = getattr(proxy, "Type", "")
    if kind in _DRAFT_ARRAYS:
        return COPIES, _with_shapes([thing.Base])
    if kind == "Clone":
        return COPIES, _with_shapes(thing.Objects)
    if thing.TypeId.startswith("Part::Compound"):
        return COPIES, _with_shapes(thing.Links)
    if type(proxy).__name__ == "_CompoundFilter":
        return WHOLE, _with_shapes([thing.Base])
    if type(proxy).__name__ == "FeatureSlice":
        return FRAGMENTS, _with_shapes([thing.Base])
    # Boolean fragments, an XOR
    parts = getattr(thing, "Objects", None)
    return (FRAGMENTS, _with_shapes(parts)) if isinstance(parts, list) else (None, [])


def check_not_scaled(thing):
    """Raises core.InvalidInput where the copies in `thing` are scaled or mirrored: a material has a length."""
    # Draft clones have a vector called Scale, links a number and vectors.
    scales = [getattr(thing, "ScaleVector", None), getattr(thing, "Scale", None)]
    scales += [one for part in [thing, *getattr(thing, "ElementList", [])] for one in _scales(part)]
    for scale in scales:
        factors = [scale] if isinstance(scale, (int, float)) else list(scale or [])
        if any(abs(factor - 1) > _SAME for factor in factors):
            raise core.InvalidInput(
                f"{thing.Label} is scaled, and the material of its original is not: give {thing.Label} a graded material "
                f"of its own, whose coordinates are those of {thing.Label}"
            )


def move_of(solid, original):
    """The placement that leads from solid `original` to `solid`, a copy of it; None where it is no copy."""
    if not solid.isPartner(original) and not _same_geometry(_unplaced(solid), _unplaced(original)):
        return None
    return solid.Placement.multiply(original.Placement.inverse())


def is_same(solid, other):
    """True where two solids fill the same place."""
    size = solid.BoundBox.DiagonalLength
    return (
        abs(solid.Volume - other.Volume) < _SAME * solid.Volume
        and abs(solid.Area - other.Area) < _SAME * solid.Area
        and solid.CenterOfMass.distanceToPoint(other.CenterOfMass) < _SAME * size
    )


def lies_in(solid, other):
    """True where `solid` is a piece of `other`: where a point inside, all vertices and points of all edges and faces
    lie in it."""
    tolerance = _SAME * solid.BoundBox.DiagonalLength
    point = _inner_point(solid)
    if point is None or not other.isInside(point, tolerance, False):
        return False
    points = [vertex.Point for vertex in solid.Vertexes]
    for edge in solid.Edges:
        if not edge.Degenerated:
            points.append(edge.valueAt(sum(edge.ParameterRange) / 2))
    points += [face.valueAt(*place) for face in solid.Faces for place in _places_on(face)]
    return all(other.isInside(point, tolerance, True) for point in points)


def _scales(part):
    yield getattr(part, "ScaleVector", None)
    yield from getattr(part, "ScaleList", None) or []


def _with_shapes(things):
    return [thing for thing in things or [] if hasattr(thing, "Shape")]


def _unplaced(solid):
    local = solid.copy(False)
    local.Placement = FreeCAD.Placement()
    return local


def _same_geometry(solid, other):
    if (len(solid.Faces), len(solid.Edges)) != (len(other.Faces), len(other.Edges)):
        return False
    if len(solid.Vertexes) != len(other.Vertexes) or not is_same(solid, other):
        return False
    tolerance = _SAME * solid.BoundBox.DiagonalLength
    # In order: so a solid that was turned onto itself is another one.
    pairs = zip(solid.Vertexes, other.Vertexes)
    return all(one.Point.distanceToPoint(two.Point) < tolerance for one, two in pairs)


def _inner_point(solid):
    """A point inside, a little below a face; None where none is found."""
    size = solid.BoundBox.DiagonalLength
    for depth in (1e-2, 1e-3, 1e-4):
        for face in solid.Faces:
            for u, v in _places_on(face):
                point = face.valueAt(u, v) - face.normalAt(u, v) * (depth * size)
                if solid.isInside(point, _SAME * size, False):
                    return point
    return None


def _places_on(face):
    """Some parameters (u, v) that lie on the face."""
    u_low, u_high, v_low, v_high = face.ParameterRange
    for u_part, v_part in ((0.5, 0.5), (0.3, 0.4), (0.6, 0.7)):
        u, v = u_low + u_part * (u_high - u_low), v_low + v_part * (v_high - v_low)
        if face.isPartOfDomain(u, v):
            yield u, v
