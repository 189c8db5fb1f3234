# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes and reports, like those of the paper. Needs neither FreeCAD nor the compiled part.

    xvfb-run -a /usr/bin/python3 -m freecad.fgmesh.pictures MESH.vtu... REPORT.json...

Beside MESH.vtu appear MESH-mesh.png (seen from outside) and MESH-cut.png (whole tetrahedra behind a plane),
both coloured by the fraction of the first constituent; beside REPORT.json REPORT-variation.png and
REPORT-dihedral.png. VTK draws through an X server even into memory: without a display, xvfb-run gives it one.
"""
import json
import sys
from pathlib import Path

import numpy as np

from freecad.fgmesh.colours import SIZE, table

WIDTH, HEIGHT = 1400, 1100
STAGE_NAMES = {"initial": "I-Mesh", "material": "M-Mesh", "geometry": "G-Mesh"}  # as the paper calls them


def read_tets(path):
    """Points (n, 3), corners (m, 4) of the tetrahedra and the first fraction (n,) of a .vtu file of FGMesh."""
    import meshio

    mesh = meshio.read(path)
    (tets,) = (block.data[:, :4] for block in mesh.cells if block.type in ("tetra", "tetra10"))
    return mesh.points, tets, mesh.point_data["fraction_1"]


def draw_mesh(points, tets, fraction, path):
    """Writes to `path` (.png) the mesh as seen from outside."""
    _render(points, tets, fraction, _view_axis(points), path)


def draw_cut(points, tets, fraction, path):
    """Writes to `path` (.png) the tetrahedra behind the middle of the part, each whole, as the paper does.

    The plane cuts across the part's shortest side, so that the cut is large.
    """
    axis = _view_axis(points)
    middle = (points[:, axis].min() + points[:, axis].max()) / 2
    behind = points[tets, axis].mean(axis=1) >= middle
    _render(points, tets[behind], fraction, axis, path)


def draw_variation(report, path):
    """Writes to `path` (.png) how the variation is distributed over the tetrahedra, stage by stage."""
    _save(plot_variation, report, path)


def draw_dihedral(report, path):
    """Writes to `path` (.png) how the dihedral angles are distributed, stage by stage."""
    _save(plot_dihedral, report, path)


def plot_variation(report, figure, translate=str):
    """Fills a matplotlib Figure: how the variation is distributed over the tetrahedra, stage by stage. Texts go
    through `translate`."""
    horizontal = translate("Variation of composition in a tetrahedron")
    axes = _stage_axes(figure, report, horizontal, translate("share of tetrahedra"), translate)
    for axis, stage in zip(axes, report["stages"]):
        _draw_bars(axis, stage["variation"]["histogram"])
        axis.axvline(report["threshold"], color="0.3", linestyle="--", linewidth=1)
        axis.text(
            report["threshold"],
            0.98,
            " " + translate("threshold"),
            transform=axis.get_xaxis_transform(),
            va="top",
        )
        cut_off = stage["variation"]["max"] > stage["variation"]["histogram"]["high"]
        note = "\n" + translate("last bar: all above") if cut_off else ""
        _annotate(axis, stage["variation"], translate("mean {mean:.4f}\nmax {max:.4f}") + note)


def plot_dihedral(report, figure, translate=str):
    """Fills a matplotlib Figure: how the dihedral angles are distributed, stage by stage. Texts go through
    `translate`."""
    horizontal = translate("Dihedral angle, degrees")
    axes = _stage_axes(figure, report, horizontal, translate("share of angles"), translate)
    for axis, stage in zip(axes, report["stages"]):
        _draw_bars(axis, stage["dihedral"]["histogram"])
        axis.set_xlim(0, 180)
        axis.set_xticks(range(0, 181, 30))
        _annotate(axis, stage["dihedral"], "min {min:.2f}°\nmax {max:.2f}°")


def _save(plot, report, path):
    from matplotlib.figure import Figure

    figure = Figure(figsize=(4.2 * len(report["stages"]), 3.4))
    plot(report, figure)
    figure.savefig(path, dpi=120)


def _stage_axes(figure, report, horizontal, vertical, translate):
    from matplotlib.ticker import PercentFormatter

    stages = report["stages"]
    figure.set_constrained_layout(True)
    axes = figure.subplots(1, len(stages), squeeze=False)
    for axis, stage in zip(axes[0], stages):
        axis.set_title(translate("{}: {} tetrahedra").format(STAGE_NAMES[stage["name"]], stage["tets"]))
        axis.set_xlabel(horizontal)
        axis.yaxis.set_major_formatter(PercentFormatter(1.0, decimals=0))
        axis.spines[["top", "right"]].set_visible(False)
    axes[0, 0].set_ylabel(vertical)
    return axes[0]


def _draw_bars(axis, histogram):
    counts = np.asarray(histogram["counts"], float)
    edges = np.linspace(histogram["low"], histogram["high"], len(counts) + 1)
    axis.bar(
        edges[:-1], counts / max(counts.sum(), 1), np.diff(edges), align="edge", color=table()[SIZE // 4]
    )


def _annotate(axis, figures, text):
    axis.text(0.93, 0.8, text.format(**figures), transform=axis.transAxes, ha="right", va="top")


def _view_axis(points):
    """The axis to look along: that of the part's shortest side; of equal ones Y, then X, then Z."""
    extents = np.ptp(points, axis=0)
    return min((1, 0, 2), key=lambda axis: round(extents[axis] / extents.max(), 3))


def _render(points, tets, fraction, axis, path):
    import vtk

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    colours = _colour_table()
    renderer.AddActor(_surface_actor(points, tets, fraction, colours))
    renderer.AddActor2D(_colour_bar(colours))
    _place_camera(renderer, points, axis)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH, HEIGHT)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def _surface_actor(points, tets, fraction, colours):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk

    grid = vtk.vtkUnstructuredGrid()
    corners = vtk.vtkPoints()
    corners.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=1))
    grid.SetPoints(corners)
    grid.SetCells(vtk.VTK_TETRA, _cell_array(tets))
    grid.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(fraction), deep=1))
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.55)
    look.SetDiffuse(0.5)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0, 0, 0)
    look.SetLineWidth(0.8)
    return actor


def _cell_array(tets):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtkIdTypeArray

    rows = np.column_stack([np.full(len(tets), 4), tets]).astype(np.int64)
    cells = vtk.vtkCellArray()
    cells.SetCells(len(tets), numpy_to_vtkIdTypeArray(rows.ravel(), deep=1))
    return cells


def _colour_table():
    import vtk

    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(SIZE)
    colours.SetRange(0, 1)
    for index, colour in enumerate(table().tolist()):
        colours.SetTableValue(index, *colour)
    return colours


def _colour_bar(colours):
    import vtk

    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle("volume fraction")
    bar.SetNumberOfLabels(6)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(24)
        text.BoldOff()
        text.ItalicOff()
        text.ShadowOff()
    bar.SetPosition(0.86, 0.2)
    bar.SetWidth(0.1)
    bar.SetHeight(0.6)
    bar.SetVerticalTitleSeparation(14)
    return bar


def _place_camera(renderer, points, axis):
    """Looks along `axis` from its low end, a little from the side and from above. Fits the whole part into
    the picture, so that both views of a mesh are alike, whatever the cut has left."""
    up = np.eye(3)[1 if axis == 2 else 2]
    ahead = np.eye(3)[axis]
    towards = 0.45 * np.cross(ahead, up) + 0.4 * up - ahead
    towards /= np.linalg.norm(towards)
    right = np.cross(up, towards) / np.linalg.norm(np.cross(up, towards))
    screen = np.column_stack([right, np.cross(towards, right), towards])
    low, high = (points @ screen).min(axis=0), (points @ screen).max(axis=0)
    width, height, depth = high - low
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*screen @ ((low + high) / 2))
    camera.SetPosition(*(screen @ ((low + high) / 2) + 2 * depth * towards))
    camera.SetViewUp(*up)
    camera.SetParallelScale(0.53 * max(height, width * HEIGHT / (0.78 * WIDTH)))
    camera.SetWindowCenter(0.14, 0)  # leaves the right margin to the colour bar
    renderer.ResetCameraClippingRange()


def main(paths):
    """Draws what belongs to each file of `paths`; prints the pictures' names."""
    for path in map(Path, paths):
        beside = path.with_suffix("")
        if path.suffix == ".json":
            report = json.loads(path.read_text(encoding="utf-8"))
            drawings = {"variation": draw_variation, "dihedral": draw_dihedral}
            arguments = (report,)
        else:
            drawings = {"mesh": draw_mesh, "cut": draw_cut}
            arguments = read_tets(path)
        for name, draw in drawings.items():
            picture = f"{beside}-{name}.png"
            draw(*arguments, picture)
            print(picture)


if __name__ == "__main__":
    main(sys.argv[1:])
