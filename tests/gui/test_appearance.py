# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels on a small and on a sharp screen, in the dark, and in German: nothing is cut off, all can be read."""
import itertools

import numpy as np
import pytest

LOOKS = {
    "small": dict(screen="1280x720x24"),
    "sharp": dict(
        screen="3840x2160x24", environment=dict(QT_SCALE_FACTOR="2", QT_AUTO_SCREEN_SCALE_FACTOR="0")
    ),
    "dark": dict(screen="1400x900x24", groups={"MainWindow": {"StyleSheet": "Dark-blue.qss"}}),
    "darker": dict(screen="1400x900x24", groups={"MainWindow": {"StyleSheet": "ProDark.qss"}}),
    "german": dict(screen="1280x720x24", groups={"General": {"Language": "German"}}),
}

PANELS = """
import freecad.fgmesh as fgmesh
import looks

cut, contrasts = {}, {}

def look(panel, anchor, message=None):
    settle(0.3)
    cut[panel] = looks.cut_texts(anchor)
    if message:
        label = widget(message)
        contrasts[panel] = [label.kind, label.text(), looks.contrast(label)]
    picture(f"{pictures}/look-{name}-{panel.replace(' ', '-')}.png")

document = FreeCAD.newDocument("Part")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
fresh_view(document)
fgmesh.attach_material(part, "0.02*exp(z/alpha)", {"alpha": 14}, constituents=["Steel-Generic", "Aluminum-Generic"])

select(part)
command("FGMesh_Material")
choose("FGMeshSectionAxis", "Y")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "warning")
look("material, warning", "FGMeshFormula", "FGMeshFormulaMessage")
bar, scale = looks.colour_bar_pixels()
write("FGMeshFormula", "exp(-z*depth)")
wait_until(lambda: widget("FGMeshFormulaMessage").kind == "error")
look("material, error", "FGMeshFormula", "FGMeshFormulaMessage")
panel_button("Cancel")

fgmesh.attach_material(part, "(z/60)^n", {"n": 2})
select(part)
command("FGMesh_Preview")
settle(0.3)
look("preview", "FGMeshQuantity")
panel_button("Close")

select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0.3")
write("FGMeshMinSize", "small")
settle(0.2)
look("mesh, error", "FGMeshMinSize", "FGMeshRunMessage")
write("FGMeshMinSize", "")
click("FGMeshStart")
wait_until(lambda: document.getObject("FGMesh") is not None and widget("FGMeshStart").isEnabled(), 60)
look("mesh, done", "FGMeshMinSize")
click("FGMeshOpenReport")
settle(0.5)
look("report", "FGMeshStages")
around = looks.ink(widget("FGMeshCertificate"))
area = widget("FGMeshPlot")
while not isinstance(area, QtGui.QScrollArea):
    area = area.parent()
area.ensureWidgetVisible(widget("FGMeshPlot"))
settle(0.3)
plot = looks.ink(widget("FGMeshPlot")), around
panel_button("Close")
document.FGMesh.MaterialThreshold = 0.05
select(document.FGMesh)
command("FGMesh_Report")
look("report, out of date", "FGMeshStages", "FGMeshStatus")
panel_button("Close")
select(document.FGMesh)
command("FGMesh_Analysis")
wait_until(lambda: widget("FGMeshAnalysisMessage").kind == "error")
look("analysis, out of date", "FGMeshMode", "FGMeshAnalysisMessage")
panel_button("Cancel")
return dict(cut=cut, contrasts=contrasts, plot=plot, bar=[looks.text_contrast(bar[: bar.shape[0] // 6]), *bar.shape[:2], scale])
"""


@pytest.mark.parametrize("name", LOOKS)
def test_nothing_is_cut_and_all_is_readable(drive, preferences, name):
    how = LOOKS[name]
    answer = drive(
        f"name = {name!r}\n" + PANELS,
        screen=how["screen"],
        settings=preferences(how.get("groups")),
        **how.get("environment", {}),
    )
    assert answer["cut"] == {panel: [] for panel in answer["cut"]}
    assert {kind for kind, *_ in answer["contrasts"].values()} == {"error", "warning"}
    for panel, (_, text, contrast) in answer["contrasts"].items():
        assert text and contrast >= 4.5, (panel, text, contrast)
    (background, contrast), (around, _) = answer["plot"]
    assert background == around and contrast >= 4.5, "the histogram is not of the panel's colours"
    contrast, height, width, scale = answer["bar"]
    assert contrast >= 4.5
    assert height > 250 * scale and width > 80 * scale
    assert scale >= 1.5 or name != "sharp"


def test_icons_differ_and_are_seen_at_16_pixels(drive, source_dir):
    folder = str(source_dir / "icons")
    answer = drive(
        f"""
import pathlib
import looks
from PySide import QtCore, QtGui, QtSvg
drawn = {{}}
for path in sorted(pathlib.Path({folder!r}).glob("*.svg")):
    image = QtGui.QImage(16, 16, QtGui.QImage.Format_ARGB32)
    image.fill(QtGui.QColor("#f0f0f0"))
    painter = QtGui.QPainter(image)
    QtSvg.QSvgRenderer(str(path)).render(painter, QtCore.QRectF(0, 0, 16, 16))
    painter.end()
    drawn[path.stem] = looks.pixels_of(image).tolist()
return dict(drawn=drawn)
"""
    )
    drawn = {name: np.array(pixels, int) for name, pixels in answer["drawn"].items()}
    assert {
        "preferences-fgmesh",
        "material",
        "preview",
        "mesh",
        "mesh-outdated",
        "report",
        "examples",
    } <= set(drawn)
    for name, pixels in drawn.items():
        painted = (np.abs(pixels - 240).max(axis=2) > 40).mean()
        assert 0.2 < painted < 0.95, name
    for (one, first), (two, second) in itertools.combinations(drawn.items(), 2):
        differing = (np.abs(first - second).max(axis=2) > 40).mean()
        assert differing > 0.1, f"{one} and {two} look alike"
