# SPDX-License-Identifier: GPL-3.0-or-later
"""The mixing laws by name, which property they are for, and how the texts of users become laws."""
import difflib
import math
import re
from typing import NamedTuple, Optional

from freecad.fgmesh import core
from freecad.fgmesh.mixing import elastic
from freecad.fgmesh.mixing.formula import Formula
from freecad.fgmesh.mixing.properties import PROPERTIES, check_name


class Kind(NamedTuple):
    """What is known of a law: a description for menus, its properties, what stands in its parentheses ("" where
    nothing does)."""

    description: str
    properties: tuple
    argument: str = ""


_ELASTIC = ("YoungsModulus", "PoissonRatio")
_SPHERES = (*_ELASTIC, "ThermalConductivity", "ThermalExpansionCoefficient")
_SERIES = (*_ELASTIC, "ThermalConductivity", "YieldStrength")

LAWS = {
    "voigt": Kind("arithmetic mean (rule of mixtures, parallel)", tuple(PROPERTIES)),
    "reuss": Kind("harmonic mean (series)", _SERIES),
    "hill": Kind("half Voigt, half Reuss", _SERIES),
    "hashin_shtrikman_lower": Kind("lower bound of Hashin and Shtrikman", _SPHERES),
    "hashin_shtrikman_upper": Kind("upper bound of Hashin and Shtrikman", _SPHERES),
    "mori_tanaka": Kind(
        "spheres in a matrix, the last constituent unless named by number", _SPHERES, "matrix"
    ),
    "self_consistent": Kind("grains of all constituents in the mixture itself", _SPHERES),
    "tamura": Kind("two constituents with the stress transfer q, a stress", ("YoungsModulus",), "q"),
    "by_mass": Kind("mean weighted with the masses", ("SpecificHeat",)),
}
"""{name: Kind}, in the order for menus."""

_CALL = re.compile(r"\s*([A-Za-z][A-Za-z_\s-]*?)\s*(?:\((.*)\))?\s*", re.DOTALL)


class Law(NamedTuple):
    """The law `name` of `LAWS` for a property, with the number in its parentheses, None where there is none."""

    property: str
    name: str
    number: Optional[float] = None

    @property
    def matrix(self):
        """The index of the constituent that is the matrix."""
        return -1 if self.number is None else int(self.number) - 1

    def check(self, constituents):
        """Raises InvalidInput where it has no meaning for so many constituents."""
        if self.name == "tamura" and constituents != 2:
            raise core.InvalidInput(
                f"{self.property}: Tamura's law is for two constituents, not {constituents}: choose another law"
            )
        if self.name == "mori_tanaka" and self.matrix >= constituents:
            raise core.InvalidInput(
                f"{self.property}: the matrix of mori_tanaka({self.matrix + 1}) is none of the {constituents} "
                f"constituents: take a number from 1 to {constituents}"
            )


def laws_of(name):
    """Names of the laws that are for the property `name`, in order. Raises InvalidInput where it is none."""
    check_name(name)
    return tuple(law for law, kind in LAWS.items() if name in kind.properties)


def read_laws(texts, constituents=None):
    """{property: Law or Formula} for every property, from {property: text}.

    A text is the name of a law, `mori_tanaka(1)` and `tamura(4500)` with a number, or a formula. What has no text,
    None or blanks has its default: by_mass for SpecificHeat; for PoissonRatio the law of YoungsModulus where that
    works on bulk and shear moduli, so that both come from one; else voigt. constituents: their number, where laws
    and formulas are to be checked for it already, as `mixed` does.

    Raises InvalidInput that names the property, the text and the cure; for a formula it is a core.FormulaError with
    the position in the text.
    """
    for name in texts:
        check_name(name)
    laws = {name: _read(name, texts.get(name)) for name in PROPERTIES}
    if _is_blank(texts.get("PoissonRatio")) and getattr(laws["YoungsModulus"], "name", "") in elastic.LAWS:
        laws["PoissonRatio"] = laws["YoungsModulus"]._replace(property="PoissonRatio")
    for law in laws.values() if constituents else ():
        law.check(constituents)
    return laws


def _is_blank(text):
    return text is None or (isinstance(text, str) and not text.strip())


def _read(name, text):
    if _is_blank(text):
        return Law(name, PROPERTIES[name].default)
    if not isinstance(text, str):
        raise core.InvalidInput(f"{name}: a law is a text, not {text!r}: write one of {_choice(name)}")
    call = _CALL.fullmatch(text)
    law = re.sub(r"[\s_-]+", "_", call[1]).lower() if call else ""
    if law in LAWS:
        if name not in LAWS[law].properties:
            raise core.InvalidInput(f"{name}: {law!r} is no law for it: write {_choice(name)}")
        return Law(name, law, _number(name, text, law, call[2]))
    if re.fullmatch(r"\s*[A-Za-z][A-Za-z_-]{2,}\s*", text):
        near = difflib.get_close_matches(law, laws_of(name), 1)
        meant = f"did you mean {near[0]}? Write" if near else "write"
        raise core.InvalidInput(f"{name}: there is no law {text.strip()!r}: {meant} {_choice(name)}")
    return Formula(name, text)


def _choice(name):
    """The laws of a property, for a message."""
    return f"{', '.join(laws_of(name))}, or a formula such as p1*v1 + p2*v2"


def _number(name, text, law, argument):
    """What stands in the parentheses of a law."""
    text, wanted = text.strip(), LAWS[law].argument
    if not wanted:
        if argument is not None:
            raise core.InvalidInput(f"{name}: {law} takes no number: write {law} in place of {text!r}")
        return None
    if argument is None and law == "mori_tanaka":
        return None
    try:
        number = float(argument)
    except (TypeError, ValueError):
        number = math.nan
    if law == "tamura" and not 0 <= number < math.inf:
        raise core.InvalidInput(
            f"{name}: {text!r} lacks its stress transfer q: write a number of at least 0 in the unit of "
            "YoungsModulus, as in tamura(4500)"
        )
    if law == "mori_tanaka" and not (number >= 1 and number.is_integer()):
        raise core.InvalidInput(
            f"{name}: {text!r} names no matrix: write the number of a constituent, as in mori_tanaka(1)"
        )
    return number
