# SPDX-License-Identifier: GPL-3.0-or-later
"""Constraints and loads of an analysis, looked at before CalculiX runs: it solves to nonsense, or to nothing, what acts on no
node, what acts on a part that is not meshed, and what has no load."""
import re

from freecad.fgmesh import core
from freecad.fgmesh.model.mesh_object import is_mesh

_PLURALS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes", "Solid": "Solids"}

_LOADS = {
    *(
        "Fem::ConstraintForce",
        "Fem::ConstraintPressure",
        "Fem::ConstraintSelfWeight",
        "Fem::ConstraintCentrif",
    ),
    *("Fem::ConstraintContact", "Fem::ConstraintSpring", "Fem::ConstraintBodyHeatSource"),
    *("Fem::ConstraintTemperature", "Fem::ConstraintHeatflux"),
}
"""Kinds of what loads a body, or might."""

_WITHOUT_PARTS = {"Fem::ConstraintSelfWeight", "Fem::ConstraintInitialTemperature"}
"""Kinds that act on all of the mesh."""

_AMOUNTS = {"Fem::ConstraintForce": "Force", "Fem::ConstraintPressure": "Pressure"}
"""The property that says how much there is of a load."""


def check_constraints(analysis):
    """Raises core.InvalidInput for the first constraint of `analysis` that acts on nothing in its graded mesh."""
    mesh = next(filter(is_mesh, analysis.Group), None)
    for constraint in _constraints(analysis) if mesh else []:
        _check_parts(constraint, mesh)


def check_loads(analysis, kind):
    """Raises core.InvalidInput where `analysis`, of the kind "static", has no load."""
    if kind == "static" and not any(map(_is_load, _constraints(analysis))):
        raise core.InvalidInput(
            f"{analysis.Label} has no load, so that nothing would move: add a force, a pressure, a displacement or the "
            "self-weight, none of them zero"
        )


def _constraints(analysis):
    """Those that count, of FreeCAD's C++ and of its Python."""
    found = [
        thing for thing in analysis.Group if thing.isDerivedFrom("Fem::Constraint") or _kind(thing) in _LOADS
    ]
    return [one for one in found if not getattr(one, "Suppressed", False)]


def _kind(thing):
    return getattr(getattr(thing, "Proxy", None), "Type", "") or thing.TypeId


def _check_parts(constraint, mesh):
    if _kind(constraint) in _WITHOUT_PARTS:
        return
    parts = [
        (thing, name) for thing, names in getattr(constraint, "References", []) for name in names if name
    ]
    if not parts:
        raise core.InvalidInput(f"{constraint.Label} acts on nothing: give it faces, edges or vertices")
    groups = [mesh.FemMesh.getGroupName(group) for group in mesh.FemMesh.Groups]
    if any(name.startswith(f"{constraint.Name}_") for name in groups):
        return  # FreeCAD takes these nodes, wherever they are
    for thing, name in parts:
        _check_part(constraint, thing, name, mesh)


def _check_part(constraint, thing, name, mesh):
    part = _part_of(constraint, thing, name)
    find = getattr(mesh.FemMesh, f"getNodesBy{part.ShapeType}", None)
    if find is not None and not find(part):
        raise core.InvalidInput(
            f"{constraint.Label} acts on {name} of {thing.Label}, where {mesh.Label} has no nodes: choose a part of "
            f"{mesh.Shape.Label if mesh.Shape else 'the meshed solid'} where that stands, or mesh {thing.Label} with it"
        )


def _part_of(constraint, thing, name):
    """The face, edge, vertex or solid, where FreeCAD looks for nodes."""
    match = re.fullmatch(r"(?:.*\.)?(Face|Edge|Vertex|Solid)([1-9]\d{0,8})", name)
    shape = getattr(thing, "Shape", None)
    found = getattr(shape, _PLURALS[match[1]], []) if match else []
    if not match or int(match[2]) > len(found):
        raise core.InvalidInput(
            f"{constraint.Label} acts on {name}, which {thing.Label} does not have: choose it anew"
        )
    return found[int(match[2]) - 1]


def _is_load(constraint):
    kind = _kind(constraint)
    if kind in _AMOUNTS:
        return _number(getattr(constraint, _AMOUNTS[kind], 1.0)) != 0
    if kind in _LOADS:
        return True
    # A displacement that is given, and not zero.
    moved = [
        name for name in constraint.PropertiesList if re.fullmatch(r"[xyz](Displacement|Rotation)", name)
    ]
    told = [name for name in constraint.PropertiesList if re.fullmatch(r"(has|use).*Formula", name)]
    return any(_number(getattr(constraint, name)) for name in moved) or any(
        getattr(constraint, name) is True for name in told
    )


def _number(value):
    return float(getattr(value, "Value", value))
