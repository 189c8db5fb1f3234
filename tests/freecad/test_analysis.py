# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's own analysis with CalculiX on meshes of ours: node sets, loads, and a known answer."""
import re
from collections import defaultdict

import FreeCAD
import numpy as np
import Part
import pytest

from FreeCAD import Vector

from freecad.fgmesh import adapter

CORNERS_OF_SIDES = {1: (0, 1, 2), 2: (0, 3, 1), 3: (1, 3, 2), 4: (2, 3, 0)}
"""Corners of the sides P1 to P4 (CalculiX manual, "Four-node tetrahedral element")."""


@pytest.fixture
def analysis(document, fgmesh):
    """A function: an analysis of the mesh of a placed shape, as a user makes it in the FEM workbench, of steel of
    1000 MPa; gives the part, its mesh and a function that adds a constraint on a face of the part."""
    import ObjectsFem

    def make(shape, placement, **options):
        part = document.addObject("Part::Feature", "Part")
        part.Shape, part.Placement = shape, placement
        document.recompute()
        mesh = fgmesh.make_mesh(document, fgmesh.attach_material(part, "0.5"))
        for name, value in options.items():
            setattr(mesh, name, value)
        fgmesh.generate(mesh)
        group = ObjectsFem.makeAnalysis(document, "Analysis")
        steel = ObjectsFem.makeMaterialSolid(document, "Steel")
        steel.Material = {"Name": "Steel", "YoungsModulus": "1000 MPa", "PoissonRatio": "0.3"}
        group.addObjects([adapter.make_standard_solver(document), steel, mesh])

        def constrain(kind, face, **values):
            constraint = getattr(ObjectsFem, f"makeConstraint{kind}")(document, kind)
            constraint.References = [(part, face)]
            for name, value in values.items():
                if isinstance(value, str):
                    adapter.set_quantity(constraint, name, value)
                else:
                    setattr(constraint, name, value)
            group.addObject(constraint)
            return constraint

        return group, mesh, constrain

    return make


def prepared(group, folder):
    """FreeCAD's tool for CalculiX, with its deck written."""
    from femtools.ccxtools import FemToolsCcx

    group.Document.recompute()
    tool = FemToolsCcx(group, test_mode=False)
    tool.update_objects()
    tool.setup_working_dir(str(folder))
    assert tool.check_prerequisites() == ""
    tool.write_inp_file()
    return tool


def blocks(deck):
    """The lines of numbers behind each keyword line of a deck, keyword lines as keys."""
    found, current = defaultdict(list), None
    for line in deck.splitlines():
        if line.startswith("*") and not line.startswith("**"):
            current = re.sub(r"\s", "", line.upper())
        elif current and re.match(r"\s*\d", line):
            found[current].append([word.strip() for word in line.strip().rstrip(",").split(",")])
    return found


def members(fem, name):
    (group,) = (group for group in fem.Groups if fem.getGroupName(group) == name)
    return fem.getGroupElements(group)


@pytest.mark.parametrize("second_order", [False, True])
def test_the_deck_loads_and_holds_the_faces_that_were_chosen(second_order, analysis, placement, tmp_path):
    """A cylinder between half a ball, which is held, and a cone, which is pulled; pressure on the cylinder."""
    half = Part.makeSphere(5, Vector(), Vector(0, 0, 1), -90, 0)
    shape = half.fuse(Part.makeCylinder(5, 8)).fuse(Part.makeCone(5, 0, 4, Vector(0, 0, 8))).removeSplitter()
    names = {face.Surface.TypeId[10:]: f"Face{n}" for n, face in enumerate(shape.Faces, 1)}
    cone, cylinder, ball = names["Cone"], names["Cylinder"], names["Sphere"]
    options = {"SecondOrder": second_order, "MaxSize": 3, "SurfaceDeviation": 0.04}
    group, mesh, constrain = analysis(shape, placement, **options)
    constrain("Fixed", ball)
    constrain("Force", cone, Force="100 N")
    constrain("Pressure", cylinder, Pressure="3 MPa")
    tool = prepared(group, tmp_path)
    with open(tool.inp_file_name) as file:
        deck = blocks(file.read())
    fem = mesh.FemMesh

    assert sorted(int(row[0]) for row in deck["*NSET,NSET=FIXED"]) == sorted(members(fem, f"{ball}_Nodes"))

    forces = np.zeros(3)
    for node, axis, value in deck["*CLOAD"]:
        forces[int(axis) - 1] += float(value)
    assert np.linalg.norm(forces) == pytest.approx(
        100, rel=0.02
    )  # facets have a little less area than the cone
    loaded = {int(row[0]) for row in deck["*CLOAD"]}
    on_cone = set(members(fem, f"{cone}_Nodes"))
    assert loaded <= on_cone
    if not second_order:
        assert loaded == on_cone

    (elements,) = (rows for key, rows in deck.items() if key.startswith("*ELEMENT"))
    words = [word for row in elements for word in row]
    width = 11 if second_order else 5
    corners = {
        int(words[i]): [int(word) for word in words[i + 1 : i + 5]] for i in range(0, len(words), width)
    }
    pressed = [
        frozenset(corners[int(element)][i] for i in CORNERS_OF_SIDES[int(side[1])])
        for element, side, value in deck["*DLOAD"]
    ]
    facets = [frozenset(fem.getElementNodes(facet)[:3]) for facet in members(fem, cylinder)]
    assert sorted(map(sorted, pressed)) == sorted(map(sorted, facets))


@pytest.mark.usefixtures("ccx")
@pytest.mark.parametrize("second_order", [False, True])
def test_a_bar_under_tension(second_order, analysis, tmp_path):
    """u = s x / E along the bar and -nu s y / E across it: linear, so any sound mesh gives it exactly."""
    shape = Part.makeBox(50, 10, 10)
    names = {tuple(face.CenterOfMass): f"Face{n}" for n, face in enumerate(shape.Faces, 1)}
    group, mesh, constrain = analysis(shape, FreeCAD.Placement(), SecondOrder=second_order, MaxSize=6)
    for axis, centre in (("x", (0, 5, 5)), ("y", (25, 0, 5)), ("z", (25, 5, 0))):
        adapter.hold(constrain("Displacement", names[centre]), axis)
    constrain("Pressure", names[50, 5, 5], Pressure="20 MPa", Reversed=True)
    tool = prepared(group, tmp_path)
    assert tool.ccx_run() == 0
    tool.load_results()
    (result,) = (thing for thing in group.Group if thing.isDerivedFrom("Fem::FemResultObject"))
    moved = np.array([tuple(vector) for vector in result.DisplacementVectors])
    places = mesh.FemMesh.Nodes
    expected = np.array([tuple(places[node]) for node in result.NodeNumbers]) * [0.02, -0.006, -0.006]
    assert len(moved) == mesh.PointCount
    assert moved == pytest.approx(expected, abs=1e-5)
