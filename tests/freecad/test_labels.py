# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups of the Fem mesh against what FreeCAD itself finds on faces, edges, vertices and solids."""
import FreeCAD
import numpy as np
import Part
import pytest

from FreeCAD import Vector


def turned():
    """A ball's half, a cylinder and a cone, tangent to each other or not: seams, a pole, an apex."""
    half = Part.makeSphere(5, Vector(), Vector(0, 0, 1), -90, 0)
    return half.fuse(Part.makeCylinder(5, 8)).fuse(Part.makeCone(5, 0, 4, Vector(0, 0, 8))).removeSplitter()


def splined():
    """Faces of B-splines and planes: a wavy wall, a rounded corner (tangent to both walls), a hole."""
    wave = Part.BSplineCurve()
    wave.interpolate([Vector(0, 0), Vector(4, 3), Vector(8, 1), Vector(12, 4)])
    ends = [Vector(12, 4), Vector(12, 10), Vector(0, 10), Vector(0, 0)]
    walls = [Part.makeLine(*pair) for pair in zip(ends, ends[1:])]
    block = Part.Face(Part.Wire([wave.toShape(), *walls])).extrude(Vector(0, 0, 6))
    (corner,) = (edge for edge in block.Edges if edge.CenterOfMass.isEqual(Vector(0, 10, 3), 1e-6))
    # As B-splines, since FreeCAD searches surfaces of extrusion in a box that OpenCASCADE makes too small.
    return block.makeFillet(2, [corner]).cut(Part.makeCylinder(1.5, 6, Vector(7, 7))).toNurbs()


def torus():
    """One face, two seams, one vertex; slender beside its facets, so that middle nodes are straightened."""
    return Part.makeTorus(10, 2)


COARSE = {"MaxSize": 4, "SurfaceDeviation": 0.2}
OPTIONS = {turned: COARSE, splined: COARSE, torus: {"MaxSize": 20, "SurfaceDeviation": 0.1}}
BORDERS = {turned: 2, splined: 17, torus: 0}
"""How many edges lie between two faces."""


@pytest.fixture
def meshed(document, placement, fgmesh):
    """A function: the mesh object of a placed shape of uniform material, and its MeshingResult."""

    def make(shape, **options):
        assert shape.isValid() and len(shape.Solids) == 1
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        part.Placement = placement
        document.recompute()
        mesh = fgmesh.make_mesh(document, fgmesh.attach_material(part, "0.5"))
        for name, value in options.items():
            setattr(mesh, name, value)
        return mesh, fgmesh.generate(mesh)

    return make


def groups_of(mesh):
    fem = mesh.FemMesh
    return {fem.getGroupName(group): set(fem.getGroupElements(group)) for group in fem.Groups}


def is_border(shape, edge):
    return not edge.Degenerated and not any(edge.isSeam(face) for face in shape.Faces)


@pytest.mark.parametrize("make", [turned, splined, torus])
@pytest.mark.parametrize("second_order", [False, True])
def test_freecad_finds_the_nodes_of_the_groups(make, second_order, meshed):
    mesh, result = meshed(make(), SecondOrder=second_order, **OPTIONS[make])
    shape, fem, groups = mesh.Shape.Shape, mesh.FemMesh, groups_of(mesh)
    # These are in the groups, being nodes of their facets, and not where FreeCAD looks for them.
    off = set((np.asarray(result.straightened) + 1).tolist())
    assert off or not (make is torus and second_order)
    wanted = {"Solid1": fem.Nodes}
    if (
        not second_order
    ):  # the middle of an inner edge between two facets may lie in a hollow, out of the solid
        assert set(fem.getNodesBySolid(shape.Solids[0])) == set(fem.Nodes)
    wanted.update((f"Face{n}", fem.getNodesByFace(face)) for n, face in enumerate(shape.Faces, 1))
    borders = {f"Edge{n}": edge for n, edge in enumerate(shape.Edges, 1) if is_border(shape, edge)}
    wanted.update((name, fem.getNodesByEdge(edge)) for name, edge in borders.items())
    wanted.update((f"Vertex{n}", fem.getNodesByVertex(vertex)) for n, vertex in enumerate(shape.Vertexes, 1))
    assert {name for name in groups if name.endswith("_Nodes")} == {f"{name}_Nodes" for name in wanted}
    for name, nodes in wanted.items():
        assert nodes and set(nodes) - off == groups[f"{name}_Nodes"] - off, name
    assert len(borders) == BORDERS[make]


@pytest.mark.parametrize("make", [turned, splined])
@pytest.mark.parametrize("second_order", [False, True])
def test_groups_of_elements_cover_faces_and_edges(make, second_order, meshed):
    mesh, result = meshed(make(), SecondOrder=second_order, **COARSE)
    shape, fem, groups = mesh.Shape.Shape, mesh.FemMesh, groups_of(mesh)
    straightened = set((np.asarray(result.straightened) + 1).tolist())
    off = {element for element in fem.Faces + fem.Edges if straightened & set(fem.getElementNodes(element))}
    assert groups["Solid1"] == set(fem.Volumes)
    for number, face in enumerate(shape.Faces, 1):
        # A node that is off a curved edge may still lie on a flat face beside it.
        assert groups[f"Face{number}"] - off == set(fem.getFacesByFace(face)) - off
        assert nodes_of(fem, groups[f"Face{number}"]) == groups[f"Face{number}_Nodes"]
    for number, edge in enumerate(shape.Edges, 1):
        if not is_border(shape, edge):
            assert f"Edge{number}" not in groups
            continue
        assert groups[f"Edge{number}"] - off == set(fem.getEdgesByEdge(edge))
        assert nodes_of(fem, groups[f"Edge{number}"]) == groups[f"Edge{number}_Nodes"]
        assert length_of(fem, groups[f"Edge{number}"]) == pytest.approx(edge.Length, rel=0.03)
    assert sum(len(groups[f"Face{n}"]) for n in range(1, len(shape.Faces) + 1)) == fem.FaceCount


def nodes_of(fem, elements):
    return {node for element in elements for node in fem.getElementNodes(element)}


def length_of(fem, edges):
    """Of the chords, mm."""
    places = fem.Nodes
    ends = (fem.getElementNodes(edge)[:2] for edge in edges)
    return sum(places[a].distanceToPoint(places[b]) for a, b in ends)


@pytest.mark.parametrize("second_order", [False, True])
def test_groups_survive_saving(second_order, meshed, tmp_path):
    mesh, _ = meshed(turned(), SecondOrder=second_order, **COARSE)
    before = {name: nodes_in_group(mesh.FemMesh, name) for name in groups_of(mesh)}
    copy = FreeCAD.newDocument("Copy")
    try:
        again = copy.addObject("Fem::FemMeshObject", "Again")
        again.FemMesh = mesh.FemMesh
        copy.saveAs(str(tmp_path / "copy.FCStd"))
    finally:
        FreeCAD.closeDocument(copy.Name)
    copy = FreeCAD.openDocument(str(tmp_path / "copy.FCStd"))
    try:
        fem = copy.Again.FemMesh
        assert {
            fem.getGroupName(group): nodes_in_group(fem, fem.getGroupName(group)) for group in fem.Groups
        } == before
    finally:
        FreeCAD.closeDocument(copy.Name)


def nodes_in_group(fem, name):
    """The node numbers that a group of nodes or elements has in all."""
    (group,) = (group for group in fem.Groups if fem.getGroupName(group) == name)
    elements = fem.getGroupElements(group)
    return set(elements) if fem.getGroupElementType(group) == "Node" else nodes_of(fem, elements)
