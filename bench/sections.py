# SPDX-License-Identifier: GPL-3.0-or-later
"""The sections of a run: each gives the figures of its meshes by name, taken in `options.repeat` turns."""
import hashlib
import re
import statistics
import sys
import time

import cases
import check
import FreeCAD
import numpy as np
import Part
import programs
import rivals
from freecad.fgmesh import core, worker
from freecad.fgmesh.fem.generate import generate
from freecad.fgmesh.io.mesh_file import write_mesh

DEVIATION = 1 / 500
"""Of the diagonal: the surface deviation of `geometry`, which asks for about as many elements as the material does."""
BOTH_AT = 0.1
"""The threshold of `geometry`."""
FINER = (0.05, 0.03, 0.02, 0.015)
"""Thresholds of `scaling`: to two million tetrahedra."""
THREADS_AT = 0.02
"""The threshold of `threads`: a million tetrahedra, nearly."""


def compare_ways(folder, options):
    """{threshold: {case: {way: figures}}}; those of a way that failed are {"failed": why}."""
    found = {}
    for threshold in sorted(options.thresholds, reverse=True):
        coarser = list(found.values())[-1] if found else {}
        found[f"{threshold:g}"] = {
            name: one_case(cases.BY_NAME[name], threshold, coarser.get(name, {}), folder, options)
            for name in options.cases
        }
    return found


def one_case(case, threshold, coarser, folder, options):
    """{way: figures}. coarser: the same at a coarser threshold, where it has been measured."""
    solid, shape = built(case, folder)
    figures = {}
    for turn in range(options.repeat):
        for name, (way, extension) in rivals.RIVALS.items():
            entry = figures.setdefault(name, {"rounds": []})
            if name not in options.ways or "failed" in entry:
                continue
            say(f"{case.name} at {threshold:g}: {name}", turn, options)
            out = folder / (re.sub(r"\W+", "-", f"{case.name} {threshold:g} {name}") + extension)
            job = rivals.Job(case, solid, shape, threshold, options.limit, out, known(coarser.get(name, {})))
            try:
                entry["rounds"].append(way(job, *entry["rounds"][:1]))
            except (programs.RivalFailed, core.Error) as error:
                entry["failed"] = str(error)
                continue
            entry.update(check.measure(case, out, threshold), threshold=threshold)
    for entry in figures.values():
        rounds = entry["rounds"]
        if rounds:
            entry.update(medians(rounds), volume_error=abs(entry["volume"] / solid.Volume - 1))
    return {name: entry for name, entry in figures.items() if entry["rounds"] or "failed" in entry}


def known(figures):
    return figures["constant"] / figures["threshold"] if "constant" in figures else 0.0


def study(folder, options):
    """{study: figures} of the case studies of examples/ through their FreeCAD documents and all three stages."""
    return {name: one_study(name, folder, options) for name in cases.STUDIES}


def one_study(name, folder, options):
    rounds = []
    for turn in range(options.repeat):
        say(name, turn, options)
        mesh = cases.build_study(name)
        start = time.perf_counter()
        result = generate(mesh)
        rounds.append({"seconds": time.perf_counter() - start, **rivals.certificate(result)})
        threshold, allowed, shape = (
            mesh.MaterialThreshold,
            float(mesh.SurfaceDeviation),
            mesh.Shape.Shape.copy(),
        )
        FreeCAD.closeDocument(mesh.Document.Name)
    case, out = cases.STUDIES[name], folder / f"{name}.vtu"
    write_mesh(result, out)
    figures = check.measure(case, out, threshold)
    points, _, triangles = check.read(out)
    if abs(case.fraction_at(points) - result.fractions[:, 0]).max() > 1e-9:
        figures["faults"].append(f"the fractions are not those of {case.name}")
    boundary = Part.makeCompound(shape.Faces)
    centres = points[triangles].mean(axis=1).tolist()
    figures["deviation"] = max(boundary.distToShape(Part.Vertex(*centre))[0] for centre in centres)
    figures["part_of_deviation"] = figures["deviation"] / allowed
    figures["volume_error"] = abs(figures["volume"] / shape.Volume - 1)
    return {**figures, "rounds": rounds, **medians(rounds)}


def geometry(folder, options):
    """{case: figures} of meshes that follow material and boundary, and how many tetrahedra each alone takes."""
    return {name: one_geometry(cases.BY_NAME[name], folder, options) for name in options.cases}


def one_geometry(case, folder, options):
    solid, shape = built(case, folder)
    threshold = BOTH_AT
    made = {
        "surface_deviation": solid.BoundBox.DiagonalLength * DEVIATION,
        "material_threshold": threshold,
    }
    graded, out = core.Material([case.formula]), folder / f"{case.name}-geometry.vtu"
    say(f"{case.name}: geometry", 0, options)
    start = time.perf_counter()
    result = core.generate_mesh(str(shape), graded, core.MeshingOptions(**made))
    seconds = time.perf_counter() - start
    write_mesh(result, out)
    figures = check.measure(case, out, threshold)
    by_material = core.generate_mesh(str(shape), graded, core.MeshingOptions(**made, stop_after="material"))
    by_geometry = core.generate_mesh(str(shape), core.Material(["0.5"]), core.MeshingOptions(**made))
    alone = {"material_alone": len(by_material.tets), "geometry_alone": len(by_geometry.tets)}
    return {
        **figures,
        **alone,
        "times_the_larger": figures["tets"] / max(alone.values()),
        "part_of_deviation": result.deviation_max / made["surface_deviation"],
        "expected_tets": core.estimate(str(shape), graded, core.MeshingOptions(**made)).tets,
        "seconds": seconds,
        **rivals.certificate(result),
    }


def scaling(folder, options):
    """{"case at threshold": figures} of the first case, finer and finer, each whole mesh in a process of its own.
    Memory a tetrahedron is what that takes more than one that makes the initial mesh only; "growth" is the time a
    tetrahedron as part of that of the first."""
    case = cases.CASES[0]
    _, shape = built(case, folder)
    found, least = {}, whole_mesh(case, shape, FINER[0], "initial")["memory_mb"]
    for threshold in FINER:
        rounds = []
        for turn in range(options.repeat):
            say(f"{case.name} at {threshold:g}: scaling", turn, options)
            rounds.append(whole_mesh(case, shape, threshold))
        figures = {"threshold": threshold, "rounds": rounds, **medians(rounds)}
        figures["kilobytes_a_tet"] = 1024 * (figures["memory_mb"] - least) / figures["tets"]
        first = found[next(iter(found))] if found else figures
        figures["growth"] = figures["microseconds_a_tet"] / first["microseconds_a_tet"]
        found[f"{case.name} at {threshold:g}"] = figures
    return found


def whole_mesh(case, shape, threshold, last_stage="geometry"):
    start = time.perf_counter()
    options = core.MeshingOptions(material_threshold=threshold, stop_after=last_stage)
    result = worker.generate_mesh(shape, core.Material([case.formula]), options)
    seconds, tets = time.perf_counter() - start, len(result.tets)
    return {
        "tets": tets,
        "above": len(result.above_threshold),
        "dihedral_min": float(np.min(result.dihedral_min)),
        "seconds": seconds,
        "memory_mb": result.peak_memory_mb,
        "microseconds_a_tet": 1e6 * sum(stage.seconds for stage in result.stages) / tets,
    }


def threads(folder, options):
    """{"case, n threads": figures} of one mesh by one thread and by two. "gain" is how many times faster it is."""
    case = cases.CASES[0]
    _, shape = built(case, folder)
    rounds, contents = {1: [], 2: []}, set()
    for turn in range(options.repeat):
        for count, times in rounds.items():
            say(f"{case.name}: {count} of 2 threads", turn, options)
            chosen = core.MeshingOptions(material_threshold=THREADS_AT, threads=count)
            start = time.perf_counter()
            result = core.generate_mesh(str(shape), core.Material([case.formula]), chosen)
            times.append(
                {"seconds": time.perf_counter() - start, "used": result.threads, "tets": len(result.tets)}
            )
            contents.add(digest(result))
    found = {count: {"rounds": times, **medians(times)} for count, times in rounds.items()}
    found[2].update(gain=found[1]["seconds"] / found[2]["seconds"], different_meshes=len(contents) - 1)
    return {f"{case.name}, {count} threads": figures for count, figures in found.items()}


def digest(result):
    return hashlib.sha256(
        b"".join(a.tobytes() for a in (result.points, result.tets, result.triangles))
    ).digest()


def built(case, folder):
    """The solid of a case, and the path of its BREP file."""
    solid, shape = case.build(), folder / f"{case.name}.brep"
    solid.exportBrep(str(shape))
    return solid, shape


def medians(rounds):
    """{name: median} over dictionaries of numbers with equal names."""
    return {name: statistics.median(turn[name] for turn in rounds) for name in rounds[0]}


def say(what, turn, options):
    print(f"{what}, {turn + 1} of {options.repeat}", file=sys.stderr, flush=True)


SECTIONS = {
    "cases": compare_ways,
    "studies": study,
    "geometry": geometry,
    "scaling": scaling,
    "threads": threads,
}
