# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces, edges, vertices and solids to which a solid's formula measures distances.

They are kept in two properties: FGMReferences holds the links. FreeCAD takes a link away with the object that it
leads to, and d2 would become d1; FGMReferenceNames remembers what there was.
"""
import re

from freecad.fgmesh import core
from freecad.fgmesh.model import stored
from freecad.fgmesh.model.shapes import brep_text

# A plain App::PropertyLinkSubList that leads to a face of its own solid makes a cycle: FreeCAD would refuse to
# recompute the document.
LINKS = "App::PropertyLinkSubListHidden"

PARTS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}
"""The attributes of a shape that list its parts."""


def links_of(references, solid):
    """[(object, name of a part or "")] of what a user gives as `references`: pairs of object and name or names,
    objects for their solid, names for parts of `solid` itself. Raises core.InvalidInput."""
    links = []
    for reference in [references] if isinstance(references, str) else references:
        if isinstance(reference, str):
            reference = (solid, reference)
        elif not isinstance(reference, (tuple, list)):
            reference = (reference, "")
        if len(reference) != 2:
            raise core.InvalidInput(f"{reference!r} is no reference: give (object, 'Face3')")
        thing, names = reference
        names = [names] if isinstance(names, str) else list(names)
        if getattr(thing, "Document", None) != solid.Document or not all(isinstance(n, str) for n in names):
            raise core.InvalidInput(
                f"{reference!r} is no reference: give (object, 'Face3') with an object of the document "
                f"{solid.Document.Label}"
            )
        links += [(thing, name) for name in names]
    return links


def set_links(solid, links):
    """Stores `links` in the properties, which must be there."""
    solid.FGMReferences = [(thing, (name,)) for thing, name in links]
    solid.FGMReferenceNames = [full_name(*link) for link in links]


def stored_links(solid):
    """The links in the properties of `solid`, in the order of d1, d2, ..."""
    return [
        (thing, name) for thing, names in stored.links(solid, "FGMReferences") for name in (names or ("",))
    ]


def full_name(thing, name):
    return f"{thing.Name}.{name}" if name else thing.Name


def remembered_names(solid):
    """What set_links() was given, by full_name()."""
    return stored.texts(solid, "FGMReferenceNames")


def check_complete(solid):
    """Raises core.InvalidInput that names the references whose objects were deleted."""
    remembered, links = remembered_names(solid), stored_links(solid)
    if len(links) >= len(remembered):
        return
    present = {full_name(*link) for link in links}
    lost = ", ".join(
        f"d{number} ({name})" for number, name in enumerate(remembered, 1) if name not in present
    )
    raise core.InvalidInput(
        f"{solid.Label} has lost the reference {lost}: its object was deleted; attach the material anew"
    )


def unread(links, solid, placement):
    """A core.Reference for each of `links`, in the coordinates to which `placement` leads from those of
    `solid.Shape`: not read yet, which may crash on a bad shape. Raises core.InvalidInput that names a part which
    is lost, core.GeometryError for an object without a solid."""
    texts, found = {}, []
    for thing, name in links:
        try:
            if thing not in texts:
                shape = _shape_beside(thing, solid).copy(False)
                shape.Placement = placement.multiply(shape.Placement)
                texts[thing] = brep_text(shape)
            found += core.references(texts[thing], [_part_name(thing, name)], read=False)
        except core.InvalidInput as error:
            raise core.InvalidInput(f"{thing.Label}: {error}") from None
        except core.GeometryError as error:
            raise core.GeometryError(f"{thing.Label}, a reference of {solid.Label}: {error}") from None
    return found


def _part_name(thing, name):
    """What the reference is called in the shape, which must have it."""
    # FreeCAD 1.x marks a part that it no longer finds by a question mark.
    name = name.lstrip("?")
    solids = len(thing.Shape.Solids)
    if not solids:
        raise core.GeometryError("it has no solid to which a distance could be measured: make a solid of it")
    if not name:
        if solids != 1:
            raise core.InvalidInput(f"it has {solids} solids: name one, as in 'Solid1'")
        return "Solid1"
    match = re.fullmatch(r"(Face|Edge|Vertex|Solid)([1-9][0-9]*)", name)
    if not match:
        raise core.InvalidInput(
            f"the reference {name!r} names no part: write Face1, Edge1, Vertex1 or Solid1"
        )
    kind, number = match.groups()
    count = len(getattr(thing.Shape, PARTS[kind]))
    # Not int(number): its digits may be very many.
    if (len(number), number) > (len(str(count)), str(count)):
        raise core.InvalidInput(
            f"the reference {name} is lost: the shape ends with {kind}{count}; choose it anew"
        )
    return name


def _shape_beside(thing, solid):
    """The shape of `thing` in the coordinates in which `solid.Shape` is given: those of its container."""
    shape = getattr(thing, "Shape", None)
    if shape is None or not hasattr(shape, "Solids") or shape.isNull():
        raise core.InvalidInput(
            "it has no shape that a distance could be measured to: recompute the document"
        )
    if thing == solid:
        return shape
    if solid.isDerivedFrom("App::Link") and solid.getLinkedObject(True) == thing:
        return solid.Shape  # a face of its own is meant, not that of the original
    moved = shape.copy(False)
    moved.Placement = _container(solid).inverse().multiply(_container(thing)).multiply(shape.Placement)
    return moved


def _container(thing):
    return thing.getGlobalPlacement().multiply(thing.Placement.inverse())


def fingerprint(solid, shape_hash, numbers):
    """What tells whether a mesh was made with these references: a list of small dictionaries. `solid` itself is
    told of elsewhere; others by `shape_hash(shape)` and `numbers(placement)`."""
    remembered_names(solid)  # which a material could not be made without
    found = []
    for thing, name in stored_links(solid):
        entry = {"name": full_name(thing, name)}
        if thing != solid and hasattr(thing, "Shape"):
            place = _container(solid).inverse().multiply(thing.getGlobalPlacement())
            entry.update(shape=shape_hash(thing.Shape), placement=numbers(place))
        found.append(entry)
    return found
