# SPDX-License-Identifier: GPL-3.0-or-later
"""A graded material that is being written: what a panel shows, checks, and turns into lines of a macro.

Nothing of it is in the document before the lines are run.
"""
from dataclasses import dataclass, field

import FreeCAD

from freecad.fgmesh import core
from freecad.fgmesh.model import graded_solid, references, stored
from freecad.fgmesh.model.macro_text import object_text, placement_text


LONGEST_RECORDED = 10_000
"""Characters of a table that a line of a macro holds itself."""


@dataclass
class MaterialDraft:
    """As the arguments of attach_material(), with parameters as texts: a number, a number with a unit, or an
    expression of FreeCAD's."""

    constituents: list = field(default_factory=list)
    fractions: list = field(default_factory=lambda: [""])
    parameters: dict = field(default_factory=dict)
    frame: FreeCAD.Placement = field(default_factory=FreeCAD.Placement)
    references: list = field(default_factory=list)  # (object, name of a part or "")
    tables: list = field(default_factory=list)  # texts
    table_files: dict = field(default_factory=dict, compare=False)  # {text: path that it was read from}

    @classmethod
    def of(cls, solid):
        """That of the material which `solid` has; an empty one where it has none."""
        if not graded_solid.has_material(solid):
            return cls()
        # The expressions of what a link leads to would have another meaning on the link.
        driven = dict(solid.ExpressionEngine) if graded_solid.holder(solid) == solid else {}
        prefix = graded_solid.PARAMETER_PREFIX
        values = graded_solid.parameters_of(solid).items()
        return cls(
            stored.texts(solid, "FGMConstituents"),
            stored.texts(solid, "FGMFractions"),
            {name: driven.get(prefix + name, f"{value:.15g}") for name, value in values},
            FreeCAD.Placement(stored.placement(solid, "FGMFrame")),
            references.stored_links(solid),
            graded_solid.tables_of(solid),
        )

    def values(self, solid):
        """{name: number} of the parameters. Raises core.InvalidInput that names the one which is none."""
        return {name: parameter_value(solid, name, text) for name, text in self.parameters.items()}

    def material(self, solid):
        """The core.Material in the coordinates of solid.Shape, its references not read. Raises core.InvalidInput."""
        return graded_solid.draft_material(
            solid, self.fractions, self.values(solid), self.frame, self.references, self.tables
        )

    def script(self, solid):
        """Lines of Python that give the material to `solid`, for FreeCAD's console and macros."""
        thing = object_text(solid)
        values = self.values(solid)
        driven = {name: text for name, text in self.parameters.items() if constant(name, text) is None}
        arguments = [f"fractions={self.fractions!r}"]
        if values:
            arguments.append(f"parameters={values!r}")
        if any(self.constituents):
            arguments.append(f"constituents={self.constituents!r}")
        if not self.frame.isIdentity():
            arguments.append(f"frame={placement_text(self.frame)}")
        if self.references:
            pairs = ", ".join(f"({object_text(thing)}, {name!r})" for thing, name in self.references)
            arguments.append(f"references=[{pairs}]")
        if self.tables:
            arguments.append(f"tables=[{', '.join(self._table_text(text, solid) for text in self.tables)}]")
        yield f"freecad.fgmesh.attach_material({thing}, {', '.join(arguments)})"
        for name, text in driven.items():
            yield f"{thing}.setExpression({graded_solid.PARAMETER_PREFIX + name!r}, {text!r})"

    def _table_text(self, text, solid):
        """Python text that gives a table: itself, so that a macro needs no file; but FreeCAD's console would stumble
        over a long one, which is taken from the solid that has it, or from its file."""
        kept = graded_solid.tables_of(solid)
        if len(text) > LONGEST_RECORDED:
            if text in kept:
                return f"{object_text(solid)}.FGMTables[{kept.index(text)}]"
            if text in self.table_files:
                return repr(self.table_files[text])
        return repr(text)


def parameter_value(solid, name, text):
    """The number that `text` stands for in FreeCAD's units (mm), angles in radians."""
    return parameter_quantity(solid, name, text)[0]


def parameter_quantity(solid, name, text):
    """(parameter_value(), whether it is a length)."""
    value = constant(name, text)
    if value is not None:
        return value, FreeCAD.Units.Quantity(text).Unit == FreeCAD.Units.Length
    try:
        result = solid.evalExpression(text)
    except Exception as error:  # the parser's and the evaluator's own kinds
        said = error.args[0] if error.args else ""
        reason = said.get("sErrMsg", "") if isinstance(said, dict) else str(said)
        raise core.InvalidInput(
            f"the parameter {name}: {text!r} is neither a number nor an expression ({reason})"
        ) from None
    if isinstance(result, FreeCAD.Units.Quantity) and result.Unit == FreeCAD.Units.Angle:
        raise core.InvalidInput(
            f"the parameter {name}: {text!r} is an angle, and formulas take radians: divide it by 1 rad"
        )
    return graded_solid.plain_number(result), getattr(result, "Unit", None) == FreeCAD.Units.Length


def constant(name, text):
    """The number that `text` writes, with or without a unit; None where it is an expression."""
    if not text.strip():
        raise core.InvalidInput(f"the parameter {name} has no value: give it a number or an expression")
    try:
        quantity = FreeCAD.Units.Quantity(text)
    except Exception:  # FreeCAD's parser of quantities knows many
        return None
    if quantity.Unit == FreeCAD.Units.Angle:
        return float(quantity.getValueAs("rad"))
    return float(quantity.Value)
