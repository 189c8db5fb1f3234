# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures FGMesh beside its rivals, all in one run on one machine. bench/run calls it as it should be called.

    benchmark.py BUILD_DIR [--cases NAME...] [--repeat 3] [--threshold 0.1] [--no-studies]

BUILD_DIR/bench receives the shapes, the meshes and results.json; the tables go to standard output. Times are
medians of the repetitions, taken in turns, so that a busy machine is busy for all. Exit status: 0 measured,
1 a mesh is not sound or a program failed; targets that are missed are only said.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import cases
import check
import FreeCAD
import Part
import rivals
import tables
from freecad.fgmesh import core
from freecad.fgmesh.fem.generate import generate
from freecad.fgmesh.io.mesh_file import write_mesh


def main(arguments):
    options = parse(arguments)
    folder = options.build.resolve() / "bench"
    folder.mkdir(parents=True, exist_ok=True)
    results = {"threshold": options.threshold, "repeat": options.repeat, "machine": machine()}
    chosen = [cases.BY_NAME[name] for name in options.cases]
    studies = [] if options.no_studies else cases.STUDIES
    try:
        results["cases"] = {case.name: run_case(case, folder, options) for case in chosen}
        results["studies"] = {name: run_study(name, folder, options.repeat) for name in studies}
    except (core.Error, rivals.RivalFailed) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    results["machine"]["load_after"] = os.getloadavg()[0]
    file = folder / "results.json"
    file.write_text(json.dumps(results, indent=1) + "\n")
    print(tables.in_markdown(results))
    print(f"kept in {file}", file=sys.stderr)
    return 1 if tables.unsound(results) else 0


def parse(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", type=Path)
    parser.add_argument("--cases", nargs="+", choices=cases.BY_NAME, default=list(cases.BY_NAME))
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--threshold", type=float, default=0.1)
    parser.add_argument("--no-studies", action="store_true")
    return parser.parse_args(arguments)


def machine():
    """What the times depend on."""
    describe = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    return {
        "cores": os.cpu_count(),
        "load_before": os.getloadavg()[0],
        "date": time.strftime("%Y-%m-%d %H:%M"),
        "commit": subprocess.run(describe, capture_output=True, text=True).stdout.strip() or "no git",
        **core.versions(),
    }


def run_case(case, folder, options):
    """{rival: figures} of one case."""
    solid = case.build()
    shape = folder / f"{case.name}.brep"
    solid.exportBrep(str(shape))
    figures = {}
    for turn in range(options.repeat):
        for name, (mesh, extension) in rivals.RIVALS.items():
            print(f"{case.name}: {name}, {turn + 1} of {options.repeat}", file=sys.stderr)
            out = folder / f"{case.name}-{name.replace(' ', '-')}{extension}"
            times = mesh(case, shape, options.threshold, out)
            entry = figures.setdefault(name, {"rounds": []})
            entry.update(check.measure(case, out, options.threshold))
            entry["rounds"].append(times)
    for entry in figures.values():
        entry["volume_error"] = abs(entry["volume"] / solid.Volume - 1)
        entry.update(medians(entry["rounds"]))
    return figures


def run_study(name, folder, repeat):
    """Figures of a case study of examples/ through its FreeCAD document and all three stages."""
    rounds = []
    for turn in range(repeat):
        print(f"{name}: {turn + 1} of {repeat}", file=sys.stderr)
        mesh = cases.build_study(name)
        start = time.perf_counter()
        result = generate(mesh)
        rounds.append({"seconds": time.perf_counter() - start})
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


def medians(rounds):
    """{name: median} over dictionaries of numbers with equal names."""
    return {name: statistics.median(turn[name] for turn in rounds) for name in rounds[0]}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
