# SPDX-License-Identifier: GPL-3.0-or-later
"""Links, arrays, clones and compounds of graded solids: the material where each copy stands, or a clear refusal."""
import FreeCAD
import numpy as np
import pytest
from FreeCAD import Placement, Rotation, Vector

TURNED = Placement(Vector(3, 200, -8), Rotation(Vector(1, -1, 2), 70))
SLOPE = 25.0


@pytest.fixture
def wedge(document, fgmesh, placement):
    """A placed box of 6 x 8 x 10 mm with f = (x + 2 y) / h in its own coordinates."""
    box = document.addObject("Part::Box", "Graded")
    box.Length, box.Width, box.Height = 6, 8, 10
    box.Placement = placement
    document.recompute()
    return fgmesh.attach_material(box, "(x+2*y)/h", {"h": SLOPE})


@pytest.fixture
def link(document):
    def make(thing, count=0, **values):
        made = document.addObject("App::Link", "Link")
        made.LinkedObject = thing
        made.ElementCount = count
        document.recompute()
        for name, value in values.items():
            setattr(made, name, value)
        document.recompute()
        return made

    return make


def check(fgmesh, document, thing, places):
    """Meshes `thing` and compares the fractions with the closed form of the copies that stand at `places`."""
    document.recompute()
    mesh = fgmesh.make_mesh(document, thing)
    mesh.MaterialThreshold = 0.4
    result = fgmesh.generate(mesh)
    assert mesh.Status == "ok"
    assert sorted(set(result.tet_solids)) == list(range(1, len(places) + 1))
    for number, place in enumerate(places, 1):
        chosen = result.tet_solids == number
        points = result.points[result.tets[chosen]].reshape(-1, 3)
        local = np.array([place.inverse().multVec(Vector(*point)) for point in points])
        assert local.min() > -1e-6 and (local.max(axis=0) < np.array([6, 8, 10]) + 1e-6).all()
        expected = (local[:, 0] + 2 * local[:, 1]) / SLOPE
        assert np.allclose(result.tet_fractions[chosen, :, 0].ravel(), expected, atol=1e-8)
    return mesh


def test_elements_of_a_link(fgmesh, document, wedge, link):
    places = [Placement(), Placement(Vector(20, 0, 0), Rotation()), TURNED]
    array = link(wedge, 3, Placement=Placement(Vector(0, 0, 300), Rotation(Vector(0, 1, 0), 30)))
    for element, place in zip(array.ElementList, places):
        element.Placement = place
    mesh = check(fgmesh, document, array, [array.Placement.multiply(place) for place in places])
    wedge.FGM_h = 2 * SLOPE
    document.recompute()
    assert "FGM_h" in mesh.Status
    wedge.FGM_h = SLOPE
    again = link(array, Placement=TURNED)
    check(fgmesh, document, again, [TURNED.multiply(place) for place in places])


def test_elements_of_a_collapsed_link(fgmesh, document, wedge, link):
    places = [Placement(Vector(40, 0, 0), Rotation()), TURNED]
    check(fgmesh, document, link(wedge, 2, ShowElement=False, PlacementList=places), places)


def test_links_with_the_placement_of_the_original(fgmesh, document, wedge, link):
    moved = link(wedge, LinkTransform=True, Placement=TURNED)
    check(fgmesh, document, moved, [TURNED.multiply(wedge.Placement)])
    check(fgmesh, document, link(moved), [wedge.Placement])  # in place of TURNED
    further = link(moved, LinkTransform=True, Placement=TURNED)
    check(fgmesh, document, further, [TURNED.multiply(TURNED).multiply(wedge.Placement)])


def test_links_to_a_container(fgmesh, document, wedge, link):
    part = document.addObject("App::Part", "Container")
    part.addObject(wedge)
    part.Placement = Placement(Vector(0, 70, 0), Rotation(Vector(1, 0, 0), 20))
    document.recompute()
    check(fgmesh, document, part, [part.Placement.multiply(wedge.Placement)])
    check(fgmesh, document, link(part, Placement=TURNED), [TURNED.multiply(wedge.Placement)])


def test_assemblies(fgmesh, document, wedge, link):
    """Of FreeCAD 1.x; 0.20 has containers alone."""
    try:
        assembly = document.addObject("Assembly::AssemblyObject", "Assembly")
    except (TypeError, ImportError):
        assembly = document.addObject("App::Part", "Assembly")
    places = [TURNED, Placement(Vector(40, 0, 0), Rotation(Vector(0, 1, 0), 20))]
    for place in places:
        assembly.addObject(link(wedge, Placement=place))
    assembly.Placement = Placement(Vector(0, 70, 0), Rotation(Vector(1, 0, 0), 20))
    document.recompute()
    check(fgmesh, document, assembly, [assembly.Placement.multiply(place) for place in places])
    check(fgmesh, document, link(assembly, Placement=TURNED), [TURNED.multiply(place) for place in places])


def test_links_across_documents(fgmesh, document, wedge, tmp_path):
    document.saveAs(str(tmp_path / "original.FCStd"))
    other = FreeCAD.newDocument("Other")
    try:
        other.saveAs(str(tmp_path / "user.FCStd"))
        made = other.addObject("App::Link", "Link")
        made.LinkedObject = wedge
        made.Placement = TURNED
        check(fgmesh, other, made, [TURNED])
    finally:
        FreeCAD.closeDocument(other.Name)


def test_clones_and_arrays_of_draft(fgmesh, document, wedge):
    import Draft

    clone = Draft.make_clone(wedge)
    clone.Placement = TURNED
    check(fgmesh, document, clone, [TURNED])
    for use_link in True, False:
        array = Draft.make_ortho_array(
            wedge, Vector(50, 0, 0), Vector(0, 60, 0), Vector(0, 0, 70), 2, 1, 2, use_link
        )
        array.Placement = TURNED
        moves = [Vector(50 * i, 0, 70 * k) for i in range(2) for k in range(2)]
        places = [TURNED.multiply(Placement(move, Rotation())).multiply(wedge.Placement) for move in moves]
        check(fgmesh, document, array, places)
        polar = Draft.make_polar_array(wedge, 3, 360, Vector(60, 0, 0), use_link)
        turns = [Placement(Vector(), Rotation(Vector(0, 0, 1), 120 * n), Vector(60, 0, 0)) for n in range(3)]
        check(fgmesh, document, polar, [turn.multiply(wedge.Placement) for turn in turns])


@pytest.mark.parametrize("use_link", [True, False])
def test_further_arrays_of_draft(fgmesh, document, wedge, use_link):
    import Draft

    corner = Draft.make_wire([Vector(), Vector(90, 0, 0), Vector(90, 90, 0)])
    spots = [document.addObject("Part::Vertex", "Spot") for _ in range(3)]
    for number, spot in enumerate(spots):
        spot.X, spot.Y = 40 * number, 60 * number % 100
    cloud = document.addObject("Part::Compound", "Cloud")
    cloud.Links = spots
    document.recompute()
    pair = Draft.make_ortho_array(wedge, Vector(0, 0, 30), Vector(), Vector(), 2, 1, 1, use_link=use_link)
    document.recompute()
    arrays = {
        3: Draft.make_path_array(wedge, corner, 3, align=True, use_link=use_link),
        4: Draft.make_path_twisted_array(wedge, corner, 4, rot_factor=0.3, use_link=use_link),
        "spots": Draft.make_point_array(wedge, cloud, use_link=use_link),
        7: Draft.make_circular_array(wedge, 60, 60, 2, 1, Vector(0, 0, 1), Vector(), use_link=use_link),
        "pairs": Draft.make_polar_array(pair, 2, 360, Vector(200, 0, 0), use_link=use_link),
    }
    document.recompute()
    for count, array in arrays.items():
        places = [solid.Placement for solid in array.Shape.Solids]  # that of a box moves with it
        assert len(places) == {"spots": 3, "pairs": 4}.get(count, count)
        assert len({tuple(round(number, 6) for number in place.Base) for place in places}) == len(places)
        check(fgmesh, document, array, places)


def test_compounds_of_instances_and_filters_of_them(fgmesh, document, wedge, link):
    from CompoundTools import CompoundFilter

    compound = document.addObject("Part::Compound", "Compound")
    compound.Links = [wedge, link(wedge, 2, ShowElement=False, PlacementList=[TURNED, Placement()])]
    compound.Placement = TURNED
    places = [TURNED.multiply(place) for place in (wedge.Placement, TURNED, Placement())]
    check(fgmesh, document, compound, places)
    chosen = CompoundFilter.makeCompoundFilter("Chosen")
    chosen.Base, chosen.FilterType, chosen.items = compound, "specific items", "0"
    check(fgmesh, document, chosen, places[:1])


def test_scaled_links_and_clones_are_refused_with_a_cure(fgmesh, core, document, wedge, link):
    import Draft

    clone = Draft.make_clone(wedge)
    clone.Scale = Vector(1, 2, 1)
    document.recompute()
    scaled = [link(wedge, Scale=2), link(wedge, ScaleVector=Vector(1, 1, -1)), clone]
    for thing in scaled:
        mesh = fgmesh.make_mesh(document, thing)
        with pytest.raises(core.InvalidInput, match=f"{thing.Label} is scaled.* material of its own"):
            fgmesh.generate(mesh)
    mesh = fgmesh.make_mesh(document, fgmesh.attach_material(scaled[0], "x/12"))
    mesh.MaterialThreshold = 0.4
    result = fgmesh.generate(mesh)
    assert np.allclose(result.tet_fractions[..., 0], result.points[result.tets][..., 0] / 12, atol=1e-9)


def test_features_that_change_the_shape_are_refused_with_a_cure(fgmesh, core, document, wedge):
    mirror = document.addObject("Part::Mirroring", "Mirror")
    mirror.Source, mirror.Normal = wedge, Vector(1, 0, 0)
    fillet = document.addObject("Part::Fillet", "Fillet")
    fillet.Base, fillet.Edges = wedge, [(1, 1.0, 1.0)]
    document.recompute()
    for thing in mirror, fillet:
        with pytest.raises(
            core.InvalidInput, match=f"{thing.Label} does not take over the material of Graded"
        ):
            fgmesh.make_mesh(document, thing)
        mesh = fgmesh.make_mesh(document, fgmesh.attach_material(thing, "clamp(z/100,0,1)"))
        mesh.MaterialThreshold = 0.4
        fgmesh.generate(mesh)
        assert mesh.Status == "ok"


def test_an_element_of_a_link_with_a_material_of_its_own(fgmesh, document, wedge, link, core):
    array = link(wedge, 2)
    array.ElementList[1].Placement.Base.x = 30
    fgmesh.attach_material(array.ElementList[1], "0.5")
    document.recompute()
    with pytest.raises(
        core.InvalidInput, match="has a material of its own beside that of its original"
    ) as caught:
        fgmesh.generate(fgmesh.make_mesh(document, array))
    assert array.ElementList[1].Label in str(caught.value)
    # The cure.
    both = document.addObject("Part::Compound", "Both")
    both.Links = [array.ElementList[0], array.ElementList[1]]
    document.recompute()
    mesh = fgmesh.make_mesh(document, both)
    mesh.MaterialThreshold = 0.4
    result = fgmesh.generate(mesh)
    assert np.allclose(result.tet_fractions[result.tet_solids == 2, :, 0], 0.5)
    assert np.ptp(result.tet_fractions[result.tet_solids == 1, :, 0]) > 0.8
