# SPDX-License-Identifier: GPL-3.0-or-later
"""The mark that a mesh no longer belongs to its solid, material or options."""
import time

import FreeCAD
import pytest


def set_box(name, value):
    return lambda mesh: setattr(mesh.Shape, name, value)


def set_mesh(name, value):
    return lambda mesh: setattr(mesh, name, value)


CHANGES = {
    "shape": (set_box("Length", 12), "shape"),
    "place": (set_box("Placement", FreeCAD.Placement()), "moved"),
    "formula": (set_box("FGMFractions", ["1-z/h"]), "formula"),
    "parameter": (set_box("FGM_h", 40.0), "FGM_h was 30, is 40"),
    "frame": (set_box("FGMFrame", FreeCAD.Placement(FreeCAD.Vector(0, 0, 1), FreeCAD.Rotation())), "frame"),
    "threshold": (set_mesh("MaterialThreshold", 0.2), "MaterialThreshold was 0.3, is 0.2"),
    "deviation": (set_mesh("SurfaceDeviation", 0.7), "SurfaceDeviation"),
    "stage": (set_mesh("StopAfter", "material"), "StopAfter"),
}


@pytest.mark.parametrize("change, told", CHANGES.values(), ids=CHANGES)
def test_change_and_back(mesh, change, told):
    solid = mesh.Shape
    watched = "Length Placement FGMFractions FGM_h FGMFrame".split()
    before = {name: getattr(solid, name) for name in watched}
    options = {name: getattr(mesh, name) for name in ("MaterialThreshold", "SurfaceDeviation", "StopAfter")}
    count = mesh.TetCount
    change(mesh)
    mesh.Document.recompute()
    assert mesh.Status.startswith("out of date: ") and told in mesh.Status
    assert mesh.TetCount == mesh.FemMesh.VolumeCount == count
    for thing, values in ((solid, before), (mesh, options)):
        for name, value in values.items():
            setattr(thing, name, value)
    mesh.Document.recompute()
    assert mesh.Status == "ok"


def test_options_are_marked_without_a_recompute(mesh):
    mesh.MaxSize = 3
    assert "MaxSize" in mesh.Status


def test_what_gives_no_other_mesh_is_not_marked(mesh):
    mesh.Threads = 1
    mesh.Shape.Label = "Another name"
    mesh.Shape.FGMConstituents = ["Copper-Generic", "Aluminum-Generic"]
    mesh.Document.recompute()
    assert mesh.Status == "ok"


def test_computed_again_is_not_marked(mesh):
    for thing in mesh.Document.Objects:
        thing.touch()
    mesh.Document.recompute()
    assert mesh.Status == "ok"


def test_spreadsheet_cells_are_followed(mesh):
    document = mesh.Document
    sheet = document.addObject("Spreadsheet::Sheet", "Cells")
    sheet.set("A1", "30")
    sheet.setAlias("A1", "height")
    document.recompute()
    mesh.Shape.setExpression("FGM_h", "Cells.height")
    document.recompute()
    assert mesh.Status == "ok"
    sheet.set("A1", "45")
    document.recompute()
    assert "FGM_h was 30, is 45" in mesh.Status


def test_a_lost_solid(mesh):
    mesh.Document.removeObject(mesh.Shape.Name)
    mesh.Document.recompute()
    assert "solid is gone" in mesh.Status


def test_meshing_again_clears_the_mark(mesh, fgmesh):
    mesh.Shape.Height = 20
    mesh.Shape.FGM_h = 20
    mesh.Document.recompute()
    assert mesh.Status.startswith("out of date")
    fgmesh.generate(mesh)
    assert mesh.Status == "ok"


def test_a_recompute_does_not_mesh(mesh):
    """A mesh of this threshold takes minutes; a recompute must not."""
    mesh.MaterialThreshold = 0.005
    mesh.Shape.Length = 10.5
    start = time.monotonic()
    mesh.Document.recompute()
    assert time.monotonic() - start < 1.0
