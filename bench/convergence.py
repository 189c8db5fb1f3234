# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of graded analyses against exact solutions, by the size of the elements; see bench/convergence.

    convergence.py BUILD_DIR [--problems NAME...] [--draw]

Problems are those of tests/freecad/exact_problems.py, solved in bins and continuously, with four and ten nodes; 100 bins.
The error is the largest at a node, of the largest displacement, or of the temperatures' range. BUILD_DIR/bench receives
convergence.json, from which --draw draws the plot again without solving. Also draws the probe of
examples/graded_cylinder.py, docs/probe.svg.
"""
import argparse
import importlib.util
import json
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
SIZES = {  # the largest of the sizes (MaxSize), mm
    "patch_test": 1.6,
    "exponential_bar": 1.6,
    "graded_strip": 2.4,
    "thick_cylinder": 2.4,
    "conduction": 1.6,
}
KINDS = {
    "bins, 4 nodes": ("bins", False),
    "continuous, 4 nodes": ("continuous", False),
    "bins, 10 nodes": ("bins", True),
    "continuous, 10 nodes": ("continuous", True),
}
COLOURS = dict(zip(KINDS, ("C0", "C1", "C2", "C3")))
FAIR = {"thick_cylinder": 1e-2}
"""What is fair to ask of four nodes; 2e-3 elsewhere."""


def main(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", type=Path)
    parser.add_argument("--problems", nargs="+", choices=SIZES, default=list(SIZES))
    parser.add_argument("--draw", action="store_true")
    options = parser.parse_args(arguments)
    kept = options.build / "bench" / "convergence.json"
    find_freecad(options.build)
    if not options.draw:
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(json.dumps(measure(options), indent=1) + "\n")
    errors = json.loads(kept.read_text())
    print(table(errors))
    draw(errors, ROOT / "docs" / "convergence.svg")
    draw_probe(ROOT / "docs" / "probe.svg")


def find_freecad(build):
    sys.path[:0] = [str(build / "Mod" / "FGMesh"), str(ROOT / "tests" / "freecad")]
    sys.path.append("/usr/lib/freecad-python3/lib")
    sys.path += [f"/usr/share/freecad/{folder}" for folder in ("Mod", "Mod/Fem", "Mod/Part", "Ext")]


def measure(options):
    """{problem: {kind: [[MaxSize mm, tets, error]]}}"""
    errors = {}
    for problem in options.problems:
        kinds = {k: v for k, v in KINDS.items() if problem != "conduction" or v[0] == "bins"}
        errors[problem] = {
            name: [[size, *error(problem, *kind, size)] for size in sizes(problem, kind[1])]
            for name, kind in kinds.items()
        }
    return errors


def sizes(problem, second_order):
    """Halved again and again: as far as takes seconds, not minutes."""
    return [SIZES[problem] / 2**level for level in range(3 if second_order else 4)]


def error(problem, mode, second_order, size):
    """(tetrahedra, error) of one analysis."""
    import exact_problems
    import FreeCAD

    import freecad.fgmesh as fgmesh

    document = FreeCAD.newDocument("Convergence")
    bench, exact = getattr(exact_problems, problem)(document, fgmesh, SecondOrder=second_order, MaxSize=size)
    result, points = exact_problems.solved(
        bench, fgmesh, mode, kind="thermomech" if problem == "conduction" else "static"
    )
    found = (
        exact_problems.temperature_error(result, exact(points))
        if problem == "conduction"
        else exact_problems.displacement_error(result, exact(points))
    )
    tets = bench.mesh.TetCount
    FreeCAD.closeDocument(document.Name)
    return tets, found


def table(errors):
    rows = ["| problem | elements | MaxSize: tetrahedra, error |", "| --- | --- | --- |"]
    for problem, kinds in errors.items():
        for kind, found in kinds.items():
            text = "; ".join(f"{size:g}: {tets}, {error:.1e}" for size, tets, error in found)
            rows.append(f"| {problem.replace('_', ' ')} | {kind} | {text} |")
    return "\n".join(rows)


def draw(errors, path):
    """Errors against the number of tetrahedra, a panel for each problem, all on one scale."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(12, 4), layout="constrained")
    panels = figure.subplots(1, len(errors), sharey=True, squeeze=False)[0]
    for axes, (problem, kinds) in zip(panels, errors.items()):
        for kind, style in zip(KINDS, ("o-", "s--", "^-", "d--")):
            if kind in kinds:
                _, tets, error = np.array(kinds[kind]).T
                axes.loglog(tets, error, style, label=kind, color=COLOURS[kind])
        axes.axhline(FAIR.get(problem, 2e-3), color="grey", linewidth=0.8)
        axes.set(title=problem.replace("_", " "), xlabel="tetrahedra")
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("largest error")
    panels[0].legend(fontsize="small")
    figure.savefig(path, metadata={"Date": None})


def draw_probe(path):
    import FreeCAD

    # Under its own name it would run at once, as a macro does.
    spec = importlib.util.spec_from_file_location("cylinder", ROOT / "examples" / "graded_cylinder.py")
    macro = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(macro)
    mesh = macro.build()
    macro.draw(macro.probes(mesh), path)
    FreeCAD.closeDocument(mesh.Document.Name)


if __name__ == "__main__":
    main(sys.argv[1:])
