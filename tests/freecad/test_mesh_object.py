# SPDX-License-Identifier: GPL-3.0-or-later
"""make_mesh and generate: the mesh in the document, its groups and figures."""
import json
import math
import subprocess

import FreeCAD
import numpy as np
import pytest

READ_ONLY = (
    "Status PointCount FacetCount TetCount VariationMin VariationMax VariationMean "
    "DihedralMin DihedralMax Report"
).split()


def test_every_freecad_knows_its_type(mesh):
    """0.20 and 1.x have it; others that 1.x has 0.20 drops on opening, with all that is in them."""
    assert mesh.TypeId == "Fem::FemMeshObjectPython"


def nodes_of(mesh):
    """Coordinates (n, 3), node i + 1 in row i."""
    nodes = mesh.FemMesh.Nodes
    return np.array([nodes[number] for number in range(1, len(nodes) + 1)])


def tets_of(mesh):
    """Corner rows (m, 4) in the order that FreeCAD gives them back."""
    return np.array([mesh.FemMesh.getElementNodes(number)[:4] for number in mesh.FemMesh.Volumes]) - 1


def volume_of(mesh):
    corners = nodes_of(mesh)[tets_of(mesh)]
    edges = corners[:, 1:] - corners[:, :1]
    return np.abs(np.linalg.det(edges)).sum() / 6


def groups_of(mesh):
    fem = mesh.FemMesh
    return {fem.getGroupName(group): set(fem.getGroupElements(group)) for group in fem.Groups}


def contents_of(mesh):
    """All that a run writes but for `Status`, which tells what has changed since."""
    names = [name for name in READ_ONLY if name != "Status"]
    figures = {name: getattr(mesh, name) for name in names}
    return {**figures, "nodes": nodes_of(mesh).tolist(), "groups": groups_of(mesh)}


def assert_groups_fit(mesh, shape):
    groups = groups_of(mesh)
    faces = range(1, len(shape.Faces) + 1)
    wanted = {f"Face{n}" for n in faces} | {f"Face{n}_Nodes" for n in faces} | {"Solid1", "Solid1_Nodes"}
    assert {name for name in groups if name.startswith(("Face", "Solid"))} == wanted
    for number in faces:
        nodes = groups[f"Face{number}_Nodes"]
        assert nodes == set(mesh.FemMesh.getNodesByFace(shape.getElement(f"Face{number}")))
        of_triangles = {n for t in groups[f"Face{number}"] for n in mesh.FemMesh.getElementNodes(t)}
        assert nodes == of_triangles
    assert groups["Solid1"] == set(mesh.FemMesh.Volumes)
    assert len(set.union(*(groups[f"Face{n}"] for n in faces))) == mesh.FacetCount


def test_defaults_come_from_the_core(graded_box, fgmesh, core):
    mesh = fgmesh.make_mesh(graded_box.Document, graded_box)
    defaults = core.MeshingOptions()
    assert mesh.isDerivedFrom("Fem::FemMeshObject")
    assert mesh.Shape is graded_box
    assert mesh.MaterialThreshold == defaults.material_threshold
    assert mesh.SurfaceDeviation.Value == defaults.surface_deviation
    assert (mesh.MinSize.Value, mesh.MaxSize.Value) == (defaults.min_size, defaults.max_size)
    assert mesh.SurfaceDeviation.Unit == FreeCAD.Units.Length
    assert (mesh.Anisotropy, mesh.SecondOrder) == (defaults.anisotropy, defaults.order == 2)
    assert mesh.Certify is defaults.certify is True
    assert mesh.StopAfter == defaults.stop_after
    assert mesh.Status == "not meshed yet"
    assert all("ReadOnly" in mesh.getEditorMode(name) for name in READ_ONLY)
    assert all(mesh.getDocumentationOfProperty(name) for name in READ_ONLY + ["MaterialThreshold", "MinSize"])


def test_every_core_option_has_its_property(core):
    from freecad.fgmesh.model.options import OPTIONS

    fields = {name for name in dir(core.MeshingOptions) if not name.startswith("_")}
    fields = {name for name in fields if not callable(getattr(core.MeshingOptions(), name))}
    assert {option.field for option in OPTIONS} == fields


def test_options_reach_the_core(mesh):
    from freecad.fgmesh.model.options import options_of

    mesh.SurfaceDeviation = "0.5 cm"
    mesh.StopAfter = "material"
    mesh.Seed = -1
    options = options_of(mesh)
    assert options.material_threshold == 0.3
    assert options.surface_deviation == pytest.approx(5.0)  # mm
    assert options.stop_after == "material"
    assert options.order == 1


def test_the_certificate_is_in_the_report_unless_turned_off(mesh, fgmesh):
    figures = json.loads(mesh.Report)["certified"]
    assert figures["holds"] is True and figures["tets"] == mesh.TetCount
    assert figures["bound"] == pytest.approx(mesh.VariationMax)  # z/h changes evenly
    mesh.Certify = False
    assert mesh.Status == "out of date: Certify was True, is False"
    fgmesh.generate(mesh)
    assert json.loads(mesh.Report)["certified"] == {} and mesh.Status == "ok"


def test_placed_box(mesh, graded_box):
    assert mesh.Status == "ok"
    assert volume_of(mesh) == pytest.approx(10 * 20 * 30)
    assert mesh.Placement.isIdentity()
    assert_groups_fit(mesh, graded_box.Shape)
    inside = graded_box.Placement.inverse()
    own = np.array([inside.multVec(FreeCAD.Vector(*point)) for point in nodes_of(mesh)])
    assert own.min(axis=0) == pytest.approx([0, 0, 0], abs=1e-6)
    assert own.max(axis=0) == pytest.approx([10, 20, 30], abs=1e-6)
    assert mesh.Fractions == pytest.approx(own[:, 2] / 30)


def test_figures_are_those_of_the_mesh(mesh):
    assert mesh.PointCount == mesh.FemMesh.NodeCount
    assert mesh.FacetCount == mesh.FemMesh.FaceCount
    assert mesh.TetCount == mesh.FemMesh.TetraCount == mesh.FemMesh.VolumeCount
    variation = np.ptp(np.array(mesh.Fractions)[tets_of(mesh)], axis=1)
    figures = (mesh.VariationMin, mesh.VariationMax, mesh.VariationMean)
    assert figures == pytest.approx((variation.min(), variation.max(), variation.mean()), abs=1e-9)
    assert mesh.VariationMax <= mesh.MaterialThreshold
    assert 0 < mesh.DihedralMin < math.degrees(math.acos(1 / 3)) < mesh.DihedralMax < 180
    report = json.loads(mesh.Report)
    assert [stage["name"] for stage in report["stages"]] == ["initial", "material", "geometry"]
    assert report["stages"][-1]["tets"] == mesh.TetCount


def calculix(mesh, folder, output):
    """Elements as FreeCAD writes them, a load on one node; gives what CalculiX prints to its .dat file.

    A tetrahedron numbered in the wrong sense has a non-positive Jacobian."""
    mesh.FemMesh.writeABAQUS(str(folder / "mesh.inp"), 1, False)
    (folder / "deck.inp").write_text(
        "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=M\n*ELASTIC\n1000, 0.3\n"
        "*SOLID SECTION, ELSET=Evolumes, MATERIAL=M\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n"
        f"*STEP\n*STATIC\n*CLOAD\n4, 3, 1.0\n{output}\n*END STEP\n"
    )
    done = subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True, text=True, timeout=120)
    assert "nonpositive jacobian" not in done.stdout.lower()
    assert "*ERROR" not in done.stdout, done.stdout[-2000:]
    return (folder / "deck.dat").read_text()


@pytest.mark.usefixtures("ccx")
def test_calculix_takes_the_elements(mesh, tmp_path):
    assert calculix(mesh, tmp_path, "*NODE PRINT, NSET=Nall\nU")


def test_curved_faces(document, placement, fgmesh):
    cylinder = document.addObject("Part::Cylinder", "Cylinder")
    cylinder.Radius, cylinder.Height, cylinder.Placement = 5, 8, placement
    document.recompute()
    fgmesh.attach_material(cylinder, "r/5")
    mesh = fgmesh.make_mesh(document, cylinder)
    mesh.MaterialThreshold = 0.3
    mesh.SurfaceDeviation = 0.05
    fgmesh.generate(mesh)
    assert_groups_fit(mesh, cylinder.Shape)
    exact = math.pi * 5**2 * 8
    assert 0.98 * exact < volume_of(mesh) < exact
    surface = [FreeCAD.Vector(*nodes_of(mesh)[n - 1]) for n in groups_of(mesh)["Face1_Nodes"]]
    own = np.array([placement.inverse().multVec(point) for point in surface])
    assert np.hypot(own[:, 0], own[:, 1]) == pytest.approx(5, abs=1e-7)


@pytest.mark.usefixtures("ccx")
def test_second_order(document, placement, fgmesh, tmp_path):
    cylinder = document.addObject("Part::Cylinder", "Cylinder")
    cylinder.Radius, cylinder.Height, cylinder.Placement = 5, 8, placement
    document.recompute()
    fgmesh.attach_material(cylinder, "r/5")
    mesh = fgmesh.make_mesh(document, cylinder)
    mesh.MaterialThreshold, mesh.SurfaceDeviation, mesh.SecondOrder = 0.4, 0.3, True
    result = fgmesh.generate(mesh)
    fem = mesh.FemMesh
    assert (mesh.Status, len(result.straightened)) == ("ok", 0)
    assert mesh.PointCount == fem.NodeCount == len(mesh.Fractions) == len(result.points)
    assert mesh.TetCount == fem.TetraCount and {len(fem.getElementNodes(n)) for n in fem.Volumes} == {10}
    assert_groups_fit(mesh, cylinder.Shape)
    exact = math.pi * 5**2 * 8
    assert abs(volume_of(mesh) / exact - 1) > 0.005  # of straight tetrahedra
    printed = calculix(mesh, tmp_path, "*EL PRINT, ELSET=Evolumes, TOTALS=ONLY\nEVOL")
    assert "C3D10" in (tmp_path / "mesh.inp").read_text()
    assert float(printed.split()[-1]) == pytest.approx(exact, rel=1e-3)
    mesh.SecondOrder = False
    assert mesh.Status == "out of date: SecondOrder was True, is False"


def test_body_in_a_placed_part(document, body, fgmesh, coarse_mesh):
    part = document.addObject("App::Part", "Part")
    part.Placement.Base = FreeCAD.Vector(0, 0, 50)
    part.addObject(body)
    document.recompute()
    mesh = coarse_mesh(fgmesh.attach_material(body, "z/6"))
    document.recompute()
    assert (mesh.Status, mesh.isValid()) == ("ok", True)
    assert mesh.getParentGeoFeatureGroup() is part
    assert volume_of(mesh) == pytest.approx(10 * 10 * 6)
    assert_groups_fit(mesh, body.Shape)
    document.getObject("Pad").Length = 7
    document.recompute()
    assert mesh.Status.startswith("out of date")


def test_generate_computes_what_waits(graded_box, fgmesh):
    mesh = fgmesh.make_mesh(graded_box.Document, graded_box)
    mesh.MaterialThreshold = 0.3
    graded_box.setExpression("FGM_h", "Height")
    graded_box.Height = 60
    fgmesh.generate(mesh)
    assert volume_of(mesh) == pytest.approx(10 * 20 * 60)
    assert (min(mesh.Fractions), max(mesh.Fractions)) == pytest.approx((0, 1))
    assert mesh.Status == "ok"


def test_a_threshold_that_no_mesh_meets(graded_box, fgmesh):
    fgmesh.attach_material(graded_box, "step(17.3, z)")
    mesh = fgmesh.make_mesh(graded_box.Document, graded_box)
    mesh.MaterialThreshold = 0.3
    mesh.MinSize = 2
    result = fgmesh.generate(mesh)
    above = np.ptp(np.array(mesh.Fractions)[tets_of(mesh)], axis=1) > 0.3
    assert above.sum() == len(result.above_threshold) > 0
    assert mesh.Status.startswith(f"threshold_not_met: {above.sum()} of {mesh.TetCount} ")


def test_a_failure_while_storing_rolls_back(mesh, fgmesh, core, monkeypatch):
    """Even in a document that keeps no undo."""
    from freecad.fgmesh.model import mesh_object

    assert mesh.Document.UndoMode == 0
    before = nodes_of(mesh).tolist(), mesh.Report, mesh.Fractions, mesh.Status
    mesh.Seed = 0

    def fail(mesh):
        raise MemoryError

    monkeypatch.setattr(mesh_object, "update_status", fail)
    mesh.Shape.Length = 11
    with pytest.raises(MemoryError):
        fgmesh.generate(mesh)
    assert (nodes_of(mesh).tolist(), mesh.Report, mesh.Fractions, mesh.Status) == before
    assert mesh.Document.UndoMode == 0


def spoil_formula(mesh, control):
    mesh.Shape.FGMFractions = ["2*z/h"]  # leaves [0, 1]


def spoil_threshold(mesh, control):
    mesh.MaterialThreshold = 0


def cancel(mesh, control):
    control.cancel()


def reach_limit(mesh, control):
    control.set_limits(seconds=1e-9)


def lose_material(mesh, control):
    mesh.Shape.FGMFractions = []


def lose_solid(mesh, control):
    mesh.Shape = None


@pytest.mark.parametrize(
    "spoil, error",
    [
        (spoil_formula, "InvalidInput"),
        (spoil_threshold, "InvalidInput"),
        (cancel, "Cancelled"),
        (reach_limit, "Cancelled"),
        (lose_material, "InvalidInput"),
        (lose_solid, "InvalidInput"),
    ],
)
@pytest.mark.parametrize("in_process", [False, True])
def test_failure_leaves_the_mesh(mesh, fgmesh, core, spoil, error, in_process):
    control = core.RunControl()
    spoil(mesh, control)
    before = contents_of(mesh)
    with pytest.raises(getattr(core, error)):
        fgmesh.generate(mesh, control, in_process=in_process)
    assert contents_of(mesh) == before


def test_a_crash_leaves_the_mesh(mesh, fgmesh, core, child_double, monkeypatch):
    mesh.Shape.Length = 11
    before = contents_of(mesh)
    monkeypatch.setattr("freecad.fgmesh.worker.run.child_command", lambda: child_double("os.abort()"))
    with pytest.raises(core.GeometryError, match="crashed"):
        fgmesh.generate(mesh)
    assert contents_of(mesh) == before
    assert mesh.Document.UndoMode == 0 and FreeCAD.getActiveTransaction() is None


def test_meshing_in_this_process_gives_the_same(mesh, fgmesh):
    before = contents_of(mesh)
    fgmesh.generate(mesh, in_process=True)
    after = contents_of(mesh)
    assert after["nodes"] == before["nodes"] and after["groups"] == before["groups"]
    assert mesh.Status == "ok"


def test_make_mesh_refuses(box, fgmesh, core):
    with pytest.raises(core.InvalidInput, match=r"FGMesh, Graded material .*attach_material"):
        fgmesh.make_mesh(box.Document, box)
    other = FreeCAD.newDocument("Other")
    try:
        with pytest.raises(core.InvalidInput, match="same document"):
            fgmesh.make_mesh(other, box)
        assert not other.Objects
    finally:
        FreeCAD.closeDocument(other.Name)
    assert box.Document.Objects == [box]


def test_generate_refuses_other_objects(box, fgmesh, core):
    with pytest.raises(core.InvalidInput, match="make_mesh"):
        fgmesh.generate(box)


def test_one_undo_step_each(graded_box, fgmesh):
    document = graded_box.Document
    document.UndoMode = 1
    mesh = fgmesh.make_mesh(document, graded_box)
    mesh.MaterialThreshold = 0.3
    fgmesh.generate(mesh)
    count = mesh.TetCount
    assert count > 0
    document.undo()
    assert (mesh.TetCount, mesh.FemMesh.NodeCount, mesh.Status) == (0, 0, "not meshed yet")
    document.redo()
    assert (mesh.TetCount, mesh.FemMesh.VolumeCount, mesh.Status) == (count, count, "ok")
    groups = groups_of(mesh)
    mesh.MaterialThreshold = 0.15
    fgmesh.generate(mesh)
    assert mesh.FemMesh.VolumeCount == mesh.TetCount > count
    document.undo()
    document.recompute()
    assert (mesh.TetCount, mesh.FemMesh.VolumeCount) == (count, count)
    assert groups_of(mesh) == groups
    assert mesh.Status == "out of date: MaterialThreshold was 0.3, is 0.15"
    document.undo()
    document.undo()
    assert document.Objects == [graded_box]


def test_the_transaction_of_a_caller_is_joined(graded_box, fgmesh):
    document = graded_box.Document
    document.UndoMode = 1
    document.openTransaction("A macro")
    fgmesh.make_mesh(document, graded_box)
    fgmesh.attach_material(graded_box, "1-z/h", {"h": 30.0})
    assert FreeCAD.getActiveTransaction()[0] == "A macro"
    document.abortTransaction()
    assert document.Objects == [graded_box]
    assert graded_box.FGMFractions == ["z/h"]
