# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents whose properties have other types or contents than ours: an error that names them, and a `Status` that tells."""
import json
import math

import FreeCAD
import pytest

VALUES = {
    "App::PropertyString": "x/10",
    "App::PropertyInteger": 3,
    "App::PropertyIntegerList": [1, 2],
    "App::PropertyFloat": 0.5,
    "App::PropertyBool": True,
    "App::PropertyStringList": ["a", "b"],
    "App::PropertyPlacement": FreeCAD.Placement(),
    "App::PropertyMap": {"a": "b"},
}
"""A value of each of these kinds of properties."""

DAMAGED_JSON = ["", "{", "[]", "null", "3", '{"stages": []}', '{"shape": 1, "placement": 2}', "[" * 100_000]


def with_other_type(thing, name, kind):
    thing.removeProperty(name)
    thing.addProperty(kind, name, "FGM")
    setattr(thing, name, VALUES[kind])


@pytest.mark.parametrize(
    "name", ["FGMFractions", "FGMFrame", "FGMTables", "FGMReferences", "FGMReferenceNames"]
)
def test_property_of_another_type(mesh, fgmesh, core, name):
    box = mesh.Shape
    own = box.getTypeIdOfProperty(name)
    for kind in VALUES.keys() - {own}:
        with_other_type(box, name, kind)
        mesh.touch()
        mesh.Document.recompute()
        told = f"the property {name} of Box is no longer"
        assert mesh.Status.startswith(f"out of date: {told}"), kind
        with pytest.raises(core.InvalidInput, match=told):
            fgmesh.generate(mesh)
    fgmesh.attach_material(box, "z/h", {"h": 30.0})  # which is the cure
    mesh.Document.recompute()
    assert mesh.Status == "ok" and box.getTypeIdOfProperty(name) == own


@pytest.mark.parametrize("kind", ["App::PropertyString", "App::PropertyPlacement", "App::PropertyStringList"])
def test_parameter_that_is_no_number(mesh, fgmesh, core, kind):
    with_other_type(mesh.Shape, "FGM_h", kind)
    mesh.touch()
    mesh.Document.recompute()
    assert mesh.Status.startswith("out of date: ") and "a parameter must be a number" in mesh.Status
    with pytest.raises(core.InvalidInput, match="a parameter must be a number"):
        fgmesh.generate(mesh)


@pytest.mark.parametrize("text", DAMAGED_JSON[1:])
@pytest.mark.parametrize("name", ["Report", "Fingerprint"])
def test_text_of_a_mesh_that_is_damaged(mesh, core, name, text):
    setattr(mesh, name, text)
    mesh.touch()
    mesh.Document.recompute()
    assert mesh.Status == f"out of date: the property {name} of FGMesh is damaged"
    from freecad.fgmesh.model import mesh_object

    if name == "Report":
        with pytest.raises(core.InvalidInput, match="Report of FGMesh is damaged"):
            mesh_object.report_of(mesh)


def test_fractions_that_do_not_fit_the_mesh(mesh, core):
    from freecad.fgmesh.model import mesh_object

    assert mesh_object.fractions_of(mesh).shape == (mesh.PointCount, 1)
    mesh.Fractions = mesh.Fractions[:-1]
    with pytest.raises(core.InvalidInput, match="does not tell the fractions at its nodes: mesh it again"):
        mesh_object.fractions_of(mesh)


@pytest.mark.parametrize("text", DAMAGED_JSON[1:])
def test_text_of_an_analysis_that_is_damaged(analysis, text):
    from freecad.fgmesh.fem.graded_material import is_graded_material

    made = analysis(mode="bins", bins=3)
    graded = next(filter(is_graded_material, made.Group))
    assert graded.Status == "ok"
    graded.MadeFrom = text
    graded.touch()
    graded.Document.recompute()
    assert graded.Status.startswith("out of date: ")


@pytest.mark.parametrize("number", [math.inf, -math.inf, math.nan])
def test_frame_that_is_not_finite(mesh, fgmesh, core, number):
    box = mesh.Shape
    box.FGMFrame = FreeCAD.Placement(FreeCAD.Vector(number, 0, 0), FreeCAD.Rotation())
    mesh.Document.recompute()
    assert mesh.Status == "out of date: the material's frame was moved"
    with pytest.raises(core.InvalidInput):
        fgmesh.generate(mesh)


def test_options_of_another_type_are_mended_when_the_document_is_opened(mesh, tmp_path, in_fresh_freecad):
    with_other_type(mesh, "MaterialThreshold", "App::PropertyString")
    mesh.MaterialThreshold = "0.3"
    with_other_type(mesh, "MinSize", "App::PropertyPlacement")
    with_other_type(mesh, "Groups", "App::PropertyMap")
    with_other_type(mesh, "TetCount", "App::PropertyString")
    path = str(tmp_path / "other.FCStd")
    mesh.Document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import FreeCAD
import freecad.fgmesh as fgmesh
mesh = FreeCAD.openDocument({path!r}).FGMesh
answer = [mesh.getTypeIdOfProperty(name) for name in ("MaterialThreshold", "MinSize", "Groups", "TetCount")]
fgmesh.generate(mesh)
answer += [mesh.Status, mesh.TetCount == mesh.FemMesh.VolumeCount]
"""
    )
    assert answer[:4] == [
        *("App::PropertyFloat", "App::PropertyLength", "App::PropertyStringList", "App::PropertyInteger"),
    ]
    assert answer[4:] == ["ok", True]


def test_option_of_another_type_is_named(mesh, fgmesh, core):
    with_other_type(mesh, "MaterialThreshold", "App::PropertyStringList")
    with pytest.raises(core.InvalidInput, match="MaterialThreshold cannot be"):
        fgmesh.generate(mesh)


def test_changed_by_a_freecad_without_the_workbench(mesh, tmp_path, in_fresh_freecad):
    """Nobody has told the mesh meanwhile."""
    path = str(tmp_path / "part.FCStd")
    mesh.Document.saveAs(path)
    script = f"""
import FreeCAD
document = FreeCAD.openDocument({path!r})
document.Box.Height = 55
document.recompute()
document.save()
answer = document.FGMesh.Status
"""
    assert in_fresh_freecad(script, with_workbench=False) == "ok"
    answer = in_fresh_freecad(
        f"""
import FreeCAD
mesh = FreeCAD.openDocument({path!r}).FGMesh
answer = [mesh.Proxy.__class__.__name__, mesh.Status]
"""
    )
    assert answer == ["MeshObject", "out of date: the solid has another shape"]


def test_report_that_is_read_back_is_the_one_that_was_made(mesh):
    from freecad.fgmesh.model import mesh_object

    assert mesh_object.report_of(mesh) == json.loads(mesh.Report)
