# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents opened by another FreeCAD: with this workbench, without it, with an older one's objects."""
import json

import pytest


@pytest.fixture
def saved(mesh, tmp_path):
    """The path of a document with a meshed box; the mesh has as many tetrahedra as the fixture `mesh`."""
    path = str(tmp_path / "part.FCStd")
    mesh.Document.saveAs(path)
    return path


def test_reopened_with_the_workbench(saved, mesh, in_fresh_freecad):
    answer = in_fresh_freecad(
        f"""
import FreeCAD
document = FreeCAD.openDocument({saved!r})
mesh, box = document.FGMesh, document.Box
fem = mesh.FemMesh
answer = [mesh.Proxy.__class__.__module__, mesh.Status, mesh.TetCount, fem.VolumeCount, fem.GroupCount]
for thing in document.Objects:
    thing.touch()
document.recompute()
answer.append(mesh.Status)
box.FGM_h = 60
document.recompute()
answer.append(mesh.Status)
import freecad.fgmesh as fgmesh
fgmesh.generate(mesh)
answer += [mesh.Status, max(mesh.Fractions), mesh.getEditorMode("Status")]
answer += [len(mesh.Fractions) - mesh.PointCount]
"""
    )
    count = mesh.TetCount
    assert answer[:6] == [
        "freecad.fgmesh.model.mesh_object",
        "ok",
        count,
        count,
        mesh.FemMesh.GroupCount,
        "ok",
    ]
    assert answer[6] == "out of date: FGM_h was 30, is 60"
    assert answer[7:] == ["ok", pytest.approx(0.5), ["ReadOnly"], 0]


def test_booleans_of_placed_solids_stay_up_to_date(
    document, placement, fgmesh, coarse_mesh, tmp_path, in_fresh_freecad
):
    """Computed again after reopening such a solid has other last digits, seams and tolerances."""
    box = document.addObject("Part::Box", "Box")
    box.Placement = placement
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 4
    ball.Placement = placement
    cut = document.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool, cut.Placement = box, ball, placement
    document.recompute()
    coarse_mesh(fgmesh.attach_material(cut, "0.5+0*z"))
    path = str(tmp_path / "cut.FCStd")
    document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import FreeCAD
document = FreeCAD.openDocument({path!r})
for thing in document.Objects:
    thing.touch()
document.recompute()
answer = document.FGMesh.Status
"""
    )
    assert answer == "ok"


def test_opened_and_saved_without_the_workbench(saved, mesh, in_fresh_freecad):
    answer = in_fresh_freecad(
        f"""
import FreeCAD
document = FreeCAD.openDocument({saved!r})
mesh = document.FGMesh
answer = [mesh.Status, mesh.TetCount, mesh.FemMesh.VolumeCount, mesh.FemMesh.GroupCount, mesh.Shape.Name]
answer += [document.Box.FGMFractions, document.Box.FGM_h]
document.recompute()
document.save()
""",
        with_workbench=False,
    )
    count = mesh.TetCount
    assert answer == ["ok", count, count, mesh.FemMesh.GroupCount, "Box", ["z/h"], 30.0]

    answer = in_fresh_freecad(
        f"""
import FreeCAD
import freecad.fgmesh as fgmesh
document = FreeCAD.openDocument({saved!r})
mesh = document.FGMesh
answer = [mesh.TetCount, mesh.FemMesh.VolumeCount]
fgmesh.generate(mesh)
document.Box.FGM_h = 60
document.recompute()
answer.append(mesh.Status)
"""
    )
    assert answer == [count, count, "out of date: FGM_h was 30, is 60"]


def test_properties_of_a_later_version_are_added(mesh, tmp_path, in_fresh_freecad):
    for name in ("Seed", "MaxSize", "VariationMean"):
        assert mesh.removeProperty(name)
    path = str(tmp_path / "old.FCStd")
    mesh.Document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import FreeCAD
document = FreeCAD.openDocument({path!r})
mesh = document.FGMesh
document.recompute()
answer = [mesh.Seed, mesh.MaxSize.Value, mesh.VariationMean, mesh.MaterialThreshold, mesh.Status]
"""
    )
    assert answer == [0, 0, 0, 0.3, "ok"]


def test_a_mesh_from_before_there_was_a_certificate_stays_up_to_date(mesh, tmp_path, in_fresh_freecad):
    fingerprint, report = json.loads(mesh.Fingerprint), json.loads(mesh.Report)
    del fingerprint["options"]["Certify"]
    report["certified"] = {}
    mesh.Fingerprint, mesh.Report = json.dumps(fingerprint), json.dumps(report)
    assert mesh.removeProperty("Certify")
    path = str(tmp_path / "older.FCStd")
    mesh.Document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import FreeCAD
document = FreeCAD.openDocument({path!r})
document.recompute()
answer = [document.FGMesh.Status, document.FGMesh.Certify]
"""
    )
    assert answer == ["ok", True]
