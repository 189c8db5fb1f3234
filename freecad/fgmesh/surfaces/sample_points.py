# SPDX-License-Identifier: GPL-3.0-or-later
"""Points on and inside solids, for looking at the range of a field before there is a mesh."""
import time

import numpy as np

from freecad.fgmesh.surfaces.section import cut

_CUTS = (0.5, 0.2, 0.8)  # of the extent along each axis
_FINENESS = 30  # edges of the cut faces are the diagonal divided by this
_SECONDS = 0.2
"""After which no further cut is begun: a part of many holes has slow ones."""


def sample_points(surface):
    """(points (n, 3), solids (n,)) on `surface`, a surface.Surface, and on a few planes through it, with the 0-based
    number of the solid of each."""
    low, high = surface.points.min(axis=0), surface.points.max(axis=0)
    points, solids = [surface.points], [surface.solids]
    end = time.monotonic() + _SECONDS
    for part in _CUTS:
        for normal in np.eye(3):
            if time.monotonic() < end:
                section = cut(surface, low + part * (high - low), normal, surface.diagonal / _FINENESS)
                points.append(section.points)
                solids.append(section.solids)
    return np.concatenate(points), np.concatenate(solids)
