# SPDX-License-Identifier: GPL-3.0-or-later
"""Constraints and loads of an analysis, looked at before CalculiX runs: it solves to nonsense, or to nothing, what acts on no
node, what acts on a part that is not meshed, and what has no load."""
import re

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.fem.fem_mesh import points_and_tets
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

_MAY_HOLD = {"Fem::ConstraintContact", "Fem::ConstraintSpring"}
"""Kinds of those that hold a body, too."""

_WITHOUT_PARTS = {"Fem::ConstraintSelfWeight", "Fem::ConstraintInitialTemperature"}
"""Kinds that act on all of the mesh."""

_ANYWHERE = ("Face", "Edge", "Vertex")
_PARTS = {
    "Fem::ConstraintFixed": _ANYWHERE,
    "Fem::ConstraintDisplacement": _ANYWHERE,
    "Fem::ConstraintForce": _ANYWHERE,
    "Fem::ConstraintTemperature": _ANYWHERE,
    "Fem::ConstraintPressure": ("Face",),
    "Fem::ConstraintHeatflux": ("Face",),
}
"""What FreeCAD finds nodes for, for a kind of constraint."""

_HOLDING = {"Fem::ConstraintFixed", "Fem::ConstraintDisplacement"}
_LEAST = 1e-6
"""Singular value, of the motions that are held, that counts as none."""

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


def check_held(analysis, kind):
    """Raises core.InvalidInput where the body of `analysis`, of the kind "static", can still move or turn as a whole: then
    CalculiX gives displacements without a bound.

    Looked at are constraints that hold nodes along the axes; where there are others, nothing is said.
    """
    mesh = next(filter(is_mesh, analysis.Group), None)
    constraints = _constraints(analysis)
    others = {_kind(one) for one in analysis.Group if "Constraint" in _kind(one)} - _HOLDING - _LOADS
    if kind != "static" or mesh is None or others or any(_kind(one) in _MAY_HOLD for one in constraints):
        return
    points, _ = points_and_tets(mesh.FemMesh)
    points = (points - points.mean(axis=0)) / np.ptp(points, axis=0).max()
    rows = [np.zeros((1, 6))]
    for constraint in constraints:
        if _kind(constraint) in _HOLDING:
            nodes = np.unique(_nodes_of(constraint, mesh)).astype(int) - 1
            rows += [_motion(points[nodes], axis) for axis in range(3) if _holds(constraint, "xyz"[axis])]
    rows = np.concatenate(rows)
    held = int((np.linalg.svd(rows.T @ rows, compute_uv=False) > _LEAST).sum())
    if held < 6:
        raise core.InvalidInput(
            f"{analysis.Label} holds {held} of the 6 ways in which {mesh.Shape.Label} can move and turn as a whole, so that "
            "it has no displacements: add a fixed constraint, or displacements of 0 that hold the others"
        )


def _motion(points, axis):
    """(n, 6): what three translations and three small rotations move each of `points` (n, 3) by along an axis."""
    x, y, z = points.T
    zero, one = np.zeros(len(points)), np.ones(len(points))
    turned = ((zero, z, -y), (-z, zero, x), (y, -x, zero))[axis]
    return np.column_stack([one if axis == other else zero for other in range(3)] + list(turned))


def _holds(constraint, axis):
    if _kind(constraint) == "Fem::ConstraintFixed":
        return True
    return getattr(constraint, f"{axis}Fix", False) or not getattr(constraint, f"{axis}Free", True)


def _nodes_of(constraint, mesh):
    """Numbers of the nodes of the Fem mesh that FreeCAD finds for a constraint."""
    groups = _own_groups(constraint, mesh)
    if groups:
        return [node for group in groups for node in mesh.FemMesh.getGroupElements(group)]
    return [
        node
        for thing, names in constraint.References
        for name in names
        for node in _find_nodes(mesh, _part_of(constraint, thing, name))
    ]


def _own_groups(constraint, mesh):
    """Groups of the Fem mesh that FreeCAD takes for the nodes of a constraint, wherever they are."""
    fem_mesh = mesh.FemMesh
    return [one for one in fem_mesh.Groups if fem_mesh.getGroupName(one).startswith(f"{constraint.Name}_")]


def _find_nodes(mesh, part):
    return getattr(mesh.FemMesh, f"getNodesBy{part.ShapeType}")(part)


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
    if _own_groups(constraint, mesh):
        return
    for thing, name in parts:
        _check_part(constraint, thing, name, mesh)


def _check_part(constraint, thing, name, mesh):
    part = _part_of(constraint, thing, name)
    allowed = _PARTS.get(_kind(constraint))
    if allowed and part.ShapeType not in allowed:
        raise core.InvalidInput(
            f"{constraint.Label} acts on {name} of {thing.Label}, but can act on {' or '.join(allowed)} alone: choose such"
        )
    if not _find_nodes(mesh, part):
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
