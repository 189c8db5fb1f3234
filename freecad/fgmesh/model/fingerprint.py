# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells whether a mesh still belongs to its solid, material and options.

A fingerprint is a small dictionary, kept in the document as JSON, of all that the mesh was made from. Numbers
are kept as they are, so that a later comparison can say which of them changed.
"""
import hashlib
import math

import FreeCAD

from freecad.fgmesh.model import graded_solid, references, stored
from freecad.fgmesh.model.graded_parts import graded_parts
from freecad.fgmesh.model.options import shaping_values

_SAVED_DIGITS = 1e-12  # numbers come back from a saved document with other last digits
_SHAPE_DIGITS = 7  # of the part's size: far more than a mesh resolves, far fewer than OpenCASCADE computes


def take(solid, values):
    """The fingerprint of what a mesh of `solid`, None where it was deleted, with these option values
    (`options.option_values`) would be made from at this moment."""
    options = shaping_values(values)
    if solid is None:
        return {"shape": None, "options": options}
    return {
        "shape": _shape_hash(solid.Shape),
        "placement": _numbers(solid.Placement),
        **_material(solid),
        "parts": [
            {"name": part.Name, "placement": _numbers(part.Placement), **_material(part)}
            for part, _ in graded_parts(solid)
            if part not in (solid, graded_solid.holder(solid))
        ],
        "options": options,
    }


def _material(solid):
    return {
        "fractions": stored.texts(solid, "FGMFractions"),
        "parameters": graded_solid.parameters_of(solid),
        "frame": _numbers(stored.placement(solid, "FGMFrame")),
        "references": references.fingerprint(solid, _shape_hash, _numbers),
        "tables": [hashlib.sha256(text.encode()).hexdigest() for text in graded_solid.tables_of(solid)],
    }


def changes(before, now):
    """What differs between two fingerprints, as a list of short texts: empty where the mesh is up to date."""
    if now["shape"] is None:
        return ["the solid is gone"]
    found = []
    if before["shape"] != now["shape"]:
        found.append("the solid has another shape")
    if not _same(before["placement"], now["placement"]):
        found.append("the solid was moved")
    found += _changed_material(before, now)
    found += _changed_parts(before.get("parts", []), now["parts"])
    found += _changed_values(before["options"], now["options"], "")
    return found


def _changed_material(before, now):
    found = []
    if before["fractions"] != now["fractions"]:
        found.append("the material has another formula")
    if not _same(before["frame"], now["frame"]):
        found.append("the material's frame was moved")
    found += _changed_references(before.get("references", []), now["references"])
    found += _changed_tables(before.get("tables", []), now["tables"])
    return found + _changed_values(before["parameters"], now["parameters"], graded_solid.PARAMETER_PREFIX)


def _changed_parts(before, now):
    if [part["name"] for part in before] != [part["name"] for part in now]:
        return ["other parts of the shape have materials"]
    found = []
    for old, new in zip(before, now):
        changed = _changed_material(old, new)
        if not _same(old["placement"], new["placement"]):
            changed.append("it was moved")
        found += [f"{new['name']}: {change}" for change in changed]
    return found


def _changed_references(before, now):
    if [entry["name"] for entry in before] != [entry["name"] for entry in now]:
        return ["the material has other references"]
    return [
        f"the reference {old['name']} was changed"
        for old, new in zip(before, now)
        if "shape" in old and (old["shape"] != new["shape"] or not _same(old["placement"], new["placement"]))
    ]


def _changed_tables(before, now):
    if len(before) != len(now):
        return ["the material has other tables"]
    return [f"the table t{n} was changed" for n, (old, new) in enumerate(zip(before, now), 1) if old != new]


def _changed_values(before, now, prefix):
    # A name on one side only belongs to another version of this workbench, or to a parameter that comes and
    # goes with its formula, which is compared by itself.
    return [
        f"{prefix}{name} was {_show(before[name])}, is {_show(now[name])}"
        for name in sorted(before.keys() & now.keys())
        if not _equal(before[name], now[name])
    ]


def _equal(before, now):
    if isinstance(before, float):
        return math.isclose(before, now, rel_tol=_SAVED_DIGITS)
    return before == now


def _show(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


_hashes = []
"""(shape, hash) of the latest shapes, the last one last. The shapes are held, so that no other takes their place."""
_MOST_HASHES = 16


def _shape_hash(shape):
    """_computed_hash() of `shape`, computed once for each: it is asked for with every change of a property."""
    if shape.isNull():
        return ""
    for known, found in _hashes:
        if known.isPartner(shape):  # the hash does not depend on where it stands
            return found
    _hashes.append((shape, _computed_hash(shape)))
    del _hashes[:-_MOST_HASHES]
    return _hashes[-1][1]


def _computed_hash(shape):
    """Hash of the sizes and centres of all faces and edges, in their order, in the solid's own coordinates.

    A hash of the BREP text would tell more than is true: computed again after reopening, the same solid has
    other tolerances, other flags, and circles that start elsewhere.
    """
    if not shape.Faces:
        return ""
    local = shape.copy(False)
    local.Placement = FreeCAD.Placement()
    size = math.sqrt(local.Area)
    figures = [(face.Area / size**2, *(face.CenterOfMass / size)) for face in local.Faces]
    figures += [
        (edge.Length / size, *(edge.CenterOfMass / size)) for edge in local.Edges if not edge.Degenerated
    ]
    # + 0.0 turns -0.0 into 0.0
    rounded = [
        [round(figure, _SHAPE_DIGITS) + 0.0 for figure in row] for row in [(math.log(size),), *figures]
    ]
    return hashlib.sha256(repr(rounded).encode()).hexdigest()


def _numbers(placement):
    return {"base": list(placement.Base), "rotation": list(placement.Rotation.Q)}


def _same(before, now):
    return all(_near(before[part], now[part]) for part in ("base", "rotation"))


def _near(before, now):
    # Infinite numbers are as far from each other as from all others.
    distance, size = math.dist(before, now), max(math.hypot(*before), math.hypot(*now))
    return before == now or math.isfinite(size) and distance <= _SAVED_DIGITS * size
