# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run found, as text, in the manner of the paper's table 1."""
from freecad.fgmesh.core import report

HEADERS = ("stage", "points", "facets", "tets", "variation min/max/mean", "dihedral min/max", "seconds")


def summary(result):
    """The table of the stages, then one line each for the figures of the whole mesh."""
    figures = report(result)
    lines = table([HEADERS, *(_row(stage) for stage in figures["stages"])])
    above = f"{len(result.above_threshold)} of {len(result.tets)}"
    asked = figures["surface_deviation"]
    lines += [
        "",
        f"element ratio eta   {figures['element_ratio']:.2f}",
        f"deviation           {figures['deviation_max']:.4g} mm (at most {asked:.4g} asked)",
        f"volume              {figures['volume']:.6g} mm^3 (the shape: {figures['shape_volume']:.6g})",
        f"above threshold     {above} tets (threshold {figures['threshold']:g})",
    ]
    if figures["certified"]:
        lines.append(f"certified           {certified(figures['certified'])}")
    forced, others = figures["forced_angles"], figures["small_angles"]
    if forced or others:
        goal = f"below {figures['angle_goal']:g} degrees"
        lines.append(f"small angles        {forced} tets forced by the shape, {others} others ({goal})")
    if figures["order"] == 2:
        off = f"{figures['straightened']} middle nodes off the true boundary"
        lines.append(f"second order        {figures['points']} points, {off}")
    return "\n".join(lines)


def certified(figures):
    """What is proved between corners, from "certified" of a report."""
    proved = figures["tets"] - figures["broken"] - figures["unproved"]
    if figures["holds"]:
        return f"all of each tet, at most {figures['bound']:.4f} ({figures['seconds']:.2f} s)"
    left = f"{figures['broken']} broken, {figures['unproved']} not proved"
    return f"{proved} of {figures['tets']} tets, {left} ({figures['seconds']:.2f} s)"


def table(rows):
    """Aligned lines: the first column to the left, all others to the right."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return [
        "  ".join(
            cell.rjust(width) if column else cell.ljust(width)
            for column, (cell, width) in enumerate(zip(row, widths))
        )
        for row in rows
    ]


def _row(stage):
    variation, dihedral = stage["variation"], stage["dihedral"]
    return (
        stage["name"],
        str(stage["points"]),
        str(stage["facets"]),
        str(stage["tets"]),
        f"{variation['min']:.4f} / {variation['max']:.4f} / {variation['mean']:.4f}",
        f"{dihedral['min']:.2f} / {dihedral['max']:.2f}",
        f"{stage['seconds']:.2f}",
    )
