# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes on in each stage of a run, and what makes it shorter: for messages of runs that were stopped."""
from typing import NamedTuple


class Stage(NamedTuple):
    doing: str
    cure: str


_DETAILS = "a larger MinSize bridges small details of the shape, and Part -> Refine shape unites faces"

STAGES = {
    "references": Stage("references are read", "fewer or simpler references take less"),
    "reading": Stage("the shape is read, checked and sampled", "Part -> Check geometry finds what to repair"),
    "initial": Stage("the surface is meshed, and the first tetrahedra are made", _DETAILS),
    "material": Stage(
        "tetrahedra are divided until the material varies little enough in each",
        "a larger MaterialThreshold, Anisotropy or MinSize takes fewer",
    ),
    "geometry": Stage(
        "the boundary is brought close enough to the true one",
        "a larger SurfaceDeviation or MinSize takes fewer",
    ),
    "certificate": Stage(
        "the threshold is proved between the corners of tetrahedra",
        "a larger MaterialThreshold takes less, and the certificate can be left out",
    ),
    "second order": Stage("middle nodes are put on the true boundary", "four-node tetrahedra need none"),
}
"""By the names that core.RunControl tells."""


def place(progress):
    """The end of a sentence on a run that ended early, with its last core progress: the stage."""
    return f' in the stage "{progress.stage}"' if progress.stage else ""


def place_and_cure(progress):
    """The same of a run that has reached a limit: how far it was, what went on and where, and what makes it shorter."""
    stage = STAGES.get(progress.stage)
    if stage is None:
        return place(progress)
    far = [f"{100 * min(1.0, progress.fraction):.0f} % of it were done"] if progress.fraction > 0 else []
    if progress.tets:
        more = 1.5 * progress.tets < progress.expected_tets
        expected = f" of about {float(f'{progress.expected_tets:.2g}'):.0f}" if more else ""
        far.append(f"there were {progress.tets}{expected} tetrahedra")
    reached = f"; {' and '.join(far)}" if far else ""
    near = (
        "; it was at work near ({:.6g}, {:.6g}, {:.6g}) mm".format(*progress.place) if progress.place else ""
    )
    return f"{place(progress)}, in which {stage.doing}{reached}{near}; {stage.cure}"
