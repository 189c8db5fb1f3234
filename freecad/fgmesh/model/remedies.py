# SPDX-License-Identifier: GPL-3.0-or-later
"""What to change where a mesh would have too many tetrahedra."""

_COARSER = 3.0  # threshold and surface deviation, for one step of quality
_ANISOTROPY = 3.0
_DEVIATION = 1 / 2000
"""Of the diagonal: the default surface deviation."""


def remedies(values, diagonal):
    """[{property: value}], each a change of the option values `values` alone that may leave fewer tetrahedra. diagonal: of
    the solid's bounding box, mm."""
    found = []
    threshold = float(f"{_COARSER * values['MaterialThreshold']:.1g}")
    if values["MaterialThreshold"] < threshold <= 1:
        found.append({"MaterialThreshold": threshold})
    if values["Anisotropy"] < _ANISOTROPY:
        found.append({"Anisotropy": _ANISOTROPY})
    deviation = values["SurfaceDeviation"] or _DEVIATION * diagonal
    found.append({"SurfaceDeviation": float(f"{_COARSER * deviation:.2g}")})
    if values["MaxSize"]:
        found.append({"MaxSize": 0.0})
    return found
