# SPDX-License-Identifier: GPL-3.0-or-later
"""Three ways to a mesh that keeps the threshold. Each writes a mesh file and gives the seconds it took."""
import json
import math
import re
import subprocess
import time

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


def fgmesh(case, shape, threshold, out, **options):
    """FGMesh in this process, from the text of the B-Rep to the arrays. shape: path of a BREP file."""
    start = time.perf_counter()
    wanted = core.MeshingOptions(material_threshold=threshold, **options)
    result = core.generate_mesh(shape, core.Material([case.formula]), wanted)
    seconds = time.perf_counter() - start
    write_mesh(result, out)
    return seconds


def local_strategy(program, edge, case, shape, threshold, out):
    """Steiner points without smoothing, on the "longest" or the "steepest" edge; seconds of the program's own."""
    return json.loads(_run([program, edge, shape, case.formula, str(threshold), out]))["seconds"]


def gmsh(case, shape, largest, constant, out):
    """gmsh with h = constant / |grad f|, at most `largest` mm.

    The seconds are the sum of what gmsh says it spent on meshing and optimising, without start, reading and
    writing.
    """
    script = out.with_suffix(".geo")
    values = {"constant": constant, "slope": case.slope, "least_slope": constant / largest}
    script.write_text(GMSH.format(shape=shape, **values))
    log = _run(["gmsh", script, "-3", "-bin", "-format", "msh41", "-o", out])
    times = [float(seconds) for seconds in GMSH_SECONDS.findall(log)]
    if len(times) < 4:
        raise RivalFailed(f"gmsh did not tell its times for {script}: {log[-500:]}")
    return sum(times)


def search_constant(keeps, low, high, runs=8):
    """The largest constant with keeps(constant) between low and high, by `runs` halvings of their ratio.

    keeps is called with the answer at some time, and not again after that with a larger one that it accepts.
    Raises RivalFailed where none was accepted.
    """
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
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise RivalFailed(f"{' '.join(map(str, command))}: {(done.stderr or done.stdout)[-1000:]}")
    return done.stdout
