# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects with several solids: one material for all, or that of each object that they were made of."""
import json

import numpy as np
import pytest

SIDE = 10.0


@pytest.fixture
def boxes(document):
    """Two cubes that touch on all of one side, each with a face of its own there."""
    made = []
    for name, x in ("Left", -SIDE), ("Right", 0.0):
        box = document.addObject("Part::Box", name)
        box.Length = box.Width = box.Height = SIDE
        box.Placement.Base.x = x
        made.append(box)
    document.recompute()
    return made


@pytest.fixture
def compound(document, boxes, placement):
    """The two cubes, moved and turned as one."""
    compound = document.addObject("Part::Compound", "Compound")
    compound.Links = boxes
    compound.Placement = placement
    document.recompute()
    return compound


@pytest.fixture
def fragments(document):
    """A function: Boolean fragments of objects."""
    from BOPTools import SplitFeatures

    def make(objects):
        fragments = SplitFeatures.makeBooleanFragments(name="Fragments")
        fragments.Objects = objects
        document.recompute()
        return fragments

    return make


def meshed(fgmesh, document, thing, threshold=0.1):
    mesh = fgmesh.make_mesh(document, thing)
    mesh.MaterialThreshold = threshold
    return mesh, fgmesh.generate(mesh)


def local_points(result, placement):
    """Of each tetrahedron's corners, in the coordinates before `placement`; (m, 4, 3)."""
    rotation = np.array(placement.inverse().Rotation.toMatrix().A).reshape(4, 4)[:3, :3]
    return (result.points - np.array(placement.Base))[result.tets] @ rotation.T


def test_a_material_of_the_compound_holds_for_all(fgmesh, document, compound, placement):
    fgmesh.attach_material(compound, "(x+10)/20")
    mesh, result = meshed(fgmesh, document, compound)
    assert mesh.Status == "ok"
    local = local_points(result, placement)
    assert np.allclose(result.tet_fractions[..., 0], (local[..., 0] + SIDE) / 20, atol=1e-9)
    assert result.solid_volumes == pytest.approx([SIDE**3] * 2)


def test_materials_of_the_parts_move_with_them_and_jump_between_them(
    fgmesh, document, boxes, compound, placement
):
    fgmesh.attach_material(boxes[0], "z/h", {"h": 2 * SIDE})
    fgmesh.attach_material(boxes[1], "1-z/h", {"h": 2 * SIDE})
    mesh, result = meshed(fgmesh, document, compound)
    assert mesh.Status == "ok"
    height = local_points(result, placement)[..., 2] / (2 * SIDE)
    left = result.tet_solids == 1
    assert left.any() and not left.all()
    assert np.allclose(result.tet_fractions[left, :, 0], height[left], atol=1e-9)
    assert np.allclose(result.tet_fractions[~left, :, 0], 1 - height[~left], atol=1e-9)
    assert np.ptp(result.tet_fractions, axis=1).max() <= 0.1
    # Both names find the interface.
    groups = {
        mesh.FemMesh.getGroupName(i): set(mesh.FemMesh.getGroupElements(i)) for i in mesh.FemMesh.Groups
    }
    both = [
        name
        for name in groups
        if name.startswith("Face")
        and "_" not in name
        and any(groups[name] == groups[other] for other in groups if other != name and "_" not in other)
    ]
    assert len(both) == 2
    assert len(groups["Solid1"]) + len(groups["Solid2"]) == mesh.TetCount
    volumes = [solid["volume"] for solid in json.loads(mesh.Report)["solids"]]
    assert volumes == pytest.approx([SIDE**3] * 2)


def test_fragments_take_the_material_of_what_they_are_pieces_of(fgmesh, document, boxes, fragments):
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 4
    fgmesh.attach_material(ball, "0.5")
    fgmesh.attach_material(boxes[0], "0.2")
    fgmesh.attach_material(boxes[1], "0.9")
    whole = fragments([ball, *boxes])
    mesh, result = meshed(fgmesh, document, whole)
    centres = result.points[result.tets].mean(axis=1)
    radius = np.linalg.norm(centres, axis=1)
    expected = np.where(radius < 4, 0.5, np.where(centres[:, 0] < 0, 0.2, 0.9))
    # Facets of the ball cut corners: leave out what is near its surface.
    clear = abs(radius - 4) > 0.3
    assert (np.ptp(result.tet_fractions, axis=1) == 0).all()
    assert clear.sum() > 100 and (expected[clear] == 0.5).any()
    assert np.array_equal(result.tet_fractions[clear, 0, 0], expected[clear])


def test_a_part_without_material_is_named(fgmesh, core, document, boxes, compound):
    with pytest.raises(core.InvalidInput, match="Compound has no graded material"):
        fgmesh.make_mesh(document, compound)
    fgmesh.attach_material(boxes[0], "0.5")
    mesh = fgmesh.make_mesh(document, compound)
    with pytest.raises(core.InvalidInput, match="Solid2 of Compound"):
        fgmesh.generate(mesh)


def test_a_part_that_changes_makes_the_mesh_out_of_date(fgmesh, document, boxes, compound):
    for box in boxes:
        fgmesh.attach_material(box, "z/h", {"h": 2 * SIDE})
    mesh, _ = meshed(fgmesh, document, compound)
    assert mesh.Status == "ok"
    boxes[1].FGM_h = 3 * SIDE
    document.recompute()
    assert mesh.Status.startswith("out of date") and "Right" in mesh.Status and "FGM_h" in mesh.Status


def test_references_of_a_part_move_with_it(fgmesh, document, boxes, compound, placement):
    """The distance to Face5, z = 0 of a box, is z in its own coordinates."""
    for box in boxes:
        fgmesh.attach_material(box, "d1/20", references=["Face5"])
    _, result = meshed(fgmesh, document, compound)
    assert np.allclose(result.tet_fractions[..., 0], local_points(result, placement)[..., 2] / 20, atol=1e-7)


def test_both_materials_of_fragments_have_names(document):
    from freecad.fgmesh.model.shown_quantities import fraction_titles

    import freecad.fgmesh as fgmesh

    box, ball = document.addObject("Part::Box", "Box"), document.addObject("Part::Sphere", "Ball")
    document.recompute()
    fgmesh.attach_material(box, "x/10", constituents=["Steel", "Brass"])
    fgmesh.attach_material(ball, ["d/9", "0"], constituents=["Alumina", "Brass", "Tin"])
    both = document.addObject("Part::Compound", "Both")
    both.Links = [box, ball]
    document.recompute()
    assert fraction_titles(both, 3) == [
        "fraction of Steel / Alumina",
        "fraction of Brass",
        "fraction of Tin",
    ]
