# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the meshes of one part."""
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import gmsh_mesh
import numpy as np

from freecad.fgmesh import core, worker

VOLUME, ANGLE, SECONDS, OFF = 0.5, 5 * (1 - 1e-6), 120, 1e-6
"""Limits: per cent; degrees, less what rounding does; s; distance of boundary points, as part of the diagonal."""

ASKED_POINTS = 300
"""How many boundary points FreeCAD is asked about; it takes up to some hundredths of a second for each."""


def meshed(path, options):
    """Figures of the mesh of one file. Raises what worker.generate_mesh raises."""
    control = core.RunControl()
    control.set_limits(options.time_limit, options.memory_limit)
    even = core.Material(["0.5"])
    coarse = worker.generate_mesh(path, even, core.MeshingOptions(stop_after="initial"), control)
    formula = ramp(coarse.points)
    start = time.perf_counter()
    asked = core.MeshingOptions(material_threshold=options.threshold)
    result = worker.generate_mesh(path, core.Material([formula]), asked, control)
    row = {
        "status": result.status,
        "message": "; ".join(result.messages),
        "seconds": time.perf_counter() - start,
        "formula": formula,
        "tets": len(result.tets),
        "volume_error": volume_error(result, result.volume),
        "deviation": result.deviation_max / result.surface_deviation,
        "dihedral_min": float(result.dihedral_min.min()),
        "unforced_min": float(np.delete(result.dihedral_min, result.forced_angles).min(initial=180)),
        "dihedral_max": result.stages[-1].dihedral_max,
        **boundary_figures(path, result, options.time_limit),
    }
    row["misses"] = ", ".join(misses(row))
    if options.gmsh:
        row.update(beside_gmsh(path, result, options))
    return row


def volume_error(result, volume):
    """Per cent."""
    return 100 * (volume / result.shape_volume - 1)


def diagonal(points):
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def boundary_figures(path, result, time_limit):
    """Euler characteristics of the solids in mesh and shape, and how far boundary points are from the vertex, edge or
    face that carries them, as part of the diagonal; without the shape's and the distance where FreeCAD fails. Solids
    of the shape that the mesh has given to others in part have no characteristic."""
    solids = range(1, len(result.shape_solid_volumes) + 1)
    figures = {"euler": [boundary_euler(result.tets[result.tet_solids == solid, :4]) for solid in solids]}
    on_boundary = np.flatnonzero((result.carriers[:, 0] < 3) & (result.carriers[:, 1] > 0))
    chosen = on_boundary[np.unique(np.linspace(0, len(on_boundary) - 1, ASKED_POINTS).astype(int))]
    with tempfile.TemporaryDirectory() as folder:
        points = Path(folder, "points.npz")
        np.savez(points, points=result.points[chosen], carriers=result.carriers[chosen])
        command = [sys.executable, "-P", Path(__file__).with_name("boundary_check.py"), path, points]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=time_limit)
            answer = json.loads(done.stdout.splitlines()[-1])
        except (subprocess.TimeoutExpired, IndexError, ValueError):
            return figures
    whole = np.isclose(result.shape_solid_volumes, answer["volume"], rtol=0.01)
    shape_euler = [euler if kept else None for euler, kept in zip(answer["euler"], whole)]
    return {**figures, "shape_euler": shape_euler, "off": answer["distance"] / diagonal(result.points)}


def boundary_euler(tets):
    """Of the surface around some tetrahedra: vertices less edges plus triangles."""
    faces = np.sort(np.vstack([np.delete(tets, i, axis=1) for i in range(4)]), axis=1)
    faces, uses = np.unique(faces, axis=0, return_counts=True)
    faces = faces[uses == 1]
    sides = np.unique(np.vstack([np.delete(faces, i, axis=1) for i in range(3)]), axis=0)
    return len(np.unique(faces)) - len(sides) + len(faces)


def misses(row):
    """The limits that a mesh does not keep."""
    if abs(row["volume_error"]) > VOLUME:
        yield "volume"
    if row["deviation"] > 1:
        yield "deviation"
    if row["unforced_min"] < ANGLE:
        yield "angle"
    if row["seconds"] > SECONDS:
        yield "time"
    if "off" not in row:
        yield "FreeCAD fails"
    elif any(of_shape not in (None, of_mesh) for of_mesh, of_shape in zip(row["euler"], row["shape_euler"])):
        yield f"topology ({row['euler']} for {row['shape_euler']})"
    elif row["off"] > OFF:
        yield "points off"


def beside_gmsh(path, result, options):
    """Figures of uniform meshes of FGMesh and gmsh with the same largest element."""
    size = diagonal(result.points) / 8
    row, failed = {}, []
    try:
        theirs = gmsh_mesh.figures(path, size, options.time_limit)
        row.update(gmsh_tets=theirs["tets"], gmsh_seconds=theirs["seconds"])
        row["gmsh_volume_error"] = volume_error(result, theirs["volume"])
    except gmsh_mesh.GmshFailed as error:
        failed.append(str(error))
    for name, deviation in ("alike", gmsh_mesh.deviation(size)), ("fine", 0.0):
        control = core.RunControl()
        control.set_limits(options.time_limit, options.memory_limit)
        asked = core.MeshingOptions(max_size=size, surface_deviation=deviation)
        start = time.perf_counter()
        try:
            ours = worker.generate_mesh(path, core.Material(["0.5"]), asked, control)
        except core.Error as error:
            failed.append(f"{name}: {error}")
            continue
        row[f"{name}_tets"], row[f"{name}_seconds"] = len(ours.tets), time.perf_counter() - start
        row[f"{name}_volume_error"] = volume_error(ours, ours.volume)
        if "gmsh_tets" in row:
            row[f"{name}_ratio"] = len(ours.tets) / row["gmsh_tets"]
    return {**row, "gmsh_message": shortened("; ".join(failed))}


def ramp(points):
    """The formula that goes from 0.05 to 0.95 along the longest axis of the points' box."""
    low, size = points.min(axis=0), points.max(axis=0) - points.min(axis=0)
    axis = int(size.argmax())
    return f"0.05 + 0.9*({'xyz'[axis]} - ({low[axis]:.17g}))/{size[axis]:.17g}"


def shortened(message):
    """One line that breaks no table."""
    text = " ".join(message.split()).replace("|", "/")
    return text if len(text) <= 160 else f"{text[:157]}..."
