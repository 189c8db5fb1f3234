# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements grouped by their properties, so that one material stands for each group. NumPy alone."""
from typing import NamedTuple

import numpy as np

from freecad.fgmesh import core

MOST = 2000
"""Bins: each is an object of a document."""

_SCALES = {"PoissonRatio": 0.5}
"""Properties that may be zero, or that are compared on the scale of what is possible."""


class Bins(NamedTuple):
    numbers: np.ndarray  # (m,) 0-based bin of each element
    values: dict  # {property: (bins,)}
    error: float  # see `bins`

    @property
    def count(self):
        return len(next(iter(self.values.values())))

    def members(self):
        """For each bin the 0-based elements in it, ascending."""
        order = np.argsort(self.numbers, kind="stable")
        return np.split(order, np.searchsorted(self.numbers[order], np.arange(1, self.count)))


def bins(properties, most=None, allowed_error=None):
    """Bins of elements with `properties`, {name: (m,)}: at most `most` of them or, where allowed_error > 0, as many as
    it needs.

    The error of a property in an element is |P - P_bin| relative to P_bin; of Poisson's ratio it is relative to 0.5,
    of what may be zero to the largest. `error` is the largest of all. The space of the properties, logarithms
    where they are positive, is cut across its longest side, again and again; each bin has the middle of its range.

    Raises core.InvalidInput for numbers that make no sense, and where more than `MOST` bins would be needed.
    """
    names = list(properties)
    features, scales = zip(*(_feature(name, np.asarray(properties[name], float)) for name in names))
    features = np.column_stack(features)
    if allowed_error:
        if not 0 < allowed_error < 1:
            raise core.InvalidInput(
                f"the allowed error of bins must lie between 0 and 1, not {allowed_error:g}"
            )
        widths = np.array([2 * (allowed_error if scale else np.log1p(allowed_error)) for scale in scales])
        members = list(_within(features / widths, np.arange(len(features))))
    else:
        if most is None or not 1 <= most <= MOST:
            raise core.InvalidInput(f"the number of bins must be from 1 to {MOST}, not {most}")
        members = list(_cut(features, np.arange(len(features)), int(most)))
    numbers = np.empty(len(features), int)
    middles = np.empty((len(members), len(names)))
    for number, chosen in enumerate(members):
        numbers[chosen] = number
        middles[number] = (features[chosen].min(axis=0) + features[chosen].max(axis=0)) / 2
    offsets = np.abs(features - middles[numbers]).max(axis=0)
    errors = [offset if scale else np.expm1(offset) for offset, scale in zip(offsets, scales)]
    values = {
        name: middle * scale if scale else np.exp(middle)
        for name, middle, scale in zip(names, middles.T, scales)
    }
    return Bins(numbers, values, float(max(errors)))


def _feature(name, values):
    """(m,) numbers of which equal differences are equal errors, and what they were divided by, None for logarithms."""
    if name in _SCALES:
        return values / _SCALES[name], _SCALES[name]
    if (values > 0).all():
        return np.log(values), None
    scale = np.abs(values).max() or 1.0
    return values / scale, scale


def _cut(features, chosen, count):
    """Yield the members of at most `count` parts of the elements `chosen`, in proportion to their extents."""
    axis, low, high = _longest(features, chosen)
    if count == 1 or high - low <= 1e-12:
        yield chosen
        return
    first = count // 2
    below = features[chosen, axis] <= low + (high - low) * first / count
    yield from _cut(features, chosen[below], first)
    yield from _cut(features, chosen[~below], count - first)


def _within(features, chosen, count=0):
    """Yield the members of parts of an extent of at most 1 in each direction."""
    pending = [chosen]
    while pending:
        chosen = pending.pop()
        axis, low, high = _longest(features, chosen)
        if high - low <= 1:
            yield chosen
            count += 1
            if count + len(pending) > MOST:
                raise core.InvalidInput(
                    f"the allowed error needs more than {MOST} bins: allow a larger one, or take the continuous mode"
                )
            continue
        slices = int(np.ceil(high - low - 1e-9))
        places = np.minimum((features[chosen, axis] - low) / (high - low) * slices, slices - 1).astype(int)
        order = np.argsort(places, kind="stable")
        _, starts = np.unique(places[order], return_index=True)
        pending += reversed(np.split(chosen[order], starts[1:]))


def _longest(features, chosen):
    """(axis, low, high) of the longest side of the box around the elements `chosen`."""
    lows, highs = features[chosen].min(axis=0), features[chosen].max(axis=0)
    axis = int((highs - lows).argmax())
    return axis, lows[axis], highs[axis]
