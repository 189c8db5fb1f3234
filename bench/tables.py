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


ESTIMATE_OFF = Column("expected off", "expected_off", ".0%", "<=", 0.3)
CERTIFICATE = Column("certificate, of the time", "part_of_certificate", ".0%")
CASE_COLUMNS = (
    Column("tets", "tets", "d"),
    Column("above", "above", "d", "<=", 0),
    Column("eta", "eta", ".1f", "<=", 12),
    Column("smallest angle", "dihedral_min", ".1f", ">=", 15),
    Column("largest", "dihedral_max", ".1f", "<=", 157),
    Column("mean variation / threshold", "variation_part", ".2f", ">=", 0.8),
    ESTIMATE_OFF,
    Column("time, s", "seconds", ".2f"),
    Column("search, s", "search_seconds", ".1f"),
    Column("runs", "search_runs", ".0f"),
    Column("time / search", "part_of_search", ".2f", "<=", 1),
    Column("time / gmsh run", "times_of_gmsh", ".2f", "<=", 3),
    Column("tets / FGMesh", "tets_ratio", ".2f"),
    Column("time / FGMesh", "time_ratio", ".2f"),
    CERTIFICATE,
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
    CERTIFICATE,
)
GEOMETRY_COLUMNS = (
    Column("tets", "tets", "d"),
    Column("for the material alone", "material_alone", "d"),
    Column("for the geometry alone", "geometry_alone", "d"),
    Column("times the larger", "times_the_larger", ".2f", "<=", 1.6),
    Column("above", "above", "d", "<=", 0),
    Column("smallest angle", "dihedral_min", ".1f", ">=", 12),
    Column("largest", "dihedral_max", ".1f"),
    Column("deviation, of what is allowed", "part_of_deviation", ".1%", "<=", 1),
    ESTIMATE_OFF,
    Column("time, s", "seconds", ".2f"),
    CERTIFICATE,
)
SCALING_COLUMNS = (
    Column("tets", "tets", ".0f"),
    Column("above", "above", ".0f", "<=", 0),
    Column("smallest angle", "dihedral_min", ".1f"),
    Column("time, s", "seconds", ".1f"),
    Column("microseconds a tet", "microseconds_a_tet", ".1f"),
    Column("growth", "growth", ".2f", "<=", 1.5),
    Column("memory, MB", "memory_mb", ".0f"),
    Column("KB a tet", "kilobytes_a_tet", ".2f", "<=", 1.5),
)
THREAD_COLUMNS = (
    Column("tets", "tets", ".0f"),
    Column("threads used", "used", ".0f"),
    Column("time, s", "seconds", ".2f"),
    Column("times faster", "gain", ".2f", ">=", 1.5),
    Column("different meshes", "different_meshes", "d", "<=", 0),
)
SECTIONS = {
    "studies": ("whole pipeline", STUDY_COLUMNS),
    "geometry": ("deviation of the diagonal / 500", GEOMETRY_COLUMNS),
    "scaling": ("finer and finer", SCALING_COLUMNS),
    "threads": ("threads", THREAD_COLUMNS),
}
OWN = "FGMesh"
COARSEST = 0.1
"""The largest threshold that targets are given for."""


def in_markdown(results):
    """The tables, and what the machine was doing."""
    machine = results["machine"]
    parts = [
        f"{machine['commit']}, {machine['date']}, {machine.get('processor', '')}. Times: medians of "
        f"{results['repeat']}; load {machine['load_before']:.1f} before and {machine['load_after']:.1f} after, "
        f"{machine['cores']} cores."
    ]
    for threshold, ways_of in results.get("cases", {}).items():
        rows = [
            (
                [name, label(ways[way], way)],
                derived(ways, way, float(threshold)),
                way == OWN and float(threshold) <= COARSEST,
            )
            for name, ways in ways_of.items()
            for way in ways
        ]
        parts.append(table([f"threshold {threshold}, after the material stage", "by"], CASE_COLUMNS, rows))
    for section, (head, columns) in SECTIONS.items():
        rows = [([name], with_parts(figures), True) for name, figures in results.get(section, {}).items()]
        if rows:
            parts.append(table([head], columns, rows))
    return "\n\n".join(parts + [f"**NOT SOUND** {line}" for line in unsound(results)])


def label(figures, way):
    """The name of a way, and why there is nothing beside it."""
    return f"{way}: {' '.join(figures['failed'].split())}" if "failed" in figures else way


def meshes(results):
    """{"case at threshold, way" or the name of another mesh: figures} of all that were made."""
    found = {
        f"{name} at {threshold}, {way}": derived(ways, way, float(threshold))
        for threshold, ways_of in results.get("cases", {}).items()
        for name, ways in ways_of.items()
        for way in ways
        if "tets" in ways[way]
    }
    for section in SECTIONS:
        for name, figures in results.get(section, {}).items():
            found[f"{name}, {section}"] = with_parts(figures)
    return found


def unsound(results):
    """A line for each mesh with faults, and for each that FGMesh has not made."""
    found = [
        f"{name}: {'; '.join(figures['faults'])}"
        for name, figures in meshes(results).items()
        if figures.get("faults")
    ]
    return found + [
        f"{name} at {threshold}, {label(figures, way)}"
        for threshold, ways_of in results.get("cases", {}).items()
        for name, ways in ways_of.items()
        for way, figures in ways.items()
        if way.startswith(OWN) and "failed" in figures
    ]


def derived(ways, way, threshold):
    """The figures of one way of meshing, beside those of FGMesh and of gmsh where there are any."""
    figures, own, gmsh = ways[way], ways.get(OWN, {}), ways.get("gmsh", {})
    if "tets" not in figures:
        return {}
    found = {**with_parts(figures), "variation_part": figures["variation_mean"] / threshold}
    if "tets" in own:
        found["tets_ratio"] = figures["tets"] / own["tets"]
        found["time_ratio"] = figures["seconds"] / own["seconds"]
    if "tets" in gmsh:
        found["part_of_search"] = figures["seconds"] / gmsh["search_seconds"]
        found["times_of_gmsh"] = figures["seconds"] / gmsh["seconds"]
    return found


def with_parts(figures):
    """Figures with how far the expected number of tetrahedra is off, and what part of the time the certificate took."""
    found = dict(figures)
    if "expected_tets" in figures:
        found["expected_off"] = abs(figures["expected_tets"] / figures["tets"] - 1)
    if "certificate_seconds" in figures:
        found["part_of_certificate"] = figures["certificate_seconds"] / figures["seconds"]
    return found


def table(heads, columns, rows):
    """Markdown, without columns that no row has a figure for. rows: (labels, figures, whether the targets are theirs)."""
    columns = [column for column in columns if any(column.figure in figures for _, figures, _ in rows)]
    lines = [[*heads, *(column.head() for column in columns)], ["---"] * (len(heads) + len(columns))]
    lines += [
        [*labels, *(column.cell(figures, judged) for column in columns)] for labels, figures, judged in rows
    ]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def summary(results):
    """The README's table: each way over all cases, counts and times as multiples of FGMesh's, at each threshold."""
    thresholds = [text for text in results["cases"] if float(text) <= COARSEST]
    ways = list(
        dict.fromkeys(way for text in thresholds for ways in results["cases"][text].values() for way in ways)
    )
    heads = ["mesher"]
    for text in thresholds:
        heads += [f"tets at {text}", "a run", "with the search"]
    lines = [[*heads, "dihedral angles"], ["---"] * (len(heads) + 1)]
    for way in ways:
        cells, angles = [], []
        for text in thresholds:
            by_case = results["cases"][text].values()
            made = [derived(case, way, float(text)) for case in by_case if keeps_threshold(case.get(way, {}))]
            cells += [span(one["tets_ratio"] for one in made), *time_spans(made)]
            if made and len(made) < len(by_case):
                cells[-3] += f" ({len(made)} of {len(by_case)})"
            angles += [one[end] for one in made for end in ("dihedral_min", "dihedral_max")]
        lines.append([way, *cells, f"{min(angles):.1f} to {max(angles):.1f}" if angles else "none"])
    machine = results["machine"]
    told = (
        f"Measured at commit {machine['commit']}, {machine['date'][:10]}, on {machine['cores']} cores "
        f"({machine.get('processor', 'unknown')}), load {machine['load_before']:.1f} to {machine['load_after']:.1f}; "
        f"times of {results['repeat']} run{'s' if results['repeat'] > 1 else ''}, limit {results['limit']:g} s."
    )
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n\n" + told


def keeps_threshold(figures):
    return "tets" in figures and figures["above"] == 0


def time_spans(made):
    """Of one run, and of the search with it."""
    runs = [one["time_ratio"] for one in made]
    searches = [
        ratio * (one["seconds"] + one["search_seconds"]) / one["seconds"]
        for ratio, one in zip(runs, made)
        if "search_seconds" in one
    ]
    return span(runs), span(searches) if searches else ""


def span(values):
    """The smallest and the largest of some ratios in words."""
    values = sorted(values)
    if not values:
        return "none"
    ends = [f"{value:.2g}" for value in (values[0], values[-1])]
    return ends[0] if ends[0] == ends[1] else " to ".join(ends)
