# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid coloured by a field in a real window: the right colours in the right places, and nothing left behind."""
import numpy as np
import pytest

COLOURS = """
from freecad.fgmesh.view.preview import Preview


def look():
    FreeCADGui.activateWorkbench("PartWorkbench")
    document = FreeCAD.newDocument("Colours")
    part = document.addObject("App::Part", "Part")
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(40, -20, 7), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 30, 20, 10
    box.Placement.Base = FreeCAD.Vector(3, 4, 5)
    part.addObject(box)
    document.recompute()
    view = FreeCADGui.activeDocument().activeView()
    view.viewTop()
    view.fitAll()
    settle(0.5)
    document.saveAs(given["document"])
    picture(given["before"])
    state = [document.UndoCount, FreeCADGui.activeDocument().Modified, list(box.State), box.ViewObject.Visibility]

    preview = Preview(box)
    preview.set_values(values_of(preview.points), "volume fraction of Steel-Generic")
    settle(0.3)
    picture(given["outside"])
    width, height = view.getSize()
    view.saveImage(given["saved"], width, height, "White")
    # x of the solid's own coordinates leads along y of the document's, and the upper side is at z = 22.
    answer["places"] = {}
    for x in (-0.15, 0.05, 0.2, 0.5, 0.75, 0.95):
        local = FreeCAD.Vector(3 + 30 * x, 4 + 3, 15) if x >= 0 else FreeCAD.Vector(6, 4 + 17, 15)
        point = part.Placement.multVec(local)
        value = float(values_of(np.array([tuple(local)]))[0])
        answer["places"][str(x)] = [value, on_screen(view, point)[0], view.getPointOnScreen(point)]
    preview.set_values(2 * values_of(preview.points) - 0.5, "twice", -0.5, 0.5)
    view.viewIsometric()
    picture(given["marked"])
    answer["state"] = [
        state,
        [document.UndoCount, FreeCADGui.activeDocument().Modified, list(box.State), box.ViewObject.Visibility],
    ]
    view.viewTop()
    preview.close()
    preview.close()
    settle(0.3)
    picture(given["after"])


def values_of(points):
    values = (points[:, 0] - 3) / 30
    values[points[:, 1] > 4 + 14.3] = np.nan
    return values
"""

SECTION = """
from freecad.fgmesh.view.preview import Preview


def look():
    document = FreeCAD.newDocument("Section")
    outer, inner = document.addObject("Part::Box", "Outer"), document.addObject("Part::Sphere", "Inner")
    outer.Length = outer.Width = outer.Height = 30
    inner.Radius, inner.Placement.Base = 8, FreeCAD.Vector(15, 15, 15)
    both = document.addObject("Part::Compound", "Both")
    both.Links = [outer, inner]
    document.recompute()
    outer.Visibility = inner.Visibility = False
    view = FreeCADGui.activeDocument().activeView()
    view.viewFront()
    view.fitAll()
    settle(0.5)
    calls = []

    def colour():
        calls.append(len(preview.points))
        # 1 - z/30 outside, z/30 inside
        up = preview.points[:, 2] / 30
        preview.set_values(np.where(preview.solids == 1, up, 1 - up), "volume fraction")

    preview = Preview(both, view, colour)
    colour()
    answer["fixed"] = preview.fixed
    preview.section = (FreeCAD.Vector(15, 15, 15), FreeCAD.Vector(0, -1, 0))
    settle(0.3)
    picture(given["cut"])
    places = {"inner low": (15, 15, 9), "inner high": (15, 15, 21), "outer low": (4, 15, 4), "outer high": (4, 15, 26)}
    answer["places"] = {name: on_screen(view, place)[0] for name, place in places.items()}
    answer["calls"] = list(calls)

    preview.drag_section()
    view.viewIsometric()
    view.fitAll()
    picture(given["handles"])
    origin, normal = preview.section
    size = 0.22 * 30 * 3**0.5
    start, end = (on_screen(view, origin + normal * along)[1] for along in (0.6 * size, 0.6 * size + 6))
    drag(view, start, end)
    answer["shifted"] = [list(vector) for vector in preview.section]
    origin, normal = preview.section
    start = on_screen(view, origin + normal * 1.25 * size)[1]
    drag(view, start, start + QtCore.QPointF(60, -60))
    answer["turned"] = [list(vector) for vector in preview.section]
    answer["calls_dragging"] = len(calls) - len(answer["calls"])
    picture(given["turned"])
    preview.drag_section(False)
    preview.section = None
    answer["points"] = [len(preview.points), len(preview.solids)]
    preview.close()
"""

LIFE = """
import gc
from freecad.fgmesh.view.preview import Preview


def memory():
    gc.collect()
    return int(open("/proc/self/statm").read().split()[1]) * 4096 / 2**20


def open_and_close(box):
    preview = Preview(box)
    preview.set_values(np.linspace(0, 1, len(preview.points)), "x")
    preview.drag_section()
    preview.close()


def look():
    document = FreeCAD.newDocument("Life")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    view = FreeCADGui.activeDocument().activeView()
    scene = view.getSceneGraph()
    counts = lambda: [scene.getNumChildren(), box.ViewObject.RootNode.getNumChildren(), scene.getRefCount()]
    open_and_close(box)
    before, memory_before = counts(), memory()
    for _ in range(150):
        open_and_close(box)
    settle()
    answer["counts"] = [before, counts()]
    answer["grown"] = memory() - memory_before

    preview = Preview(box)
    document.removeObject("Box")
    settle()
    preview.set_values(np.zeros(len(preview.points)), "deleted")
    preview.close()
    ball = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    preview = Preview(ball)
    preview.drag_section()
    FreeCAD.closeDocument("Life")
    settle(0.2)
    preview.close()
    preview.close()
    preview.section = ((0, 0, 0), (0, 0, 1))
    preview.drag_section()
    answer["alive"] = True
"""

PICKING = """
from freecad.fgmesh.view.preview import Preview


def look():
    document = FreeCAD.newDocument("Picking")
    body = document.addObject("PartDesign::Body", "Body")
    box = body.newObject("PartDesign::AdditiveBox", "Box")
    document.recompute()
    view = FreeCADGui.activeDocument().activeView()
    view.viewTop()
    view.fitAll()
    settle(0.3)
    preview = Preview(body)
    preview.set_values(preview.points[:, 0] / 10, "x")
    settle(0.3)
    place, area = on_screen(view, (5, 5, 10))
    picture(given["picture"])
    answer["middle"] = place
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    mouse(view, QtCore.QEvent.MouseMove, area, none, none)
    mouse(view, QtCore.QEvent.MouseButtonPress, area, left, left)
    mouse(view, QtCore.QEvent.MouseButtonRelease, area, left, none)
    answer["chosen"] = [list(one.SubElementNames) for one in FreeCADGui.Selection.getSelectionEx()]
"""


def pictures(artifacts, *names):
    return {name: str(artifacts / f"preview-{name}.png") for name in names}


def pixel(path, place):
    from matplotlib import image

    x, y = (int(part) for part in place)
    return image.imread(path)[y, x, :3]


def scale_colour(build_dir, value, low=0.0, high=1.0):
    from freecad.fgmesh import colours

    return colours.rgb([value], low, high)[0]


def test_colours_and_untouched_document(in_gui, artifacts, tmp_path, build_dir):
    from matplotlib import image

    given = pictures(artifacts, "before", "outside", "saved", "marked", "after")
    answer = in_gui(COLOURS, document=tmp_path / "part.FCStd", **given)
    height = image.imread(given["saved"]).shape[0]
    assert len(answer["places"]) == 6
    for value, in_window, (x, y) in answer["places"].values():
        value = np.nan if value is None else value
        wanted = scale_colour(build_dir, value)
        assert pixel(given["outside"], in_window) == pytest.approx(wanted, abs=0.03)
        assert pixel(given["saved"], (x, height - 1 - y)) == pytest.approx(wanted, abs=0.03)
    assert answer["state"][0] == answer["state"][1]
    assert (
        image.imread(given["before"]) == image.imread(given["after"])
    ).mean() > 0.999  # a button of the window may differ


def test_section_and_its_handles(in_gui, artifacts, build_dir):
    given = pictures(artifacts, "cut", "handles", "turned")
    answer = in_gui(SECTION, **given)
    wanted = {"inner low": 0.3, "inner high": 0.7, "outer low": 26 / 30, "outer high": 4 / 30}
    for name, value in wanted.items():
        found = pixel(given["cut"], answer["places"][name])
        assert found == pytest.approx(scale_colour(build_dir, value), abs=0.03), name
    assert len(answer["calls"]) == 2 and answer["calls"][0] == answer["fixed"] < answer["calls"][1]
    assert answer["points"] == [answer["fixed"]] * 2
    assert answer["calls_dragging"] >= 4
    (origin, normal), (turned_origin, turned_normal) = answer["shifted"], answer["turned"]
    assert origin == pytest.approx([15, 9, 15], abs=0.5)
    assert normal == pytest.approx([0, -1, 0])
    assert turned_origin == pytest.approx(origin)
    assert np.dot(normal, turned_normal) < 0.97
    assert np.linalg.norm(turned_normal) == pytest.approx(1)


def test_nothing_is_left_behind(in_gui):
    answer = in_gui(LIFE)
    assert answer["counts"][0] == answer["counts"][1]
    assert answer["grown"] < 40  # MB; one preview has 2 MB
    assert answer["alive"]


def test_faces_of_a_body_can_be_chosen_meanwhile(in_gui, artifacts, build_dir):
    given = pictures(artifacts, "picture")
    answer = in_gui(PICKING, **given)
    assert pixel(given["picture"], answer["middle"]) == pytest.approx(scale_colour(build_dir, 0.5), abs=0.03)
    ((name,),) = answer["chosen"]
    assert name.split(".")[-1] == "Face6"
