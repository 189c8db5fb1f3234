# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers for readers of fixed width: CalculiX takes the first 20 characters of a number and drops the others."""
import numpy as np

WIDTH = 20
"""Characters (CalculiX's sources read each number of a card as f20.0)."""

_NEGLIGIBLE = 1e-15
"""Of the size of a part: less than the rounding of its coordinates."""


def deck_number(value):
    """`value`, a finite number, in at most WIDTH characters, with as many of its digits as these hold.

    Reading it gives the very same double unless it needs 17 digits and an exponent: then at least 13 digits are right.
    Raises ValueError for what is not finite.
    """
    value = float(value)
    text = repr(value)
    return text if len(text) <= WIDTH and value - value == 0 else _shortened(value)


def _shortened(value):
    if not np.isfinite(value):
        raise ValueError(f"{value} is no number for a deck")
    exponent = int(f"{value:.16e}".partition("e")[2])
    room = WIDTH - 1 - (value < 0)  # for digits and exponent, beside the point and the sign
    if -3 <= exponent < 0:
        # Without the zero before the point this holds more digits than an exponent leaves.
        return f"{value:.{room}f}".replace("0.", ".", 1).rstrip("0")
    mantissa, _, exponent = f"{value:.{room - len(f'e{exponent}') - 1}e}".partition("e")
    return f"{mantissa.rstrip('0')}e{int(exponent)}"


def without_noise(points):
    """`points` (n, 3), with zeros in place of coordinates that are negligible beside the size of what they span: the
    rounding of a cosine that should be 0."""
    points = np.asarray(points, float)
    size = np.linalg.norm(np.ptp(points, axis=0)) if len(points) else 0.0
    return np.where(np.abs(points) <= _NEGLIGIBLE * size, 0.0, points)
