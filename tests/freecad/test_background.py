# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in the background, and what generate() makes of those that have ended; groups of the Fem mesh."""
import numpy as np
import pytest


@pytest.fixture
def finished(graded_box):
    """A run for the graded box with a threshold of 0.3, ended."""
    from freecad.fgmesh.fem.background import BackgroundRun
    from freecad.fgmesh.model.options import default_values

    with BackgroundRun(graded_box, {**default_values(), "MaterialThreshold": 0.3}) as run:
        while not run.wait(0.5):
            pass
        yield run


def made(fgmesh, solid, threshold):
    mesh = fgmesh.make_mesh(solid.Document, solid)
    mesh.MaterialThreshold = threshold
    return mesh


def test_generate_stores_a_finished_run_once(finished, graded_box, fgmesh):
    from freecad.fgmesh.fem.background import adopt

    adopt(finished)
    mesh = made(fgmesh, graded_box, 0.3)
    adopted = fgmesh.generate(mesh)
    assert np.shares_memory(adopted.points, finished.result().points)
    assert mesh.Status == "ok"
    assert not np.shares_memory(fgmesh.generate(mesh).points, adopted.points)


def test_a_run_with_other_options_is_not_stored(finished, graded_box, fgmesh):
    from freecad.fgmesh.fem.background import adopt, adopted

    adopt(finished)
    mesh = made(fgmesh, graded_box, 0.05)
    fgmesh.generate(mesh)
    assert mesh.VariationMax <= 0.05
    assert adopted(mesh) is None


def test_what_changed_during_a_run_is_told(finished, graded_box, fgmesh):
    from freecad.fgmesh.fem.background import adopt

    graded_box.FGM_h = 31
    adopt(finished)
    mesh = made(fgmesh, graded_box, 0.3)
    fgmesh.generate(mesh)
    assert mesh.Status == "out of date: FGM_h was 30, is 31"


def test_groups_of_chosen_kinds(graded_box, fgmesh, core):
    mesh = made(fgmesh, graded_box, 0.3)
    mesh.Groups = ["Face"]
    fgmesh.generate(mesh)
    names = {mesh.FemMesh.getGroupName(number) for number in mesh.FemMesh.Groups}
    assert names == {f"Face{number}{nodes}" for number in range(1, 7) for nodes in ("", "_Nodes")}
    mesh.Groups = ["Side"]
    with pytest.raises(core.InvalidInput, match="Side"):
        fgmesh.generate(mesh)


def test_documents_from_before_groups_get_them(mesh, tmp_path):
    import FreeCAD

    tets = mesh.TetCount
    mesh.removeProperty("Groups")
    path = str(tmp_path / "old.FCStd")
    mesh.Document.saveCopy(path)
    document = FreeCAD.openDocument(path)
    try:
        old = document.getObject(mesh.Name)
        assert list(old.Groups) == ["Solid", "Face", "Edge", "Vertex"]
        assert (old.TetCount, old.Status.split(":")[0]) == (tets, "ok")
    finally:
        FreeCAD.closeDocument(document.Name)


def test_the_fem_mesh_can_be_made_in_steps(document, build_dir):
    """And what is not done is done when it is stored."""
    from freecad.fgmesh.fem import background, fem_mesh
    import freecad.fgmesh as fgmesh

    box = document.addObject("Part::Box", "Box")
    document.recompute()
    fgmesh.attach_material(box, "z/10")
    mesh = fgmesh.make_mesh(document, box)
    mesh.MaterialThreshold = 0.1
    values = background.option_values(mesh)
    with background.BackgroundRun(box, values) as run:
        while not run.wait(0.1):
            pass
        steps = run.request.prepare(run.result())
        done = [next(steps), next(steps)]
        assert 0 < done[0] < done[1] <= 1
        background.adopt(run)
        result = fgmesh.generate(mesh)
    whole = fem_mesh.to_fem_mesh(result, values["Groups"])
    for count in ("NodeCount", "VolumeCount", "FaceCount", "EdgeCount", "GroupCount"):
        assert getattr(mesh.FemMesh, count) == getattr(whole, count)
    assert mesh.FemMesh.VolumeCount == len(result.tets) and mesh.Status == "ok"
    points, tets = fem_mesh.kept_points_and_tets(mesh)
    again, read = fem_mesh.points_and_tets(mesh.FemMesh)
    assert (points == again).all() and (tets == read).all()
