# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to a mesh that keeps the threshold.

Each takes a Case, the path of its BREP file, the threshold and the path of the mesh to write, and gives
{"seconds": s}, without reading and writing files.
"""
import json
import math
import re
import subprocess
import time
from functools import partial

import cases  # noqa: F401  puts FreeCAD on the path
import check
import Part
from freecad.fgmesh import core
from freecad.fgmesh.io.mesh_file import write_mesh

GMSH = """
Merge "{shape}";
Mesh.Algorithm3D = 1;  // Delaunay
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Field[1] = MathEval;
Field[1].F = "{constant:.17g}/max({slope}, {least_slope:.17g})";
Background Field = 1;
"""
GMSH_SECONDS = re.compile(r"Done (?:meshing \dD|optimizing mesh) \(Wall ([-+.\de]+)s")


class RivalFailed(RuntimeError):
    """A program ended without the mesh that it was asked for."""


def fgmesh(anisotropy, case, shape, threshold, out):
    """FGMesh in this process, from the text of the B-Rep to the arrays."""
    text = shape.read_bytes()
    start = time.perf_counter()
    options = core.MeshingOptions(material_threshold=threshold, anisotropy=anisotropy, stop_after="material")
    result = core.generate_mesh(text, core.Material([case.formula]), options)
    seconds = time.perf_counter() - start
    write_mesh(result, out)
    return {"seconds": seconds}


def local_strategy(edge, case, shape, threshold, out):
    """Steiner points without smoothing, on the "longest" or the "steepest" edge: see local_strategy.cpp."""
    answer = _run([out.parent / "local_strategy", edge, shape, case.formula, threshold, out])
    return {"seconds": json.loads(answer)["seconds"]}


def gmsh_search(case, shape, threshold, out):
    """What a careful user of gmsh does: the largest constant whose mesh keeps the threshold, by bisection.

    "seconds" are those of a run with that constant, "search_seconds" those of all before.
    """
    part = Part.Shape()
    part.importBrep(str(shape))
    largest = part.BoundBox.DiagonalLength / 8
    spent = []

    def keeps(constant):
        spent.append(gmsh(case, shape, largest, constant, out))
        return check.measure(case, out, threshold)["above"] == 0

    constant = search_constant(keeps, 0.3 * threshold, threshold)
    return {
        "seconds": gmsh(case, shape, largest, constant, out),
        "search_seconds": sum(spent),
        "constant": constant,
    }


def gmsh(case, shape, largest, constant, out):
    """One mesh by gmsh with h = constant / |grad f|, at most `largest` mm; the seconds that gmsh says it took for
    meshing and optimising."""
    script = out.with_suffix(".geo")
    values = {"constant": constant, "slope": case.slope, "least_slope": constant / largest}
    script.write_text(GMSH.format(shape=shape, **values))
    log = _run(["gmsh", script, "-3", "-bin", "-format", "msh41", "-o", out])
    times = [float(seconds) for seconds in GMSH_SECONDS.findall(log)]
    if len(times) < 4:
        raise RivalFailed(f"gmsh did not tell its times for {script}: {log[-500:]}")
    return sum(times)


def search_constant(keeps, low, high, runs=8):
    """The largest constant between low and high that keeps(constant) accepts, by `runs` halvings of their ratio.
    Raises RivalFailed where it accepts none."""
    best = None
    for _ in range(runs):
        middle = math.sqrt(low * high)
        if keeps(middle):
            best = low = middle
        else:
            high = middle
    if best is None:
        raise RivalFailed(f"no constant down to {high:.3g} keeps the threshold")
    return best


def _run(command):
    words = [str(word) for word in command]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        raise RivalFailed(f"{' '.join(words)}: {(done.stderr or done.stdout)[-1000:]}")
    return done.stdout


RIVALS = {
    "FGMesh": (partial(fgmesh, 1.0), ".vtu"),
    "FGMesh, anisotropy 2": (partial(fgmesh, 2.0), ".vtu"),
    "FGMesh, anisotropy 3": (partial(fgmesh, 3.0), ".vtu"),
    "local, longest edge": (partial(local_strategy, "longest"), ".mesh"),
    "local, steepest edge": (partial(local_strategy, "steepest"), ".mesh"),
    "gmsh": (gmsh_search, ".msh"),
}
