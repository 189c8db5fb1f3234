# SPDX-License-Identifier: GPL-3.0-or-later
"""The material that a command line tells: options, a JSON file, or both."""
import json
import math
from pathlib import Path

from freecad.fgmesh import core, input_file
from freecad.fgmesh.cli.arguments import shortened

LARGEST_FILE = 2 * 1024 * 1024
"""Bytes. A formula has at most some thousand characters: a larger file is no material."""

KEYS = ("fractions", "parameters", "origin", "axis", "references", "tables")


def read_materials(arguments, shape, control):
    """The Materials of the parsed `arguments`, one for all solids or one for each, with references to parts of
    the `shape` (bytes).

    The shape is not looked at: whether it has these parts shows when it is meshed. `control` (RunControl) is looked at
    while files are read. Raises core.InvalidInput, FormulaError included, and core.Cancelled.
    """
    return [_material(values, shape, control) for values in material_values(arguments, control)]


def _material(values, shape, control):
    fractions = values["fractions"]
    rotation = core.frame_rotation(values.get("axis", (0.0, 0.0, 1.0)))
    names = values.get("references", [])
    references = core.references(shape, names, read=False) if names else []
    paths = enumerate(values.get("tables", []), 1)
    tables = [core.read_table(path, f"table t{number}", control) for number, path in paths]
    origin = values.get("origin", (0.0, 0.0, 0.0))
    try:
        return core.Material(fractions, values["parameters"], origin, rotation, references, tables=tables)
    except core.FormulaError as error:
        shown, caret = core.caret_excerpt(fractions[error.formula], error.position).split("\n")
        raise core.InvalidInput(f"{error}\n  {shown}\n  {caret}") from error


def material_values(arguments, control=None):
    """The plain values of each material: fractions, parameters and, where given, origin, axis, references
    and the paths of tables.
    What options tell holds for all."""
    if arguments.material and arguments.fraction:
        raise core.InvalidInput("--fraction and --material both tell the formula: give one of them")
    if not arguments.material and not arguments.fraction:
        raise core.InvalidInput("no material: give --fraction FORMULA or --material FILE.json")
    materials = [read_material_file(path, control) for path in arguments.material] or [
        {"fractions": arguments.fraction}
    ]
    given = {}
    for name, value in arguments.param:
        if name in given:
            raise core.InvalidInput(f"--param {shortened(name)} is given twice")
        given[name] = value
    for values in materials:
        if not values["fractions"]:
            raise core.InvalidInput("no material: give --fraction FORMULA or --material FILE.json")
        values["parameters"] = {**values.get("parameters", {}), **given}
        for key in ("origin", "axis"):
            if getattr(arguments, key) is not None:
                values[key] = getattr(arguments, key)
        if arguments.reference:
            values["references"] = arguments.reference
        if arguments.table:
            values["tables"] = [Path(name) for name in arguments.table]
    return materials


def read_material_file(path, control=None):
    """The checked content of a material file. Raises core.InvalidInput, core.Cancelled."""
    try:
        content = input_file.read(path, LARGEST_FILE, control)
    except core.InvalidInput as error:
        raise core.InvalidInput(f"cannot read the material file {path!r}: {error}") from None
    try:
        values = _checked(_parsed(content))
    except (ValueError, RecursionError, OverflowError) as error:
        reason = "it is nested too deeply" if isinstance(error, RecursionError) else error
        raise core.InvalidInput(f"material file {path!r}: {reason}") from None
    if "tables" in values:
        values["tables"] = [Path(path).parent / name for name in values["tables"]]
    return values


def _parsed(content):
    def constant(name):
        raise ValueError(f"{name} is no number")

    def without_doubles(pairs):
        values = {}
        for key, value in pairs:
            if key in values:
                raise ValueError(f"{shortened(key)} stands there twice")
            values[key] = value
        return values

    return json.loads(content, parse_constant=constant, object_pairs_hook=without_doubles)


def _checked(values):
    if not isinstance(values, dict) or "fractions" not in values:
        raise ValueError('it must be an object with the key "fractions"')
    for key in values:
        if key not in KEYS:
            raise ValueError(f"the key {shortened(key)} is unknown; known are {', '.join(KEYS)}")
    fractions, parameters = values["fractions"], values.get("parameters", {})
    if not isinstance(fractions, list) or not all(isinstance(formula, str) for formula in fractions):
        raise ValueError('"fractions" must be a list of texts')
    if not isinstance(parameters, dict):
        raise ValueError('"parameters" must be an object of numbers')
    checked = {
        "fractions": fractions,
        "parameters": {name: _finite(value, name) for name, value in parameters.items()},
    }
    for key in ("references", "tables"):
        if key in values:
            checked[key] = values[key]
            if not isinstance(values[key], list) or not all(isinstance(name, str) for name in values[key]):
                raise ValueError(f'"{key}" must be a list of texts')
    for key in ("origin", "axis"):
        if key in values:
            if not isinstance(values[key], list) or len(values[key]) != 3:
                raise ValueError(f'"{key}" must be a list of three numbers')
            checked[key] = tuple(_finite(value, key) for value in values[key])
    return checked


def _finite(value, name):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(float(value)):
        raise ValueError(f"the value of {shortened(name)} is no finite number")
    return float(value)
