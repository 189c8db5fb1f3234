# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes coloured, cut and with tetrahedra pointed out, in a real window."""
import pytest

LOOKS = """
import freecad.fgmesh
from freecad.fgmesh.view import mesh_look


def look():
    document = FreeCAD.openDocument(given["document"])
    mesh = document.FGMesh
    document.Box.Visibility = False
    view = FreeCADGui.activeDocument().activeView()
    view.viewFront()
    view.fitAll()
    settle(0.5)
    document.saveAs(given["copy"])
    picture(given["plain"])
    state = lambda: [document.UndoCount, FreeCADGui.activeDocument().Modified, mesh.Status, list(mesh.State)]
    before = state()
    modes = mesh.ViewObject.RootNode.getNumChildren()

    mesh_look.colour_by_fraction(mesh)
    picture(given["coloured"])
    answer["places"] = [[z / 10, on_screen(view, (4.8, 0, z))[0]] for z in (0.6, 2.3, 5.1, 7.7, 9.4)]
    mesh_look.cut(mesh, (FreeCAD.Vector(0, 0, 5), FreeCAD.Vector(0, 0, 1)))
    picture(given["cut"])
    answer["cut"] = {"left": on_screen(view, (5, 0, 2))[0], "gone": on_screen(view, (5, 0, 9.7))[0]}
    mesh_look.cut(mesh, None)
    picture(given["whole"])
    mesh_look.show_worst(mesh, [0, 7])
    picture(given["worst"])
    centres = mesh.ViewObject.Proxy.look.faces.centres[[0, 7]]
    answer["dots"] = [on_screen(view, centre)[0] for centre in centres]
    answer["state"] = [before, state()]
    mesh.ViewObject.Visibility = False
    picture(given["hidden"])
    mesh.ViewObject.Visibility = True
    mesh_look.show_plain(mesh)
    mesh_look.show_plain(mesh)
    picture(given["again"])
    answer["nodes"] = [modes, mesh.ViewObject.RootNode.getNumChildren()]
    mesh_look.colour_by_fraction(mesh)
    mesh.MaterialThreshold = 0.15
    freecad.fgmesh.generate(mesh)
    answer["nodes"].append(mesh.ViewObject.RootNode.getNumChildren())
    mesh_look.colour_by_fraction(mesh)
    answer["tets"] = [mesh.TetCount, len(mesh.ViewObject.Proxy.look.faces.tets)]
    FreeCAD.closeDocument(document.Name)
    settle(0.3)
"""


@pytest.fixture(params=[1, 2])
def saved_mesh(request, tmp_path, build_dir):
    """A document with a box of 10 mm, graded along z, and its mesh of this order."""
    import FreeCAD
    import freecad.fgmesh as fgmesh

    document = FreeCAD.newDocument("Meshed")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    mesh = fgmesh.make_mesh(document, fgmesh.attach_material(box, "z/10"))
    mesh.MaterialThreshold, mesh.SecondOrder = 0.2, request.param == 2
    fgmesh.generate(mesh)
    path = tmp_path / "mesh.FCStd"
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    return path


def test_looks(in_gui, saved_mesh, artifacts, tmp_path, build_dir, request):
    import numpy as np
    from freecad.fgmesh import colours
    from matplotlib import image

    names = ("plain", "coloured", "cut", "whole", "worst", "hidden", "again")
    order = request.node.callspec.id
    given = {name: str(artifacts / f"mesh-{name}-{order}.png") for name in names}
    answer = in_gui(LOOKS, document=saved_mesh, copy=tmp_path / "copy.FCStd", **given)
    seen = {name: image.imread(path)[:, :, :3] for name, path in given.items()}

    def around(name, place):
        x, y = (int(part) for part in place)
        return seen[name][y - 3 : y + 4, x - 3 : x + 4].reshape(-1, 3)

    for value, place in answer["places"]:
        away = np.abs(around("coloured", place) - colours.rgb([value])[0]).max(axis=1)
        assert np.median(away) < 0.04  # a black edge may cross the spot
    assert np.abs(around("cut", answer["cut"]["left"]) - colours.rgb([0.2])[0]).max(axis=1).min() < 0.04
    assert (around("cut", answer["cut"]["gone"]) == around("hidden", answer["cut"]["gone"])).all()
    assert (seen["whole"] == seen["coloured"]).mean() > 0.999  # a button of the window may differ
    for place in answer["dots"]:
        assert np.abs(around("worst", place) - colours.ABOVE).max(axis=1).min() < 0.1
    x, y = (int(part) for part in answer["places"][2][1])
    faint = seen["worst"][y - 60 : y + 60, x - 60 : x + 60].reshape(-1, 3)
    assert len(np.unique(faint, axis=0)) > 20  # edges, and the background behind
    assert (seen["again"] == seen["plain"]).mean() > 0.999  # a button of the window may differ
    assert len(set(answer["nodes"])) == 1
    assert answer["tets"][0] == answer["tets"][1]
    assert answer["state"][0] == answer["state"][1]
