# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the results of bench/run. Each function gives a figure of Matplotlib, or None where there is nothing to
draw. Only FGMesh has a strong colour; whoever cannot tell the others apart has the markers."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import tables  # noqa: E402

STYLES = {
    "FGMesh": ("#1b4f9c", "o"),
    "FGMesh, anisotropy 2": ("#4d8fd6", "^"),
    "FGMesh, anisotropy 3": ("#93bfe8", "v"),
    "gmsh": ("#c8561b", "s"),
    "gmsh HXT": ("#eda35c", "D"),
    "Netgen": ("#3a8a4d", "P"),
    "TetGen": ("#8b5fae", "X"),
    "CGAL": ("#b8982f", "*"),
    "local, longest edge": ("#555555", "<"),
    "local, steepest edge": ("#a0a0a0", ">"),
}
FLOOR = 1e-4
"""Smallest share of the angles that is drawn, %."""
RANDOM_ETA = 8.5
"""Element ratio of regular tetrahedra in random orientation where f is linear."""
plt.rcParams.update(
    {
        "svg.hashsalt": "fgmesh",
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#e6e6e6",
        "axes.axisbelow": True,
        "legend.frameon": False,
    }
)


def tets_against_threshold(results):
    """A panel for each case: how many tetrahedra each way takes to keep the threshold."""
    thresholds = {float(text): ways_of for text, ways_of in results.get("cases", {}).items()}
    names = list(dict.fromkeys(name for ways_of in thresholds.values() for name in ways_of))
    if not names:
        return None
    rows = -(-(len(names) + 1) // 3)
    figure, axes = plt.subplots(rows, 3, figsize=(9.5, 3.0 * rows), layout="constrained", squeeze=False)
    axes = axes.ravel()
    for panel, name in zip(axes, names):
        draw_case(panel, {threshold: ways_of.get(name, {}) for threshold, ways_of in thresholds.items()})
        panel.set_title(name, loc="left", fontsize=9)
    for panel in axes[len(names) :]:
        panel.axis("off")
    axes[len(names)].legend(*legend_of(axes[: len(names)]), loc="center", labelspacing=0.7)
    figure.supxlabel("material threshold, finer to the right", fontsize=9)
    figure.supylabel("tetrahedra", fontsize=9)
    return figure


def draw_case(panel, ways_at):
    """ways_at: {threshold: {way: figures}}."""
    for way, (colour, marker) in STYLES.items():
        points = sorted(
            (t, ways[way]["tets"]) for t, ways in ways_at.items() if tables.keeps_threshold(ways.get(way, {}))
        )
        if points:
            own = way == "FGMesh"
            panel.plot(
                *zip(*points),
                color=colour,
                marker=marker,
                label=way,
                lw=2.2 if own else 1.2,
                zorder=3 if own else 2,
            )
    floor = [
        (t, own["tets"] / own["eta"] * RANDOM_ETA)
        for t, ways in ways_at.items()
        if "eta" in (own := ways.get("FGMesh", {}))
    ]
    if floor:
        label = f"eta {RANDOM_ETA}: regular tetrahedra\nin random orientation"
        panel.plot(*zip(*sorted(floor)), color="#222222", lw=1, ls=":", label=label)
    panel.set(xscale="log", yscale="log")
    panel.set_xticks(sorted(ways_at), [f"{t:g}" for t in sorted(ways_at)])
    panel.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    panel.invert_xaxis()


def legend_of(axes):
    """Handles and labels of all panels, each once."""
    found = {}
    for panel in axes:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            found.setdefault(label, handle)
    return list(found.values()), list(found)


def angle_histograms(results):
    """A panel for each way: its dihedral angles over all cases at the threshold nearest to 0.1, FGMesh's as outline."""
    shares = pooled_angles(results)
    if not shares:
        return None
    rows = -(-len(shares) // 4)
    figure, axes = plt.subplots(
        rows,
        4,
        figsize=(9.5, 2.0 * rows + 0.3),
        layout="constrained",
        squeeze=False,
        sharex=True,
        sharey=True,
    )
    for panel, (way, share) in zip(axes.ravel(), shares.items()):
        bounds = np.linspace(0, 180, len(share) + 1)
        # From the floor on: not every program that shows the picture clips what is below.
        panel.stairs(np.maximum(100 * share, FLOOR), bounds, baseline=FLOOR, fill=True, color=STYLES[way][0])
        if way != "FGMesh" and "FGMesh" in shares:
            outline = np.maximum(100 * shares["FGMesh"], FLOOR)
            panel.stairs(outline, bounds, baseline=FLOOR, color=STYLES["FGMesh"][0], lw=1)
        panel.set_title(way, loc="left", fontsize=9)
        panel.set(yscale="log", ylim=(FLOOR, 50), xlim=(0, 180), xticks=range(0, 181, 45))
        panel.xaxis.set_tick_params(labelbottom=True)
    for panel in axes.ravel()[len(shares) :]:
        panel.axis("off")
    figure.supxlabel("dihedral angle, degrees", fontsize=9)
    figure.supylabel("share of the angles, %", fontsize=9)
    return figure


def pooled_angles(results):
    """{way: shares (bins,)} of all cases at the threshold nearest to 0.1, each case alike."""
    if not results.get("cases"):
        return {}
    ways_of = results["cases"][min(results["cases"], key=lambda text: abs(float(text) - 0.1))]
    found = {}
    for way in STYLES:
        counts = [
            np.array(ways[way]["dihedral_counts"], float)
            for ways in ways_of.values()
            if "dihedral_counts" in ways.get(way, {})
        ]
        if counts:
            found[way] = np.mean([one / one.sum() for one in counts], axis=0)
    return found


def time_against_tets(results):
    """One point for each mesh; for what takes a search left the run that ends it, right all that it takes."""
    ways_of = [ways for by_case in results.get("cases", {}).values() for ways in by_case.values()]
    if not ways_of:
        return None
    figure = plt.figure(figsize=(9.5, 4.0), layout="constrained")
    cells = figure.add_gridspec(1, 3, width_ratios=(1, 1, 0.4))
    first = figure.add_subplot(cells[0])
    panels = [first, figure.add_subplot(cells[1], sharex=first, sharey=first)]
    for way, (colour, marker) in STYLES.items():
        made = [ways[way] for ways in ways_of if tables.keeps_threshold(ways.get(way, {}))]
        if not made:
            continue
        tets = [one["tets"] for one in made]
        style = {
            "color": colour,
            "marker": marker,
            "ls": "",
            "ms": 6,
            "label": way,
            "zorder": 3 if way == "FGMesh" else 2,
        }
        panels[0].plot(tets, [one["seconds"] for one in made], **style)
        panels[1].plot(tets, [one["seconds"] + one.get("search_seconds", 0) for one in made], **style)
    for panel, title in zip(panels, ("one run, the constant known", "with the search for the constant")):
        panel.set(xscale="log", yscale="log", xlabel="tetrahedra that keep the threshold")
        panel.set_title(title, loc="left", fontsize=9)
    panels[0].set_ylabel("seconds")
    beside = figure.add_subplot(cells[2])
    beside.axis("off")
    beside.legend(*legend_of(panels), loc="center", labelspacing=0.8)
    return figure


PLOTS = {"tets": tets_against_threshold, "angles": angle_histograms, "times": time_against_tets}
