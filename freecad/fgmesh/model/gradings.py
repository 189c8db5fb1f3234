# SPDX-License-Identifier: GPL-3.0-or-later
"""Ready gradings: formulas with parameters that fit a given solid, to start from.

Each has x y z r theta d of the material's frame; parameters begin with the sizes of the solid in that frame.
"""
import re
from typing import Callable, NamedTuple

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.model.shapes import brep_text
from freecad.fgmesh.model.texts import TRANSLATE_LATER

_ENOUGH = 3e-3
"""Of the largest size: lengths that differ by less are taken for the same."""


_DIMENSIONS = {
    **dict.fromkeys(("start", "length", "radius", "middle", "width", "depth"), 1),
    "alpha": -1,
}


class Grading(NamedTuple):
    name: str  # English; translated in the context "FGMesh"
    tip: str
    formula: str
    parameters: Callable  # of an Extent: {name: number}
    references: int = 0  # how many faces or other parts it needs


class Extent(NamedTuple):
    """How far a solid reaches in a frame, mm."""

    low: tuple  # x, y, z
    high: tuple
    r_max: float  # distance from the z axis
    d_max: float  # distance from the origin

    def along(self, axis):
        low, high = self.low[axis], self.high[axis]
        return low, (high - low) or 1.0

    @property
    def size(self):
        return max(high - low for low, high in zip(self.low, self.high))


_measured = []
"""(shape, points) of the latest shape: each ready grading asks for the same."""


def extent(shape, frame):
    """The Extent of `shape` in `frame`, a placement in the same coordinates as the shape. Nothing is triangulated, so that
    a shape of a thousand faces takes a tenth of a second."""
    local = shape.copy(False)
    local.Placement = frame.inverse().multiply(local.Placement)
    rows = np.array(frame.inverse().toMatrix().A).reshape(4, 4)
    points = _reach_points(shape) @ rows[:3, :3].T + rows[:3, 3]
    low, high = points.min(axis=0), points.max(axis=0)
    # Around poles of splines and trimmed balls the box is too large, and points are a little short of a curve's top.
    box = local.BoundBox
    around = np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]])
    slack = _ENOUGH * np.max(high - low)
    low = np.where(low - around[0] < slack, around[0], low)
    high = np.where(around[1] - high < slack, around[1], high)
    return Extent(
        tuple(low.tolist()),
        tuple(high.tolist()),
        float(np.hypot(points[:, 0], points[:, 1]).max()),
        float(np.linalg.norm(points, axis=1).max()),
    )


def _reach_points(shape):
    """(n, 3): core.reach_points of `shape`."""
    if not _measured or not _measured[0][0].isEqual(shape):
        _measured[:] = [(shape, core.reach_points(brep_text(shape)))]
    return _measured[0][1]


def fitted(grading, shape, frame):
    """{name: number} of the parameters of `grading` for `shape`, rounded to what one would type."""
    return {name: float(f"{value:.6g}") for name, value in grading.parameters(extent(shape, frame)).items()}


def dimension(name):
    """Of the parameter `name` of a ready grading: 1 for a length, -1 for one over a length, 0 for a plain number."""
    return _DIMENSIONS.get(name.rstrip("0123456789"), 0)


def numbered(formula, parameters, number):
    """Formula and parameters of a grading for the constituent with this number: those of all but the first have
    names of their own, so that each formula keeps its values."""
    if number == 1:
        return formula, parameters
    for name in parameters:
        formula = re.sub(rf"\b{name}\b", f"{name}{number}", formula)
    return formula, {f"{name}{number}": value for name, value in parameters.items()}


def _linear(axis):
    def parameters(reach):
        low, length = reach.along(axis)
        return {"start": low, "length": length}

    return parameters


def _power(reach):
    return {**_linear(2)(reach), "n": 2.0}


def _exponential(reach):
    return {"alpha": 4.0 / (reach.d_max or 1.0)}


def _exponential_axis(reach):
    low, length = reach.along(2)
    return {"start": low, "alpha": 3.0 / length}


def _radial(reach):
    return {"radius": reach.r_max or 1.0}


def _spherical(reach):
    return {"radius": reach.d_max or 1.0}


def _sigmoid(reach):
    low, length = reach.along(2)
    return {"middle": low + length / 2, "width": length / 10}


def _between(reach):
    return {"n": 1.0}


def _layer(reach):
    return {"depth": reach.size / 10}


GRADINGS = (
    Grading(
        TRANSLATE_LATER("FGMesh", "Linear along z"),
        TRANSLATE_LATER("FGMesh", "From 0 at the low end to 1 at the high end of the frame's z axis"),
        "clamp((z - start)/length, 0, 1)",
        _linear(2),
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Linear along x"),
        TRANSLATE_LATER("FGMesh", "From 0 at the low end to 1 at the high end of the frame's x axis"),
        "clamp((x - start)/length, 0, 1)",
        _linear(0),
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Linear along y"),
        TRANSLATE_LATER("FGMesh", "From 0 at the low end to 1 at the high end of the frame's y axis"),
        "clamp((y - start)/length, 0, 1)",
        _linear(1),
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Power law along z"),
        TRANSLATE_LATER("FGMesh", "As the linear one, to the power n"),
        "clamp((z - start)/length, 0, 1)^n",
        _power,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Exponential along z"),
        TRANSLATE_LATER("FGMesh", "1 at the low end of the frame's z axis; falls by e within 1/alpha"),
        "exp(-alpha*max(z - start, 0))",
        _exponential_axis,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Exponential about a point"),
        TRANSLATE_LATER("FGMesh", "1 at the frame's origin; falls by e within 1/alpha"),
        "exp(-alpha*d)",
        _exponential,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Radial"),
        TRANSLATE_LATER("FGMesh", "From 0 on the frame's z axis to 1 at the radius"),
        "clamp(r/radius, 0, 1)",
        _radial,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Spherical"),
        TRANSLATE_LATER("FGMesh", "From 0 at the frame's origin to 1 at the radius"),
        "clamp(d/radius, 0, 1)",
        _spherical,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Sigmoid layer across z"),
        TRANSLATE_LATER("FGMesh", "A smooth step from 0 to 1 in the middle, over the width"),
        "1/(1 + exp(-(z - middle)/width))",
        _sigmoid,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "From face A to face B"),
        TRANSLATE_LATER("FGMesh", "0 on the first reference, 1 on the second"),
        "(d1/(d1 + d2))^n",
        _between,
        references=2,
    ),
    Grading(
        TRANSLATE_LATER("FGMesh", "Layer below a face"),
        TRANSLATE_LATER("FGMesh", "1 on the reference; falls by e within the depth"),
        "exp(-d1/depth)",
        _layer,
        references=1,
    ),
)


def to_begin_with(shape, frame):
    """The linear one along the axis of `frame` along which `shape` is longest; of axes alike, z before x and y."""
    reach = extent(shape, frame)
    lengths = [high - low for low, high in zip(reach.low, reach.high)]
    z, x, y = GRADINGS[:3]
    longest = (1 - _ENOUGH) * max(lengths)  # rounding decides nothing
    return next(one for one, axis in ((z, 2), (x, 0), (y, 1)) if lengths[axis] >= longest)
