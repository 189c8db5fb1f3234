# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of fractions: the same in previews, on meshes and in pictures.

The scale is matplotlib's viridis (CC0) from 0.12 to 1: evenly spaced to the eye, also to one that does not tell red
from green. Its darkest tenth is left out, where black edges would be lost. It stands here as 33 colours, so that a
preview need not wait for matplotlib.
"""
import functools

_SCALE = (
    "472a7a 46337f 443b84 414487 3e4c8a 3a538b 375b8d 33638d 306a8e 2d718e 2a778e 277e8e 25848e 228b8d 20928c 1f988b "
    "1f9f88 21a585 25ac82 2db27d 37b878 42be71 50c46a 5ec962 6ece58 7fd34e 90d743 a2da37 b5de2b c8e020 dae319 ece51b "
    "fde725"
)
SIZE = 256
"""Colours of the table."""

UNDEFINED = (0.62, 0.62, 0.62)
"""Where the formula has no value (NaN)."""

BELOW = (0.93, 0.32, 0.83)
"""Of values below the range, none of the scale's."""

ABOVE = (0.90, 0.16, 0.10)
"""Of values above the range, none of the scale's."""

_ROUNDING = 1e-6  # of the range: what a value may be outside it and still be meant to be its end


@functools.lru_cache(maxsize=1)
def table():
    """The scale from low to high: (SIZE, 3) float64 RGB in [0, 1], read-only."""
    import numpy as np

    knots = np.array([list(bytes.fromhex(colour)) for colour in _SCALE.split()]) / 255
    places = np.linspace(0, len(knots) - 1, SIZE)
    colours = np.column_stack([np.interp(places, range(len(knots)), channel) for channel in knots.T])
    colours.flags.writeable = False
    return colours


def rgb(values, low=0.0, high=1.0):
    """Colours (n, 3), RGB in [0, 1], of `values` (n,): low has the first colour of the scale, high the last.

    BELOW and ABOVE mark values outside, UNDEFINED marks NaN. Where low is high, that value has the middle colour.
    """
    import numpy as np

    places = fraction_of_range(values, low, high)
    known = np.nan_to_num(places, nan=0.5)
    colours = table()[np.rint(np.clip(known, 0, 1) * (SIZE - 1)).astype(int)]
    colours[known < 0] = BELOW
    colours[known > 1] = ABOVE
    colours[np.isnan(places)] = UNDEFINED
    return colours


def fraction_of_range(values, low, high):
    """Where `values` lie between low (0) and high (1); what rounding has put outside is taken back to the end."""
    import numpy as np

    values = np.asarray(values, float)
    if high > low:
        places = (values - low) / (high - low)
    else:
        places = np.select([values < low, values > low, values == low], [-1.0, 2.0, 0.5], np.nan)
    with np.errstate(invalid="ignore"):
        places = np.where((places < 0) & (places >= -_ROUNDING), 0.0, places)
        return np.where((places > 1) & (places <= 1 + _ROUNDING), 1.0, places)
