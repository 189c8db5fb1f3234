# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures FGMesh beside its rivals, all in one run on one machine. bench/run calls it as it should be called.

    benchmark.py BUILD_DIR [--cases NAME...] [--thresholds 0.1 0.05] [--repeat 3] [--limit 300]
                 [--sections NAME...] [--ways NAME...] [--keep FILE.json]

BUILD_DIR/bench receives the shapes, the meshes and results.json (or FILE.json, after each section); the tables go to
standard output. Times are medians of the repetitions, taken in turns, so that a busy machine is busy for all. A rival
that needs longer than `limit` seconds for one mesh is given up; a search that does is content with what it has.
Exit status: 0 measured, 1 a mesh is not sound or FGMesh made none; targets that are missed are only said.
"""
import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import cases
import rivals
import sections
import tables
from freecad.fgmesh import core


def main(arguments):
    options = parse(arguments)
    folder = options.build.resolve() / "bench"
    folder.mkdir(parents=True, exist_ok=True)
    file = options.keep or folder / "results.json"
    results = {"repeat": options.repeat, "limit": options.limit, "machine": machine(options.commit)}
    try:
        for name in options.sections:
            results[name] = sections.SECTIONS[name](folder, options)
            results["machine"]["load_after"] = os.getloadavg()[0]
            file.write_text(json.dumps(results, separators=(",", ":")) + "\n")
    except core.Error as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    print(tables.in_markdown(results))
    print(f"kept in {file}", file=sys.stderr)
    return 1 if tables.unsound(results) else 0


def parse(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    add("build", type=Path)
    add("--cases", nargs="+", choices=cases.BY_NAME, default=list(cases.BY_NAME))
    add("--thresholds", nargs="+", type=float, default=[0.1, 0.05])
    add("--repeat", type=int, default=3)
    add("--limit", type=float, default=300.0)
    add("--sections", nargs="+", choices=sections.SECTIONS, default=list(sections.SECTIONS))
    add("--ways", nargs="+", choices=rivals.RIVALS, default=list(rivals.RIVALS))
    add("--keep", type=Path)
    add("--commit", default="", help="that is measured, where it is not this checkout's")
    return parser.parse_args(arguments)


def machine(commit):
    """What the times depend on."""
    describe = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    return {
        "processor": processor(),
        "cores": os.cpu_count(),
        "load_before": os.getloadavg()[0],
        "date": time.strftime("%Y-%m-%d %H:%M"),
        "commit": commit
        or subprocess.run(describe, capture_output=True, text=True).stdout.strip()
        or "no git",
        **core.versions(),
    }


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.partition(":")[2].strip() for line in file if line.startswith("model name")]
    return names[0] if names else "unknown"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
