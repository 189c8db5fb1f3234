# SPDX-License-Identifier: GPL-3.0-or-later
"""The graded material of an analysis: an object that knows the mesh, the mixing laws and how properties are told to
the solver, and that keeps the material objects and the mesh groups from which FreeCAD writes decks."""
import hashlib
import json
import math
from numbers import Integral, Real
from typing import NamedTuple

import FreeCAD
import numpy as np

from freecad.fgmesh import core, mixing
from freecad.fgmesh.fem.bins import MOST, Bins, bins
from freecad.fgmesh.adapter import fem_module
from freecad.fgmesh.fem.graded_fields import check_current, graded_mesh
from freecad.fgmesh.model import constituents, presentation, stored
from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.model.stateless import Stateless

MODES = ["bins", "continuous"]
_LAW = "{}Law"
_GROUP = "{}_Elements"
_SAME = 1e-9
"""Relative difference of numbers that stand for the same card."""
_OUTPUT = 8  # Prop_Output, as in mesh_object
_NOT_MADE = "out of date: no materials have been made yet"
_RESULTS = (
    ("Status", "App::PropertyString", "ok, or why the materials are out of date"),
    ("BinCount", "App::PropertyInteger", "Material objects that stand for the grading"),
    (
        "PropertyError",
        "App::PropertyFloat",
        "Largest relative error of a property in an element, by its bin; of Poisson's ratio relative to 0.5",
    ),
    ("Materials", "App::PropertyLinkListHidden", "The material objects, one for each bin"),
    ("MadeFrom", "App::PropertyString", "What they were made from, for telling when they are out of date"),
)
_HIDDEN = {"Materials", "MadeFrom"}


class Request(NamedTuple):
    """What a user asks of the graded material of an analysis; mixing: {property: text}, as mixing.read_laws() takes."""

    mode: str = "bins"
    bins: int = 20
    allowed_error: float = 0.0
    mixing: dict = {}

    def laws(self):
        """Those of all properties. Raises core.InvalidInput for whatever makes no sense in the request."""
        if self.mode not in MODES:
            raise core.InvalidInput(f"there is no mode {self.mode!r}: take one of {', '.join(MODES)}")
        if isinstance(self.bins, bool) or not isinstance(self.bins, Integral) or not 1 <= self.bins <= MOST:
            raise core.InvalidInput(f"bins must be a whole number from 1 to {MOST}, not {self.bins!r}")
        if not isinstance(self.mixing, dict):
            raise core.InvalidInput(f"mixing must be {{property: law}}, not {self.mixing!r}")
        error = self.allowed_error
        if isinstance(error, bool) or not isinstance(error, Real) or not 0 <= error < 1:
            raise core.InvalidInput(f"allowed_error must be a number from 0 to below 1, not {error!r}")
        return mixing.read_laws(self.mixing)


class GradedMaterial(Stateless):
    """The proxy."""

    def __init__(self, graded):
        _add_missing_properties(graded)
        graded.Proxy = self
        presentation.show_graded_material(graded)

    def execute(self, graded):
        update_status(graded)

    def onDocumentRestored(self, graded):
        _add_missing_properties(graded)
        presentation.show_graded_material(graded)


def revive(graded):
    """Gives back the proxy to an object that was saved by a FreeCAD without FGMesh."""
    if not isinstance(graded.Proxy, GradedMaterial):
        GradedMaterial(graded)


def is_graded_material(thing):
    """True for an object that new_graded_material() made."""
    return "PropertyError" in getattr(thing, "PropertiesList", ())


def graded_materials(document, mesh):
    """Those of `document` that are of `mesh`."""
    return [thing for thing in document.Objects if is_graded_material(thing) and thing.Mesh == mesh]


def groups_of_bins(mesh):
    """Names of the groups in the Fem mesh of `mesh` that are of bins of its graded materials."""
    materials = [one for graded in graded_materials(mesh.Document, mesh) for one in graded.Materials]
    return {_GROUP.format(material.Name) for material in materials if material is not None}


def new_graded_material(document, mesh, name="GradedMaterial"):
    """A new object, still without materials: fill() makes them."""
    graded = document.addObject("App::FeaturePython", name)
    GradedMaterial(graded)
    graded.Mesh = mesh
    return graded


def set_request(graded, request):
    """Puts the values of a Request into the object."""
    graded.Mode, graded.Bins, graded.AllowedError = request.mode, request.bins, request.allowed_error
    for name in mixing.PROPERTIES:
        setattr(graded, _LAW.format(name), request.mixing.get(name) or "")


def request_of(graded):
    """The Request that the object's properties are, as they are now."""
    laws = {name: getattr(graded, _LAW.format(name)) for name in mixing.PROPERTIES}
    return Request(graded.Mode, graded.Bins, graded.AllowedError, laws)


def fill(graded):
    """Makes the material objects and the mesh groups of `graded` anew, in place of those that it has.

    Raises core.InvalidInput, core.GeometryError before anything is changed.
    """
    request, mesh = request_of(graded), graded.Mesh
    fields = graded_mesh(mesh)
    parts = plan(fields, request)
    group = graded.getParentGroup()
    materials = _materials(graded, parts.count, group)
    for number, material in enumerate(materials):
        _set_card(material, {name: column[number] for name, column in parts.values.items()})
        material.References = [(mesh.Shape, _solid_names(mesh.Shape))] if len(materials) > 1 else []
    _set_groups(mesh, materials, parts.members())
    graded.Materials = materials
    graded.BinCount, graded.PropertyError = len(materials), parts.error
    graded.MadeFrom = json.dumps(_made_from(graded))
    update_status(graded)


def plan(fields, request):
    """The Bins that a Request comes to on a graded_fields.GradedMesh. Raises core.InvalidInput."""
    laws = request.laws()
    properties = fields.in_tets(laws)
    if request.mode == "bins":
        return bins(properties, request.bins, request.allowed_error)
    return _one_for_each_region(fields, properties, laws)


def refill(mesh):
    """Makes the materials of `mesh` anew in each analysis that has such; for after meshing."""
    for graded in graded_materials(mesh.Document, mesh):
        try:
            fill(graded)
        except core.Error as error:
            update_status(graded)
            FreeCAD.Console.PrintWarning(f"{graded.Label} is out of date: {error}\n")


def update_status(graded):
    status = _status(graded)
    if graded.Status != status:
        graded.Status = status


def check_filled(graded):
    """Raises core.InvalidInput where the materials do not belong to mesh, cards and laws as they are now."""
    check_current(graded.Mesh)
    update_status(graded)
    if graded.Status != "ok":
        raise core.InvalidInput(
            f"{graded.Label} is {graded.Status}. Create the graded analysis again, which completes this one"
        )


def _status(graded):
    if graded.Mesh is None:
        return "out of date: the mesh is gone"
    if not graded.MadeFrom:
        return graded.Status or _NOT_MADE
    if None in graded.Materials or len(graded.Materials) != graded.BinCount:
        return "out of date: some of its materials are gone"
    try:
        before, now = stored.document_in(graded, "MadeFrom"), _made_from(graded)
    except core.Error as error:
        return f"out of date: {error}"
    try:
        same_cards = _same_cards(before, now, graded)
    except (TypeError, ValueError, AttributeError):
        return f"out of date: {stored.damaged(graded, 'MadeFrom')}"
    found = []
    if before.get("mesh") != now["mesh"]:
        found.append("the mesh is another one")
    if before.get("request") != now["request"]:
        found.append("modes, bins or laws were changed")
    if not same_cards:
        found.append("a material card was changed")
    return "out of date: " + "; ".join(found) if found else "ok"


def _made_from(graded):
    return {
        "mesh": graded.Mesh.Fingerprint,
        "request": list(request_of(graded)),
        "properties": [[name, _numbers(card)] for name, card in _cards(graded)],
    }


def _cards(graded):
    """[(name, {property: text})] of all constituents."""
    solid = graded.Mesh.Shape
    owners = [owner for owner, _ in graded_parts(solid)] if solid is not None else []
    names = [(name, owner) for owner in owners for name in stored.texts(owner, "FGMConstituents")]
    return [(name, constituents.properties(name, owner.Document)) for name, owner in names]


def _numbers(card):
    return {name: constituents.number_in(card.get(name), unit) for name, unit in constituents.UNITS.items()}


def _same_cards(before, now, graded):
    """Numbers are compared, for each FreeCAD writes the same card with other digits and units."""
    if "properties" not in before:  # made by a FGMesh that kept a hash of the texts
        texts = [[name, sorted(card.items())] for name, card in _cards(graded)]
        return before.get("cards") == hashlib.sha256(repr(texts).encode()).hexdigest()
    old, new = before["properties"], now["properties"]
    return [name for name, _ in old] == [name for name, _ in new] and all(
        _same_number(was.get(name), value)
        for (_, was), (_, numbers) in zip(old, new)
        for name, value in numbers.items()
    )


def _same_number(before, now):
    if before is None or now is None:
        return before is now
    return math.isclose(before, now, rel_tol=_SAME)


def _one_for_each_region(fields, properties, laws):
    """As bins() gives them; a material for each region, with its mean properties, is where a solver begins that
    has the true ones from elsewhere."""
    first = fields.first_fractions()  # which refuses what it cannot tell
    numbers = np.empty(len(fields.tets), int)
    for number, region in enumerate(fields.regions):
        numbers[region.tets] = number
        at_nodes = first[fields.nodes_of(region)]
        region.properties(
            np.column_stack([at_nodes, 1 - at_nodes]), laws
        )  # which must have a meaning there, too
    counts = np.bincount(numbers)
    values = {name: np.bincount(numbers, weights=column) / counts for name, column in properties.items()}
    return Bins(numbers, values, 0.0)


def _materials(graded, count, group):
    """So many material objects in the group of `graded`: those that it has, more or fewer."""
    kept = [material for material in graded.Materials if material is not None]
    for material in kept[count:]:
        graded.Document.removeObject(material.Name)
    make = fem_module("ObjectsFem").makeMaterialSolid
    for number in range(len(kept) + 1, count + 1):
        # With zeros in front, so that names sort as numbers do.
        material = make(graded.Document, f"{graded.Name}_Bin{number:04}")
        if group is not None:
            group.addObject(material)
        if material.ViewObject is not None:
            material.ViewObject.ShowInTree = False  # hundreds would bury the rest
        kept.append(material)
    return kept[:count]


def _set_card(material, properties):
    card = {"Name": material.Name, "Father": constituents.MADE_BY_US}
    for name, value in properties.items():
        unit = constituents.UNITS[name]
        card[name] = f"{value:.13g} {unit}" if unit else f"{value:.13g}"
    material.Material = card


def _solid_names(solid):
    return tuple(f"Solid{number}" for number in range(1, len(solid.Shape.Solids) + 1))


def _set_groups(mesh, materials, members):
    """Gives the Fem mesh a group of volumes for each material, by which FreeCAD's writers find its elements.
    members: for each the 0-based elements."""
    fem_mesh = mesh.FemMesh.copy()
    names = [_GROUP.format(material.Name) for material in materials]
    prefix = materials[0].Name.rsplit("_Bin", 1)[0] + "_Bin"
    for group in fem_mesh.Groups:
        if fem_mesh.getGroupName(group).startswith(prefix):
            fem_mesh.removeGroup(group)
    for name, chosen in zip(names, members):
        fem_mesh.addGroupElements(fem_mesh.addGroup(name, "Volume"), (chosen + 1).tolist())
    mesh.FemMesh = fem_mesh
    mesh.Proxy.kept.keep(mesh.Fingerprint, fem_mesh)


def _add_missing_properties(graded):
    def add(kind, name, group, tip, *attributes):
        if name in graded.PropertiesList:
            return False
        graded.addProperty(kind, name, group, tip, *attributes)
        return True

    for name, kind, tip in _RESULTS:
        add(kind, name, "Results", tip, _OUTPUT)
        graded.setEditorMode(name, ["ReadOnly", "Hidden"] if name in _HIDDEN else ["ReadOnly"])
    add("App::PropertyLinkGlobal", "Mesh", "Grading", "The graded mesh")
    defaults = Request()
    if add("App::PropertyEnumeration", "Mode", "Grading", "How properties are told to the solver"):
        graded.Mode = MODES
        graded.Mode = defaults.mode
    if add("App::PropertyInteger", "Bins", "Grading", "Materials to make, where no error is allowed below"):
        graded.Bins = defaults.bins
    add(
        "App::PropertyFloat",
        "AllowedError",
        "Grading",
        "Relative error of the properties that bins may bring, which then decides how many there are; 0: Bins does",
    )
    for name in mixing.PROPERTIES:
        tip = f"Mixing law of {name}: {', '.join(mixing.laws_of(name))}, or a formula such as p1*v1 + p2*v2"
        add("App::PropertyString", _LAW.format(name), "Mixing", f"{tip}; empty: the usual one")
