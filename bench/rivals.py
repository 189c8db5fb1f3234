# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to a mesh that keeps the threshold.

Each takes a Job and what it gave for the same job before (or nothing), writes the mesh, and gives a dictionary of
numbers: "seconds", without reading and writing files, and what else is its own. It raises programs.RivalFailed
where it gets no such mesh.
"""
import math
import time
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import cases
import check
import programs
from freecad.fgmesh import core
from freecad.fgmesh.io.mesh_file import write_mesh
from size_fields import MESHERS


@dataclass
class Job:
    """What is to be meshed into which file."""

    case: cases.Case
    solid: object  # Part.Shape
    shape: Path  # the same as a BREP file
    threshold: float
    limit: float  # of one run and of what a search spends, s
    out: Path
    known: float = 0.0  # constant / threshold that a search has found at a coarser threshold; 0: none has
    diagonal: float = field(init=False)  # mm
    largest: float = field(init=False)  # size that any element may have, as FGMesh's own default, mm
    box: tuple = field(init=False)

    def __post_init__(self):
        box = self.solid.BoundBox
        self.diagonal, self.largest = box.DiagonalLength, box.DiagonalLength / 8
        self.box = (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)


def fgmesh(anisotropy, job, before=None):
    """FGMesh in this process, from the text of the B-Rep to the arrays; and what it had expected."""
    text, material = job.shape.read_bytes(), core.Material([job.case.formula])
    options = core.MeshingOptions(
        material_threshold=job.threshold, anisotropy=anisotropy, stop_after="material"
    )
    start = time.perf_counter()
    result = core.generate_mesh(text, material, options)
    seconds = time.perf_counter() - start
    write_mesh(result, job.out)
    return {
        "seconds": seconds,
        "expected_tets": core.estimate(text, material, options).tets,
        **certificate(result),
    }


def certificate(result):
    """What proving the threshold between vertices took, where the report tells it."""
    told = core.report(result).get("certified") or {}
    return {"certificate_seconds": told["seconds"]} if "seconds" in told else {}


def local_strategy(edge, job, before=None):
    """Steiner points without smoothing, on the "longest" or the "steepest" edge: see local_strategy.cpp."""
    command = [programs.OWN / "local_strategy", edge, job.shape, job.case.formula, job.threshold, job.out]
    return {"seconds": programs.told_seconds(programs.run(command, job.limit))}


def searched(mesher, job, before=None):
    """What a careful user of a mesher with a size field does: the largest constant whose mesh keeps the threshold,
    by bisection; where that was done before, its constant once more.

    The constant is nearly proportional to the threshold, so that of a coarser one begins the search where it is known.
    "seconds" are those of a run with the constant that is found, "search_seconds" those of all before.
    """
    if before:
        return {**before, "seconds": mesher(job, before["constant"])}
    spent, failures = [], []

    def keeps(constant):
        start = time.perf_counter()
        try:
            spent.append(mesher(job, constant))
        except programs.TooSlow:
            raise
        except programs.RivalFailed as error:  # as coarse meshes make some programs
            spent.append(time.perf_counter() - start)
            failures.append(str(error))
            return False
        return check.measure(job.case, job.out, job.threshold)["above"] == 0

    try:
        constant = find_constant(keeps, job, stop=lambda: sum(spent) > job.limit)
    except programs.TooSlow:
        raise
    except programs.RivalFailed as error:
        raise programs.RivalFailed("; ".join([str(error), *failures[-1:]])) from None
    return {
        "seconds": mesher(job, constant),
        "search_seconds": sum(spent),
        "search_runs": len(spent),
        "constant": constant,
    }


def find_constant(keeps, job, stop):
    """As search_constant(); near the one that is known first, which is not proportional to the threshold for every
    mesher."""
    if job.known:
        near = job.known * job.threshold
        try:
            return search_constant(keeps, 0.8 * near, 1.25 * near, 5, stop)
        except programs.TooSlow:
            raise
        except programs.RivalFailed:
            return search_constant(keeps, 0.1 * job.threshold, 0.8 * near, 8, stop)
    return search_constant(keeps, 0.3 * job.threshold, job.threshold, 8, stop)


def search_constant(keeps, low, high, runs, stop=lambda: False):
    """The largest constant between low and high that keeps(constant) accepts, by `runs` halvings of their ratio, or
    fewer where stop() says so. Raises RivalFailed where it accepts none."""
    best = None
    for _ in range(runs):
        middle = math.sqrt(low * high)
        if keeps(middle):
            best = low = middle
        else:
            high = middle
        if stop():
            break
    if best is None:
        raise programs.RivalFailed(f"no constant down to {high:.3g} keeps the threshold")
    return best


RIVALS = {
    "FGMesh": (partial(fgmesh, 1.0), ".vtu"),
    "FGMesh, anisotropy 2": (partial(fgmesh, 2.0), ".vtu"),
    "FGMesh, anisotropy 3": (partial(fgmesh, 3.0), ".vtu"),
    "local, longest edge": (partial(local_strategy, "longest"), ".mesh"),
    "local, steepest edge": (partial(local_strategy, "steepest"), ".mesh"),
    **{name: (partial(searched, mesher), extension) for name, (mesher, extension) in MESHERS.items()},
}
"""{name: (way, what the name of its file ends with)}"""
