# SPDX-License-Identifier: GPL-3.0-or-later
"""The results as Markdown, each figure of FGMesh with its target."""
import operator
from typing import NamedTuple

COMPARE = {"<=": operator.le, ">=": operator.ge}


class Column(NamedTuple):
    title: str
    figure: str
    format: str
    sign: str = ""  # of the target; empty: there is none
    target: float = 0.0

    def head(self):
        return f"{self.title} ({self.sign} {self.target:{self.format}})" if self.sign else self.title

    def cell(self, figures, judged):
        if self.figure not in figures:
            return ""
        value = figures[self.figure]
        verdict = ""
        if judged and self.sign:
            verdict = " met" if COMPARE[self.sign](value, self.target) else " **not met**"
        return f"{value:{self.format}}{verdict}"


CASE_COLUMNS = (
    Column("tets", "tets", "d"),
    Column("above", "above", "d", "<=", 0),
    Column("eta", "eta", ".1f", "<=", 16),
    Column("smallest angle", "dihedral_min", ".1f", ">=", 10.9),
    Column("largest", "dihedral_max", ".1f", "<=", 164),
    Column("mean variation", "variation_mean", ".4f", ">=", 0.065),
    Column("time, s", "seconds", ".2f"),
    Column("search, s", "search_seconds", ".1f"),
    Column("time / search", "part_of_search", ".2f", "<=", 1),
    Column("tets / FGMesh", "tets_ratio", ".2f"),
    Column("time / FGMesh", "time_ratio", ".2f"),
)
STUDY_COLUMNS = (
    Column("tets", "tets", "d"),
    Column("above", "above", "d", "<=", 0),
    Column("smallest angle", "dihedral_min", ".1f", ">=", 10),
    Column("largest", "dihedral_max", ".1f", "<=", 164),
    Column("mean variation", "variation_mean", ".4f"),
    Column("facet centres off, mm", "deviation", ".4f"),
    Column("of what is allowed", "part_of_deviation", ".1%", "<=", 1),
    Column("volume off", "volume_error", ".3%", "<=", 0.002),
    Column("time, s", "seconds", ".2f"),
)


def in_markdown(results):
    """The two tables and what the machine was doing."""
    machine = results["machine"]
    parts = [
        f"Threshold {results['threshold']:g}, {machine['commit']}. Times: medians of {results['repeat']}; "
        f"load {machine['load_before']:.1f} before and {machine['load_after']:.1f} after, "
        f"{machine['cores']} cores."
    ]
    rows = [
        ([name, way], derived(ways, way), way == "FGMesh")
        for name, ways in results["cases"].items()
        for way in ways
    ]
    parts.append(table(["after the material stage", "by"], CASE_COLUMNS, rows))
    rows = [([name], figures, True) for name, figures in results["studies"].items()]
    parts.append(table(["whole pipeline"], STUDY_COLUMNS, rows))
    return "\n\n".join(parts + [f"**NOT SOUND** {line}" for line in unsound(results)])


def unsound(results):
    """A line for each mesh with faults."""
    meshes = {f"{name}, {way}": ways[way] for name, ways in results["cases"].items() for way in ways}
    meshes.update(results["studies"])
    return [
        f"{name}: {'; '.join(figures['faults'])}" for name, figures in meshes.items() if figures["faults"]
    ]


def derived(ways, way):
    """The figures of one way of meshing, its ratios to FGMesh and its time as part of gmsh's search."""
    figures, own = ways[way], ways["FGMesh"]
    return {
        **figures,
        "tets_ratio": figures["tets"] / own["tets"],
        "time_ratio": figures["seconds"] / own["seconds"],
        "part_of_search": figures["seconds"] / ways["gmsh"]["search_seconds"],
    }


def table(heads, columns, rows):
    """Markdown. rows: (labels, figures, whether the targets are theirs)."""
    lines = [[*heads, *(column.head() for column in columns)], ["---"] * (len(heads) + len(columns))]
    lines += [
        [*labels, *(column.cell(figures, judged) for column in columns)] for labels, figures, judged in rows
    ]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
