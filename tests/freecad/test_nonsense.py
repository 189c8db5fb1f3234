# SPDX-License-Identifier: GPL-3.0-or-later
"""Analyses that CalculiX would solve to nonsense are refused before it runs, by the names of what is wrong."""
import pytest

from freecad.fgmesh import adapter


@pytest.fixture
def other(bar, document):
    """A box beside the bar that is not meshed."""
    box = document.addObject("Part::Box", "Other")
    box.Placement.Base.x = 100
    document.recompute()
    return box


def refused(fgmesh, core, made, message):
    made.Document.recompute()
    with pytest.raises(core.InvalidInput, match=message):
        fgmesh.solve(made)
    assert not any(thing.isDerivedFrom("Fem::FemResultObject") for thing in made.Document.Objects)


def constraint(made, bar, kind):
    (found,) = [thing for thing in bar.constraints if thing.TypeId == f"Fem::Constraint{kind}"]
    assert found in made.Group
    return found


@pytest.mark.parametrize("mode", ["bins", "continuous"])
@pytest.mark.parametrize("kind", ["Displacement", "Pressure"])
def test_a_part_that_is_not_meshed(bar, analysis, other, fgmesh, core, kind, mode):
    made = analysis(mode=mode)
    constraint(made, bar, kind).References = [(other, "Face1")]
    refused(
        fgmesh, core, made, f"{kind} acts on Face1 of Other, where FGMesh has no nodes: choose a part of Part"
    )


def test_a_face_that_is_not_there(bar, analysis, fgmesh, core):
    made = analysis(mode="bins")
    constraint(made, bar, "Pressure").References = [(bar.part, "Face99")]
    refused(fgmesh, core, made, "Pressure acts on Face99, which Part does not have: choose it anew")


def test_nothing_to_act_on(bar, analysis, fgmesh, core):
    made = analysis(mode="bins")
    constraint(made, bar, "Pressure").References = []
    refused(fgmesh, core, made, "Pressure acts on nothing: give it faces, edges or vertices")


@pytest.mark.parametrize("mode", ["bins", "continuous"])
def test_no_load(bar, analysis, document, fgmesh, core, mode):
    made = analysis(mode=mode)
    document.removeObject(constraint(made, bar, "Pressure").Name)
    refused(
        fgmesh, core, made, "has no load, so that nothing would move: add a force, a pressure, a displacement"
    )


def test_a_load_of_zero(bar, analysis, fgmesh, core):
    made = analysis(mode="bins")
    adapter.set_quantity(constraint(made, bar, "Pressure"), "Pressure", "0 MPa")
    refused(fgmesh, core, made, "has no load")


@pytest.mark.usefixtures("ccx")
def test_a_displacement_that_is_given_is_a_load(bar, analysis, document, fgmesh):
    made = analysis(mode="bins")
    document.removeObject(constraint(made, bar, "Pressure").Name)
    pulled = bar.constrain("Displacement", [("Face", (10, 0, 0))])
    pulled.xFree, pulled.xDisplacement = False, 0.25
    made.addObject(pulled)
    document.recompute()
    (result,) = fgmesh.solve(made)
    assert max(vector.x for vector in result.DisplacementVectors) == pytest.approx(0.25, abs=1e-6)


@pytest.mark.parametrize("wrong", ["20", 2.5, True, 0, 2001, None])
def test_bins_that_are_no_number_of_bins(bar, fgmesh, core, wrong):
    with pytest.raises(core.InvalidInput, match="bins must be a whole number from 1 to 2000, not"):
        fgmesh.make_analysis(bar.mesh, mode="bins", bins=wrong)


@pytest.mark.parametrize("wrong", ["0.01", -0.1, 1, True, None])
def test_allowed_error_that_is_none(bar, fgmesh, core, wrong):
    with pytest.raises(core.InvalidInput, match="allowed_error must be a number from 0 to below 1, not"):
        fgmesh.make_analysis(bar.mesh, mode="bins", allowed_error=wrong)


def test_what_each_bin_lacks_is_told_once(bar, analysis, document, fgmesh, core):
    import ObjectsFem

    for name in ("Hard", "Soft"):
        card = document.getObject(name)
        card.Material = {
            key: value for key, value in card.Material.items() if key not in ("Density", "SpecificHeat")
        }
    made = analysis(mode="bins", bins=8)
    made.addObject(ObjectsFem.makeConstraintSelfWeight(document, "Weight"))
    document.recompute()
    with pytest.raises(core.InvalidInput) as caught:
        fgmesh.solve(made)
    assert str(caught.value).count("No Density") == 1


def test_a_displacement_that_holds_nothing(bar, analysis, fgmesh, core):
    made = analysis(mode="bins")
    held = constraint(made, bar, "Displacement")
    for axis in "xyz":
        setattr(held, f"{axis}Free", True)
        if f"{axis}Fix" in held.PropertiesList:
            setattr(held, f"{axis}Fix", False)
    refused(fgmesh, core, made, "holds 0 of the 6 ways in which Part can move and turn as a whole")


@pytest.mark.parametrize("axes", ["x", "yz"])
def test_a_face_across_x_that_is_held_along_some_axes(bar, analysis, fgmesh, core, axes):
    """Along x it neither moves so nor turns about y or z; along y and z it neither moves so nor turns about x."""
    made = analysis(mode="bins")
    held = constraint(made, bar, "Displacement")
    for axis in set("xyz") - set(axes):
        setattr(held, f"{axis}Free", True)
        if f"{axis}Fix" in held.PropertiesList:
            setattr(held, f"{axis}Fix", False)
    refused(fgmesh, core, made, "holds 3 of the 6 ways")


def test_a_pressure_on_a_solid(bar, analysis, fgmesh, core):
    made = analysis(mode="bins")
    constraint(made, bar, "Pressure").References = [(bar.part, "Solid1")]
    refused(fgmesh, core, made, "Pressure acts on Solid1 of Part, but can act on Face alone")


def test_what_is_no_analysis(bar, fgmesh, core):
    for wrong in (None, bar.mesh, 3):
        with pytest.raises(core.InvalidInput, match="is no FEM analysis"):
            fgmesh.solve(wrong)
    with pytest.raises(core.InvalidInput, match="mixing must be"):
        fgmesh.make_analysis(bar.mesh, mixing=3)


@pytest.mark.parametrize(
    "wrong",
    [
        {"references": 5},
        {"constituents": 5},
        {"tables": 5},
        {"fractions": None},
        {"parameters": ["h"]},
        {"parameters": {3: 1.0}},
    ],
)
def test_arguments_of_materials_of_other_kinds(bar, fgmesh, core, wrong):
    (name,) = wrong
    with pytest.raises(core.InvalidInput, match=f"{name} must be"):
        fgmesh.attach_material(bar.part, **{"fractions": "x/10", **wrong})
