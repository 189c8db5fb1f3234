# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a run as a table: one column a stage, as in the paper's table 1."""
import csv

from freecad.fgmesh.io.atomic import replaced_together

ROWS = (
    ("points", ("points",), "d"),
    ("facets", ("facets",), "d"),
    ("tetrahedra", ("tets",), "d"),
    ("variation min", ("variation", "min"), ".4f"),
    ("variation max", ("variation", "max"), ".4f"),
    ("variation mean", ("variation", "mean"), ".4f"),
    ("above threshold", ("variation", "above_threshold"), "d"),
    ("angle min", ("dihedral", "min"), ".2f"),
    ("angle max", ("dihedral", "max"), ".2f"),
    ("seconds", ("seconds",), ".2f"),
)
"""Title, where the figure stands in a stage of the report, how it is written for a reader."""


def stage_rows(report):
    """[(title, [figure of each stage], format)]. A figure that does not exist is None or NaN."""
    return [(title, [_at(stage, path) for stage in report["stages"]], form) for title, path, form in ROWS]


def write_report_table(report, path):
    """Write the table and both histograms of the dict of `core.report` as CSV, as a whole or not at all.

    Histograms have one row a bin: its low and high end, the count in each stage. Raises OutputError.
    """
    with replaced_together(path) as (temporary,), open(temporary, "w", newline="", encoding="utf-8") as file:
        names = [stage["name"] for stage in report["stages"]]
        writer = csv.writer(file)
        writer.writerow(["figure", *names])
        writer.writerows([title, *figures] for title, figures, _ in stage_rows(report))
        for kind in ("variation", "dihedral"):
            histograms = [stage[kind]["histogram"] for stage in report["stages"]]
            writer.writerow([])
            writer.writerow([f"{kind} from", f"{kind} to", *names])
            writer.writerows(_bins(histograms))


def _bins(histograms):
    first = histograms[0]
    width = (first["high"] - first["low"]) / len(first["counts"])
    for place, counts in enumerate(zip(*(histogram["counts"] for histogram in histograms))):
        yield [f"{first['low'] + end * width:.6g}" for end in (place, place + 1)] + list(counts)


def _at(stage, path):
    for name in path:
        stage = stage[name]
    return stage
