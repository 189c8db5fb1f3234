# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing laws that users write as formulas. `core.Material` reads and evaluates them: nothing is run as code."""
import re

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.mixing.properties import PROPERTIES

_WORD = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|(?P<name>[A-Za-z_][A-Za-z0-9_]*)")
_NUMBERED = re.compile(rf"(v|p|{'|'.join(PROPERTIES)})([1-9]\d{{0,3}})")
_COORDINATE = re.compile(r"x|y|z|r|theta|d|[dst][1-9]\d*")
_HINT = re.compile(r"; a formula knows .*(?= \(character)|; did you mean '(x|y|z|r|theta|d)'\?", re.DOTALL)


class Formula:
    """A formula for the property `name` of a mixture. Immutable; `text` is as the user wrote it.

    Fractions are handed to the core as distances to references, which can be as many as there are constituents: v1
    is d1 there, so that all places in the text stay where they are. Raises core.FormulaError, whose message begins
    with the property and whose `position` is that in `text`.
    """

    def __init__(self, name, text):
        self.name, self.text = name, text
        words = [word for word in _WORD.finditer(text) if word["name"]]
        self._numbered = {}  # (kind, number): where it stands first
        for word in words:
            if _COORDINATE.fullmatch(word["name"]):
                raise self._fault(
                    f"a mixture depends on no place, so there is no {word['name']!r}: take the fractions v1 v2 ...",
                    word.start(),
                )
            numbered = _NUMBERED.fullmatch(word["name"])
            if numbered:
                self._numbered.setdefault((numbered[1], int(numbered[2])), word.start())
        self._material(2, dict.fromkeys(self._parameters(), 1.0))

    def __repr__(self):
        return f"Formula({self.name!r}, {self.text!r})"

    def check(self, constituents):
        """Raises core.FormulaError where it names a constituent that is none of so many."""
        for (kind, number), start in self._numbered.items():
            if number > constituents:
                raise self._fault(
                    f"'{kind}{number}' is of constituent {number}, but there are only {constituents}", start
                )

    def values(self, fractions, cards, within_range=True):
        """What it gives (n,) for fractions (n, k), which are not below zero; cards: the Cards of the constituents.

        Raises InvalidInput where a card lacks what the formula names, or, with within_range, where a value has no meaning
        for the property, with the fractions at the first such place.
        """
        self.check(fractions.shape[1])
        parameters = {}
        for parameter, (kind, number) in self._parameters().items():
            values = cards.of(kind, f"the formula of {self.name}", [number])
            parameters[parameter] = float(values[number - 1])
        material = self._material(fractions.shape[1], parameters)
        values = material.evaluate(np.zeros((len(fractions), 3)), fractions)[:, 0]
        wrong = np.flatnonzero(~PROPERTIES[self.name].holds(values))
        if within_range and len(wrong):
            place = ", ".join(f"v{number} = {v:.4g}" for number, v in enumerate(fractions[wrong[0]], 1))
            raise core.InvalidInput(
                f"{self.name}: the formula {self.text.strip()!r} gives {values[wrong[0]]:.6g} where {place}, "
                f"but must be {PROPERTIES[self.name].demand}: correct it"
            )
        return values

    def _parameters(self):
        """{name in the formula: (property, number)} but for the fractions."""
        return {
            f"{kind}{number}": (self.name if kind == "p" else kind, number)
            for kind, number in self._numbered
            if kind != "v"
        }

    def _material(self, constituents, parameters):
        count = max([constituents, *(number for _, number in self._numbered)])
        characters = list(self.text)
        for word in _WORD.finditer(self.text):
            if word["name"] and re.fullmatch(r"v[1-9]\d{0,3}", word["name"]):
                characters[word.start()] = "d"
        fractions = core.references(b"", [f"Face{number}" for number in range(1, count + 1)], read=False)
        try:
            return core.Material(["".join(characters)], parameters, references=fractions)
        except core.FormulaError as error:
            message = _HINT.sub("", str(error))
            if message.startswith("unknown"):
                known = (
                    f"v1 v2 ... (fractions), p1 p2 ... ({self.name} of the constituents), Density1 ..., pi e"
                )
                message = message.replace(
                    " (character", f"; a formula here knows {known} and functions (character"
                )
            raise self._error(re.sub(r"\bd([1-9]\d*)", r"v\1", message), error.position) from None

    def _fault(self, message, start):
        """A FormulaError at the character `start`, told as the core does, which counts bytes."""
        position = len(self.text[:start].encode())
        return self._error(f"{message} (character {position + 1})", position)

    def _error(self, message, position):
        error = core.FormulaError(f"{self.name}: {message}")
        error.formula, error.position = 0, position
        return error
