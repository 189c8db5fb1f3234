# SPDX-License-Identifier: GPL-3.0-or-later
"""Effective properties of a mixture of constituents, from their volume fractions. Needs neither FreeCAD nor Qt.

    from freecad.fgmesh import mixing
    laws = mixing.read_laws({"YoungsModulus": "mori_tanaka", "Density": "p1 + (p2 - p1)*v2^2"})
    cards = {"YoungsModulus": (70000, 380000), "PoissonRatio": (0.33, 0.22)}
    values = mixing.mixed(fractions, cards, laws, wanted=("YoungsModulus", "PoissonRatio"))

Properties bear the names of FreeCAD's material cards. Each has a law: one of `LAWS`, of which `laws_of` tells those
that are for a property, or a formula over v1 v2 ... (fractions), p1 p2 ... (that property of the constituents),
Density1 ... (any other property of theirs), pi, e and the functions of the formulas of materials. Constituents are
numbered from 1. Formulas are never run as code.
"""
from freecad.fgmesh.mixing.formula import Formula
from freecad.fgmesh.mixing.laws import LAWS, Law, laws_of, read_laws
from freecad.fgmesh.mixing.mixed import mixed
from freecad.fgmesh.mixing.properties import PROPERTIES

__all__ = ["LAWS", "PROPERTIES", "Formula", "Law", "laws_of", "mixed", "read_laws"]
