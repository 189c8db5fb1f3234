# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured: five graded solids, simple enough to be told in a line each. Lengths in mm."""
import runpy
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402,F401  Part crashes where it is loaded first
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"


@dataclass(frozen=True)
class Case:
    """A solid with its material, told once for each who reads it, so that none checks itself."""

    name: str
    build: Callable  # () -> Part.Shape
    formula: str  # f as FGMesh reads it
    fraction: Callable  # f for the check: (x, y, z) arrays -> array
    slope: str  # |grad f|, 1/mm: text that both gmsh's MathEval and Python read

    def slope_at(self, points):
        """|grad f| at points (n, 3); (n,), 1/mm."""
        x, y, z = np.asarray(points).T
        names = {"exp": np.exp, "sqrt": np.sqrt, "tanh": np.tanh, "x": x, "y": y, "z": z}
        return np.broadcast_to(eval(self.slope, {"__builtins__": {}}, names), x.shape)

    def fraction_at(self, points):
        """f at points (n, 3); (n,)."""
        return self.fraction(*np.asarray(points).T)


def ball():
    return Part.makeSphere(50)


def cylinder():
    return Part.makeCylinder(20, 60)


def block():
    box = Part.makeBox(60, 40, 30, Vector(-30, -20, -15))
    return box.cut(Part.makeCylinder(8, 30, Vector(15, 0, -15)))


def tube():
    return Part.makeCylinder(40, 10).cut(Part.makeCylinder(20, 10))


def bracket():
    """Where along the foot the hole is (x = 55) is an assumption of this file."""
    angle = Part.makeBox(80, 40, 10).fuse(Part.makeBox(10, 40, 60)).removeSplitter()
    inner = [
        edge
        for edge in angle.Edges
        if all((v.Point - Vector(10, v.Y, 10)).Length < 1e-6 for v in edge.Vertexes)
    ]
    return angle.makeFillet(8, inner).cut(Part.makeCylinder(7, 10, Vector(55, 20, 0)))


CASES = (
    Case(
        "ball-exp",
        ball,
        "exp(-0.08*d)",
        lambda x, y, z: np.exp(-0.08 * np.sqrt(x * x + y * y + z * z)),
        "0.08*exp(-0.08*sqrt(x*x+y*y+z*z))",
    ),
    Case(
        "cylinder-power",
        cylinder,
        "(z/60)^3",
        lambda x, y, z: (z / 60) ** 3,
        "3*z*z/216000",
    ),
    Case(
        "block-exp",
        block,
        "exp(-0.1*d)",
        lambda x, y, z: np.exp(-0.1 * np.sqrt(x * x + y * y + z * z)),
        "0.1*exp(-0.1*sqrt(x*x+y*y+z*z))",
    ),
    Case(
        "tube-linear",
        tube,
        "(r-20)/20",
        # Fractions are within [0, 1]: between a facet and the curved wall r falls below 20.
        lambda x, y, z: np.clip((np.hypot(x, y) - 20) / 20, 0, 1),
        "0.05",
    ),
    Case(
        "bracket-tanh",
        bracket,
        "0.5+0.5*tanh((x-z)/10)",
        lambda x, y, z: 0.5 + 0.5 * np.tanh((x - z) / 10),
        "0.05*sqrt(2)*(1-tanh((x-z)/10)*tanh((x-z)/10))",
    ),
)
BY_NAME = {case.name: case for case in CASES}
STUDIES = {"case_study_1": BY_NAME["ball-exp"], "case_study_2": BY_NAME["cylinder-power"]}
"""Each of the examples' case studies, and the case that has the same solid and material."""


def build_study(name):
    """The mesh object, not meshed yet, of examples/<name>.py in a new FreeCAD document."""
    return runpy.run_path(str(EXAMPLES / f"{name}.py"))["build"]()
