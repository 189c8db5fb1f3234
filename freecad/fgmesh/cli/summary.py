# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run found, as text: the paper's table 1, and why a threshold is not met."""
import numpy as np

from freecad.fgmesh.core import report

HEADERS = ("stage", "points", "facets", "tets", "variation min/max/mean", "dihedral min/max", "seconds")


def summary(result):
    """The table of the stages, then one line each for the figures of the whole mesh."""
    figures = report(result)
    lines = table([HEADERS, *(_row(stage) for stage in figures["stages"])])
    lines += [
        "",
        f"element ratio eta   {figures['element_ratio']:.2f}",
        f"deviation           {figures['deviation_max']:.4g} mm (at most {figures['surface_deviation']:.4g} asked)",
        f"volume              {figures['volume']:.6g} mm^3 (the shape: {figures['shape_volume']:.6g})",
        f"above threshold     {len(result.above_threshold)} of {len(result.tets)} tets (threshold {figures['threshold']:g})",
    ]
    return "\n".join(lines)


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


def shortfall(result):
    """One line for a mesh that misses its threshold: how many tetrahedra, the worst one, and where."""
    above = np.asarray(result.above_threshold)
    if not len(above):
        return f"the mesh is written, but its status is {result.status!r}"
    variation = np.asarray(result.variation)[above]
    worst = above[np.argmax(variation)]
    corners = np.asarray(result.points)[np.asarray(result.tets)]
    centre = corners[worst].mean(axis=0)
    low, high = corners[above].min(axis=(0, 1)), corners[above].max(axis=(0, 1))
    return (
        f"{len(above)} of {len(result.tets)} tetrahedra are above the threshold {result.material_threshold:g}, "
        f"the worst by {variation.max():.4g} at ({_point(centre)}); all lie between ({_point(low)}) and ({_point(high)})"
    )


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


def _point(point):
    return ", ".join(f"{coordinate:.4g}" for coordinate in point)
