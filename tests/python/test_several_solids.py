# SPDX-License-Identifier: GPL-3.0-or-later
"""Several solids in one mesh: conforming, labelled as the shape given, with a material each."""
import json
import math

import numpy as np
import pytest
from freecad.fgmesh import core, worker
from freecad.fgmesh.io import groups

BALL, TUBE = 4 / 3 * math.pi * 6**3, math.pi * 25 * 20
STEINMETZ = 16 / 3 * 5**3
"""Volume of what two cylinders of radius 5 have in common whose axes cross at right angles."""


def boxes(*corners):
    """Boxes from (x, y, z, length, width, height) each, not sharing anything."""
    import FreeCAD
    import Part

    return [
        Part.makeBox(*size, FreeCAD.Vector(*corner)) for *corner, l, w, h in corners for size in [(l, w, h)]
    ]


def shape(name):
    import FreeCAD  # noqa: F401  must come before Part
    import Part
    from FreeCAD import Vector

    cube, ball = (0, 0, 0, 10, 10, 10), Part.makeSphere(6, Vector(10, 10, 10))
    rods = [Part.makeCylinder(5, 20), Part.makeCylinder(5, 20, Vector(-10, 0, 10), Vector(1, 0, 0))]
    room = boxes((0, 0, 0, 20, 20, 20))
    solids = {
        "side by side": boxes(cube, (10, 0, 0, 10, 10, 10)),
        "on a part of a face": boxes(cube, (10, 2, 2, 6, 6, 6)),
        "at an edge": boxes(cube, (10, 10, 0, 10, 10, 10)),
        "at a vertex": boxes(cube, (10, 10, 10, 10, 10, 10)),
        "a corner in common": boxes(cube, (5, 5, 5, 10, 10, 10)),
        "apart": boxes(cube, (40, 0, 0, 10, 10, 10)),
        "a stack": boxes(*((0, 0, 2 * i, 30, 20, 2) for i in range(5))),
        "twice": boxes(cube, cube),
        "ball in a box": [*room, ball],
        "box around a ball": [ball, *room],
        "rods": rods,
    }[name]
    return Part.makeCompound(solids)


# Volume of each solid, and area of all interfaces where it is known.
CASES = {
    "side by side": ([1000, 1000], 100),
    "on a part of a face": ([1000, 216], 36),
    "at an edge": ([1000, 1000], 0),
    "at a vertex": ([1000, 1000], 0),
    "a corner in common": ([1000, 875], 75),
    "apart": ([1000, 1000], 0),
    "a stack": ([1200] * 5, 4 * 600),
    "twice": ([1000, 0], 0),
    "ball in a box": ([8000 - BALL, BALL], 4 * math.pi * 36),
    "box around a ball": ([BALL, 8000 - BALL], 4 * math.pi * 36),
    "rods": ([TUBE, TUBE - STEINMETZ], None),
}


def text(part):
    return part.exportBrepToString().encode()


@pytest.fixture(scope="module", params=CASES)
def case(request):
    """Name, shape and mesh, with a material for each solid that jumps to the next."""
    part = shape(request.param)
    materials = [core.Material([f"{0.1 + 0.2 * i}+z/200"]) for i in range(len(part.Solids))]
    options = core.MeshingOptions(material_threshold=0.05)
    return request.param, part, core.generate_mesh(text(part), materials, options)


def interfaces(result):
    """Corners (sorted) and solids of every face between two tetrahedra of different solids."""
    sides = np.sort(result.tets[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    _, first, inverse, counts = np.unique(
        sides, axis=0, return_index=True, return_inverse=True, return_counts=True
    )
    assert counts.max() <= 2
    solids = np.repeat(result.tet_solids, 4)
    inverse = inverse.reshape(-1)
    low, high = np.full(len(counts), 99), np.zeros(len(counts), int)
    np.minimum.at(low, inverse, solids)
    np.maximum.at(high, inverse, solids)
    between = low != high
    return sides[first[between]], np.column_stack([low, high])[between]


def areas(result, triangles):
    a, b, c = np.moveaxis(result.points[triangles], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def test_volumes_and_interfaces_are_those_of_the_shape(case):
    name, part, result = case
    volumes, area = CASES[name]
    curved = any(len(face.Edges) < 4 for face in part.Faces)
    tolerance = 5e-3 if curved else 1e-9
    assert result.shape_solid_volumes == pytest.approx(volumes, rel=1e-4, abs=1e-9)
    assert result.solid_volumes == pytest.approx(volumes, rel=tolerance, abs=1e-9)
    assert result.volume == pytest.approx(sum(volumes), rel=tolerance)
    found, _ = interfaces(result)
    if area is not None:
        assert areas(result, found).sum() == pytest.approx(area, rel=tolerance, abs=1e-9)
    written = {tuple(sorted(triangle)) for triangle in result.triangles.tolist()}
    assert {*map(tuple, found.tolist())} <= written and len(written) == len(result.triangles)


def test_triangles_lie_on_the_faces_they_name(case):
    """All of them, so also those that coincide; and no face of the shape is left out but inside a solid."""
    import FreeCAD
    import Part

    name, part, result = case
    named = np.vstack(
        [
            np.column_stack([np.arange(len(result.triangles)), result.triangle_faces]),
            result.coincident_faces.reshape(-1, 2),
        ]
    )
    corners = result.points[result.triangles]
    for number, face in enumerate(part.Faces, 1):
        triangles = named[named[:, 1] == number, 0]
        assert len(triangles) > 0
        for point in corners[triangles].reshape(-1, 3)[:: max(1, len(triangles) // 10)]:
            assert face.distToShape(Part.Vertex(FreeCAD.Vector(*point)))[0] < 1e-6
        if face.Surface.TypeId == "Part::GeomPlane" and name not in ("a corner in common", "rods"):
            assert areas(result, result.triangles[triangles]).sum() == pytest.approx(face.Area, rel=5e-3)


def test_each_tetrahedron_has_the_material_of_its_solid(case):
    """The jumps between solids, 0.2, are four times the threshold."""
    _, _, result = case
    assert result.status == "ok"
    expected = 0.1 + 0.2 * (result.tet_solids[:, None] - 1) + result.points[result.tets][..., 2] / 200
    assert np.allclose(result.tet_fractions[..., 0], expected, atol=1e-9)
    assert np.allclose(result.variation, np.ptp(expected, axis=1), atol=1e-12)
    lowest = np.full(len(result.points), 99)
    np.minimum.at(lowest, result.tets, result.tet_solids[:, None])
    assert np.allclose(
        result.fractions[:, 0], 0.1 + 0.2 * (lowest - 1) + result.points[:, 2] / 200, atol=1e-9
    )
    inner = result.carriers[:, 0] == 3
    assert np.array_equal(result.carriers[inner, 1], lowest[inner])


def test_what_was_done_to_the_solids_is_told():
    def told(name):
        return " ".join(core.generate_mesh(text(shape(name)), core.Material(["0.5"])).messages)

    assert told("apart") == ""
    assert "Solid1 and Solid2 touch" in told("at a vertex")
    assert "overlap by 125 mm^3" in told("a corner in common")
    assert "belongs to Solid2" in told("ball in a box")
    assert "Solid2, which has no tetrahedra" in told("twice")


def test_what_only_the_separated_solids_have_is_number_0_and_has_no_name():
    """The first cuts a wedge of 3 degrees off the second, along an edge that neither of them has."""
    import Part
    from FreeCAD import Vector

    slope = math.tan(math.radians(3))
    corners = [Vector(0, 0, 0), Vector(10, 0, 0), Vector(10, 10 * slope, 0), Vector(0, 0, 0)]
    wedge = Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 0, 4))
    base = boxes((-5, -5, 0, 20, 5.1, 4))
    options = core.MeshingOptions(material_threshold=0.5, min_size=0.01, stop_after="initial")
    result = core.generate_mesh(text(Part.makeCompound([*base, wedge])), core.Material(["0.5"]), options)
    along = result.points[result.edges[result.edge_edges == 0]]
    at_tip = (abs(along[..., :2] - [0.1 / slope, 0.1]) < 1e-6).all(axis=(1, 2))
    assert at_tip.any()
    (message,) = (message for message in result.messages if "the shape forces" in message)
    assert "the faces at an edge where solids were separated meet at 3 degrees at (1.90" in message
    names = {group.name for group in groups.grouped(result).groups}
    assert {"Solid1", "Solid2"} < names and not names & {"Edge0", "Vertex0"}


def test_solids_that_share_their_faces_stay_as_they_are():
    import Part

    first, second = boxes((0, 0, 0, 10, 10, 10), (10, 0, 0, 10, 10, 10))
    joined, _ = first.generalFuse([second])
    for part in joined, Part.CompSolid(joined.Solids):
        result = core.generate_mesh(text(part), core.Material(["x/20"]))
        assert result.messages == [] and len(result.coincident_faces) == 0
        assert set(result.triangle_faces) == set(range(1, len(part.Faces) + 1)) == set(range(1, 12))
        assert set(result.edge_edges) == set(range(1, len(part.Edges) + 1))


def test_materials_must_be_as_many_as_solids():
    material = core.Material(["0.5"])
    for count in 0, 3:
        with pytest.raises(core.InvalidInput, match=f"{count} materials for 2 solids"):
            core.generate_mesh(text(shape("apart")), [material] * count)


def test_a_formula_may_leave_the_range_in_other_solids():
    """x / 10 is above 1 in the second cube, whose own material is defined in no other place."""
    materials = [core.Material(["x/10"]), core.Material(["sqrt(x-10)/4"])]
    result = core.generate_mesh(text(shape("side by side")), materials)
    assert result.status == "ok"
    assert result.tet_fractions.max() == pytest.approx(1)


@pytest.mark.parametrize("order", (1, 2))
def test_the_child_process_gives_the_same(order):
    part = text(shape("side by side"))
    references = core.references(part, ["Face1", "Face8"])
    materials = [
        core.Material(["d1/20"], references=references[:1]),
        core.Material(["0.9-d1/20"], references=references[1:]),
    ]
    options = core.MeshingOptions(order=order)
    here, there = (run(part, materials, options) for run in (core.generate_mesh, worker.generate_mesh))
    assert here.tet_fractions.shape == (len(here.tets), 4 if order == 1 else 10, 2)
    for name in ("points", "tets", "tet_fractions", "variation", "coincident_faces", "solid_volumes"):
        assert np.array_equal(getattr(here, name), getattr(there, name)), name
    x = here.points[here.tets][..., 0]
    second = (here.tet_solids == 2)[:, None]
    assert np.allclose(here.tet_fractions[..., 0], np.where(second, 0.9 - (20 - x) / 20, x / 20), atol=1e-9)


def test_the_command_line_takes_a_material_for_each_solid(fgmesh, tmp_path):
    shape("side by side").exportBrep(str(tmp_path / "two.brep"))
    for name, formula in ("first", "0.2"), ("second", "0.9"):
        (tmp_path / f"{name}.json").write_text(json.dumps({"fractions": [formula]}))
    done = fgmesh(
        "two.brep",
        "--material",
        "first.json",
        "--material",
        "second.json",
        "-o",
        "two.vtu",
        "--report",
        "two.json",
    )
    assert done.returncode == 0, done.stderr
    report = json.loads((tmp_path / "two.json").read_text())
    assert [solid["volume"] for solid in report["solids"]] == pytest.approx([1000, 1000])
    assert report["stages"][-1]["variation"]["max"] == 0
    fewer = fgmesh("two.brep", *["--material", "first.json"] * 3, "-o", "two.vtu")
    assert fewer.returncode == 2 and "3 materials for 2 solids" in fewer.stderr
