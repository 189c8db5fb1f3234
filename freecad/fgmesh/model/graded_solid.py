# SPDX-License-Identifier: GPL-3.0-or-later
"""The material of a solid: properties of group FGM on the solid itself, so that they are saved, copied and
driven by expressions with it."""
import FreeCAD

from freecad.fgmesh import core
from freecad.fgmesh.model import stored
from freecad.fgmesh.model.references import (
    LINKS,
    check_complete,
    links_of,
    set_links,
    stored_links,
    unread,
)
from freecad.fgmesh.model.transaction import transaction

GROUP = "FGM"
PARAMETER_PREFIX = "FGM_"

_PROPERTIES = (
    (
        "FGMConstituents",
        "App::PropertyStringList",
        "The constituents: names of material cards or of material objects of this document",
    ),
    (
        "FGMFractions",
        "App::PropertyStringList",
        "Volume fraction of each constituent but the last, as a formula of x y z r theta d (mm, radians), "
        "of distances d1 s1 ..., of tables t1 ... and of the parameters FGM_<name>",
    ),
    (
        "FGMFrame",
        "App::PropertyPlacement",
        "The frame in which the formula's coordinates are measured, in the solid's own coordinates",
    ),
    (
        "FGMReferences",
        LINKS,
        "Faces, edges, vertices or solids to which the formula measures distances d1, d2, ... and s1, ...",
    ),
    (
        "FGMReferenceNames",
        "App::PropertyStringList",
        "The references as they were given, so that one which is lost can be named",
    ),
    (
        "FGMTables",
        "App::PropertyStringList",
        "The texts of the sampled tables t1, t2, ...: a header such as 'r, z, value', and a row for each sample",
    ),
)


def attach_material(solid, fractions, parameters=None, constituents=(), frame=None, references=(), tables=()):
    """Gives `solid` a graded material, in place of the one that it may have.

    solid         any document object with a solid shape: Part features, PartDesign bodies, ...
    fractions     formulas of the volume fractions of all constituents but the last, which is the remainder; of
                  two constituents the one formula may stand alone
    parameters    {name: number}; each becomes the property FGM_<name>, which takes expressions
    constituents  names of material cards or of material objects of the document, or such objects, one more
                  than formulas; may be left out until an analysis needs them
    frame         FreeCAD.Placement of the material's frame in the solid's own coordinates, mm
    references    what d1, d2, ... measure to, in this order: (object, "Face3") for a face, edge, vertex or
                  solid of an object with solids, "Face3" for one of `solid` itself, an object for its only
                  solid; s1, s2, ... are the same distances with a sign, for solids
    tables        what t1, t2, ... are the values of, in this order: paths of CSV files, their texts, or
                  core.SampledTable; the solid keeps their texts, and needs the files no more

    Raises core.InvalidInput (core.FormulaError for a formula), core.GeometryError for a reference whose
    shape has no valid solid, and leaves the solid as it was. One undo
    step. Returns the solid.
    """
    _check_kinds(fractions, parameters, constituents, references, tables)
    fractions = [fractions] if isinstance(fractions, str) else list(fractions)
    parameters = {name: plain_number(value) for name, value in (parameters or {}).items()}
    frame = FreeCAD.Placement() if frame is None else frame
    names = [_constituent_name(constituent, solid) for constituent in constituents]
    _check(solid, fractions, frame, names)
    links = links_of(references, solid)
    tables = core.table_texts(tables)
    _material(fractions, parameters, frame, links, tables, solid)

    with transaction(solid.Document, "Attach graded material"):
        _add_missing_properties(solid)
        solid.FGMConstituents = names
        solid.FGMFractions = fractions
        solid.FGMFrame = frame
        set_links(solid, links)
        solid.FGMTables = tables
        _set_parameters(solid, parameters)
    return solid


HOW_TO_GIVE_ONE = "by FGMesh, Graded material (in Python: attach_material())"
"""Of messages: by the menu first, which is what most users have before them."""


def has_material(solid):
    """True where attach_material() or a user has given `solid` a formula."""
    return bool(getattr(solid, "FGMFractions", None))


def holder(solid):
    """The object whose properties hold the material of `solid`: itself, or what it is a link to, unless the link has
    got a material of its own."""
    if "FGMFractions" in solid.PropertiesList or not solid.isDerivedFrom("App::Link"):
        return solid
    return solid.getLinkedObject(True) or solid


def parameters_of(solid):
    """{name: value} of the parameters FGM_<name>, as they are now."""
    owner = holder(solid)
    return {
        name[len(PARAMETER_PREFIX) :]: plain_number(getattr(owner, name))
        for name in owner.PropertiesList
        if name.startswith(PARAMETER_PREFIX)
    }


def tables_of(solid):
    """The texts of the tables t1, t2, ... of `solid`."""
    # Always with a line break: nothing in a document, which may come from a stranger, is taken for a path.
    return [text.rstrip("\n") + "\n" for text in stored.texts(solid, "FGMTables")]


def frame_in_document(solid):
    """Placement of the material's frame in the coordinates of `solid.Shape`, which carries the solid's own
    placement but not its containers'."""
    return solid.Placement.multiply(stored.placement(solid, "FGMFrame"))


def material_of(solid, placement=None):
    """The core.Material of `solid`, in the coordinates of `solid.Shape`, or in those to which `placement` leads
    from there; its references have not been read yet.

    Raises core.InvalidInput, core.GeometryError for a reference without a solid."""
    if not has_material(solid):
        raise core.InvalidInput(f"{solid.Label} has no graded material: give it one {HOW_TO_GIVE_ONE}")
    check_complete(solid)
    links = stored_links(solid)
    placement = FreeCAD.Placement() if placement is None else placement
    frame = placement.multiply(frame_in_document(solid))
    tables = tables_of(solid)
    return _material(
        stored.texts(solid, "FGMFractions"), parameters_of(solid), frame, links, tables, solid, placement
    )


def draft_material(solid, fractions, parameters, frame, links, tables):
    """The core.Material that attach_material() would give `solid`, in the coordinates of `solid.Shape`, for
    looking at it before. Raises core.InvalidInput."""
    return _material(fractions, parameters, solid.Placement.multiply(frame), links, tables, solid)


def plain_number(value):
    """`value`, a number or a FreeCAD quantity, as a float in FreeCAD's units (mm)."""
    try:
        return float(getattr(value, "Value", value))
    except (TypeError, ValueError, OverflowError, NotImplementedError):  # FreeCAD's placements raise the last
        raise core.InvalidInput(f"a parameter must be a number, not {value!r}") from None


def _material(fractions, parameters, frame, links, tables, solid, placement=FreeCAD.Placement()):
    matrix = frame.Rotation.toMatrix().A
    rotation = [matrix[0:3], matrix[4:7], matrix[8:11]]
    references = unread(links, solid, placement)
    return core.Material(list(fractions), parameters, tuple(frame.Base), rotation, references, tables=tables)


def _check_kinds(fractions, parameters, constituents, references, tables):
    given = {"fractions": fractions, "constituents": constituents, "references": references, "tables": tables}
    for name, value in given.items():
        if not hasattr(value, "__iter__"):
            raise core.InvalidInput(f"{name} must be a list, not {value!r}")
    named = parameters is None or hasattr(parameters, "items")
    if not named or not all(isinstance(name, str) for name in parameters or ()):
        raise core.InvalidInput(f"parameters must be {{name: number}}, not {parameters!r}")


def _check(solid, fractions, frame, names):
    shape = getattr(solid, "Shape", None)
    if not hasattr(shape, "Solids"):
        label = getattr(solid, "Label", repr(solid))
        raise core.InvalidInput(f"{label} has no shape: attach the material to a solid or a body")
    # A feature that was never computed has a null shape; whether it becomes a solid shows when it is meshed.
    if not shape.isNull() and not shape.Solids:
        raise core.InvalidInput(
            f"{solid.Label} is a {shape.ShapeType}, not a solid: make a solid of it first"
        )
    if not all(isinstance(formula, str) for formula in fractions):
        raise core.InvalidInput(f"fractions must be formulas, as text: not {fractions!r}")
    if not isinstance(frame, FreeCAD.Placement):
        raise core.InvalidInput(f"the material's frame must be a FreeCAD.Placement, not {frame!r}")
    if names and len(names) != len(fractions) + 1:
        raise core.InvalidInput(
            f"{len(names)} constituents need {len(names) - 1} formulas, not {len(fractions)}: "
            "the last constituent is what the others leave"
        )


def _constituent_name(constituent, solid):
    if isinstance(constituent, str) and constituent:
        return constituent
    if getattr(constituent, "Document", None) == solid.Document and hasattr(constituent, "Name"):
        return constituent.Name
    raise core.InvalidInput(
        f"{constituent!r} is no constituent: give the name of a material card, or a material object of the "
        f"document {solid.Document.Label}"
    )


def _add_missing_properties(solid):
    for name, kind, tip in _PROPERTIES:
        if name in solid.PropertiesList and solid.getTypeIdOfProperty(name) != kind:
            solid.removeProperty(name)  # as an earlier version had it
        if name not in solid.PropertiesList:
            solid.addProperty(kind, name, GROUP, tip)
    # FreeCAD's editor of such lists would make a table of each line.
    solid.setEditorMode("FGMTables", ["Hidden"])


def _set_parameters(solid, parameters):
    for name in parameters_of(solid).keys() - parameters.keys():
        solid.setExpression(PARAMETER_PREFIX + name, None)
        solid.removeProperty(PARAMETER_PREFIX + name)
    for name, value in parameters.items():
        property_name = PARAMETER_PREFIX + name
        if property_name in solid.PropertiesList:
            # An expression left in place would bring the old value back at the next recompute.
            solid.setExpression(property_name, None)
        else:
            tip = f"The parameter {name} of the material's formula"
            solid.addProperty("App::PropertyFloat", property_name, GROUP, tip)
        setattr(solid, property_name, value)
