# SPDX-License-Identifier: GPL-3.0-or-later
"""The same part meshed by gmsh, for comparison."""
import subprocess
import tempfile
import time
from pathlib import Path

import meshio
import numpy as np

TURN = 12
"""Elements that gmsh puts around a full turn of a curved face."""

SCRIPT = """
Merge "{shape}";
Mesh.MeshSizeMax = {size:.17g};
Mesh.MeshSizeFromCurvature = {turn};
"""


class GmshFailed(RuntimeError):
    """gmsh ended without a mesh, or not in time."""


def figures(shape, size, time_limit):
    """Number of tetrahedra, volume (mm^3) and seconds of gmsh's mesh with elements of at most `size` mm. Raises
    GmshFailed."""
    with tempfile.TemporaryDirectory() as folder:
        script, out = Path(folder, "part.geo"), Path(folder, "part.mesh")
        script.write_text(SCRIPT.format(shape=Path(shape).resolve(), size=size, turn=TURN))
        command = ["gmsh", script, "-3", "-format", "mesh", "-nt", "1", "-o", out]
        start = time.perf_counter()
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=time_limit)
        except subprocess.TimeoutExpired:
            raise GmshFailed(f"gmsh took more than {time_limit:g} s") from None
        seconds = time.perf_counter() - start
        if done.returncode or not out.exists():
            raise GmshFailed(f"gmsh: {(done.stderr or done.stdout)[-300:]}")
        mesh = meshio.read(out)
    tets = mesh.cells_dict.get("tetra", np.empty((0, 4), int))
    if not len(tets):
        raise GmshFailed("gmsh made no tetrahedra")
    edges = mesh.points[tets[:, 1:]] - mesh.points[tets[:, :1]]
    return {"tets": len(tets), "volume": float(abs(np.linalg.det(edges)).sum() / 6), "seconds": seconds}


def deviation(size):
    """Of a chord of `size` mm on a curve that gmsh would cut into such chords, mm."""
    return size / 2 * np.tan(np.pi / TURN / 2)
