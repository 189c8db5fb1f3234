# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshers that take the size of elements as a function of place: each makes one mesh with h = constant / |grad f|.

Each takes a Job, the constant, and gives the seconds without reading and writing files. What a mesher cannot read
(a B-Rep, a formula) is prepared for it, and what that takes does not count.
"""
import itertools
import re
from functools import partial
from pathlib import Path

import meshio
import numpy as np
import programs

GMSH = """
General.NumThreads = 1;
Mesh.MaxNumThreads3D = 1;  // HXT's mesh is another one with another number of threads
Merge "{shape}";
Mesh.Algorithm3D = {algorithm};
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Field[1] = MathEval;
Field[1].F = "{constant:.17g}/max({slope}, {least_slope:.17g})";
Background Field = 1;
"""
DELAUNAY, HXT = 1, 10
GMSH_SECONDS = re.compile(r"Done (?:meshing \dD|optimizing mesh) \(Wall ([-+.\de]+)s")
TETGEN_SECONDS = re.compile(r"^(?!Total|Output)[\w ]+ seconds: +([\d.e+-]+)", re.MULTILINE)
TETGEN_OPTIONS = "-pq1.4/12mk"
"""Radius-edge ratio and dihedral angle of at least; the goals with which TetGen still ends on all cases."""
GRID = 40
"""Intervals along the longest side of the grid of sizes, for meshers that cannot evaluate a formula."""


def gmsh(algorithm, job, constant, dimension=3):
    """gmsh; its own seconds for meshing and optimising. "out" is the mesh's file, of surfaces where dimension is 2."""
    out = job.out if dimension == 3 else job.out.with_suffix(".surface.msh")
    script = out.with_suffix(".geo")
    values = {"constant": constant, "slope": job.case.slope, "least_slope": constant / job.largest}
    script.write_text(GMSH.format(shape=job.shape, algorithm=algorithm, **values))
    log = programs.run(["gmsh", script, f"-{dimension}", "-bin", "-format", "msh41", "-o", out], job.limit)
    times = [float(seconds) for seconds in GMSH_SECONDS.findall(log)]
    if len(times) < (
        4 if dimension == 3 and algorithm == DELAUNAY else dimension
    ):  # HXT optimises as it meshes
        raise programs.RivalFailed(f"gmsh did not tell its times: {log[-300:]}")
    return sum(times)


def netgen(job, constant):
    """Netgen through its library; sizes at the points of a grid."""
    sizes = job.out.with_suffix(".sizes")
    points, _ = grid(job.box)
    np.column_stack([points, sizes_at(job, constant, points)]).tofile(sizes)
    return programs.told_seconds(
        programs.run([programs.OWN / "netgen_mesh", job.shape, sizes, job.largest, job.out], job.limit)
    )


def tetgen(job, constant):
    """TetGen inside a surface by gmsh with the same sizes; sizes at the vertices of a mesh in the background."""
    seconds = gmsh(DELAUNAY, job, constant, dimension=2)
    surface = meshio.read(job.out.with_suffix(".surface.msh"))
    triangles = np.vstack([block.data for block in surface.cells if block.type == "triangle"])
    used, triangles = np.unique(triangles, return_inverse=True)
    stem = job.out.with_suffix("")
    write_poly(stem.with_suffix(".poly"), surface.points[used], triangles.reshape(-1, 3))
    write_background(stem, job, constant)
    result = Path(f"{stem}.1.ele")
    result.unlink(missing_ok=True)
    log = programs.run(["tetgen", TETGEN_OPTIONS, stem.with_suffix(".poly")], job.limit)
    if not result.exists():  # its exit status is 0 all the same
        raise programs.RivalFailed(f"TetGen failed: {log[-300:].strip()}")
    points = read_rows(f"{stem}.1.node")[:, 1:4]
    tets = read_rows(result)[:, 1:5].astype(int)
    meshio.Mesh(points, [("tetra", tets)]).write(job.out, binary=True)
    return seconds + sum(float(step) for step in TETGEN_SECONDS.findall(log))


def cgal(job, constant):
    """CGAL's refinement, ODT and perturbation in a fine triangulation; the sizes as a formula."""
    surface = job.out.with_suffix(".off")
    write_off(surface, *welded(*job.solid.tessellate(job.diagonal / 2000)))
    command = [programs.OWN / "cgal_refinement", surface, job.case.formula, constant, job.largest, job.out]
    return programs.told_seconds(programs.run(command, job.limit))


def sizes_at(job, constant, points):
    return constant / np.maximum(job.case.slope_at(points), constant / job.largest)


def grid(box):
    """Points (n, 3) of a grid over a little more than the box ((3,), (3,)), and its tetrahedra (m, 4)."""
    low, high = (np.asarray(corner, float) for corner in box)
    margin = 0.02 * (high - low).max()
    counts = np.maximum(2, np.ceil(GRID * (high - low) / (high - low).max())).astype(int) + 1
    axes = [np.linspace(l - margin, h + margin, n) for l, h, n in zip(low, high, counts)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    numbers = np.arange(len(points)).reshape(counts)
    corner, steps = numbers[:-1, :-1, :-1].ravel(), [counts[1] * counts[2], counts[2], 1]
    tets = []
    for order in itertools.permutations(steps):
        row = corner[:, None] + np.cumsum([0, *order])
        turned = order not in {tuple(np.roll(steps, k)) for k in range(3)}
        tets.append(row[:, [0, 2, 1, 3]] if turned else row)
    return points, np.vstack(tets)


def write_poly(path, points, triangles):
    with open(path, "w") as file:
        file.write(f"{len(points)} 3 0 0\n")
        np.savetxt(file, numbered(points), fmt="%d %.17g %.17g %.17g")
        file.write(f"{len(triangles)} 0\n")
        np.savetxt(file, triangles, fmt="1\n3 %d %d %d")
        file.write("0\n0\n")


def write_background(stem, job, constant):
    points, tets = grid(job.box)
    with open(f"{stem}.b.node", "w") as file:
        file.write(f"{len(points)} 3 0 0\n")
        np.savetxt(file, numbered(points), fmt="%d %.12g %.12g %.12g")
    with open(f"{stem}.b.ele", "w") as file:
        file.write(f"{len(tets)} 4 0\n")
        np.savetxt(file, numbered(tets), fmt="%d")
    with open(f"{stem}.b.mtr", "w") as file:
        file.write(f"{len(points)} 1\n")
        np.savetxt(file, sizes_at(job, constant, points), fmt="%.9g")


def numbered(rows):
    return np.column_stack([np.arange(len(rows)), rows])


def read_rows(path):
    """A file of TetGen without its head."""
    return np.loadtxt(path, skiprows=1, comments="#", ndmin=2)


def welded(points, triangles):
    """A triangulation with equal points made one, and without triangles that have become lines."""
    points, triangles = np.array([tuple(point) for point in points]), np.array(triangles)
    cell = 1e-9 * np.ptp(points, axis=0).max()
    _, first, place = np.unique(
        np.round(points / cell).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    triangles = place.reshape(-1)[triangles]
    a, b, c = triangles.T
    return points[first], triangles[(a != b) & (b != c) & (c != a)]


def write_off(path, points, triangles):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        np.savetxt(file, points, fmt="%.17g")
        np.savetxt(file, triangles, fmt="3 %d %d %d")


MESHERS = {
    "gmsh": (partial(gmsh, DELAUNAY), ".msh"),
    "gmsh HXT": (partial(gmsh, HXT), ".msh"),
    "Netgen": (netgen, ".mesh"),
    "TetGen": (tetgen, ".vtu"),
    "CGAL": (cgal, ".mesh"),
}
