# SPDX-License-Identifier: GPL-3.0-or-later
"""Making, completing and solving graded analyses; what becomes of them when something changes; wrong use."""
import importlib
import json
import re
import shutil
import sys

import exact_problems
import FreeCAD
import numpy as np
import pytest

from freecad.fgmesh import adapter
from freecad.fgmesh.fem.result_fields import fields_of


def graded_of(analysis):
    (graded,) = (one for one in analysis.Group if "PropertyError" in one.PropertiesList)
    return graded


def tip(result):
    return max(vector.x for vector in result.DisplacementVectors)


def test_the_objects_are_those_of_the_fem_workbench(analysis, bar):
    made = analysis(bins=7)
    graded = graded_of(made)
    assert (graded.Status, graded.BinCount, graded.Mesh) == ("ok", 7, bar.mesh)
    assert graded.PropertyError == pytest.approx(8 ** (0.5 / 7) - 1, rel=0.15)
    moduli = [
        FreeCAD.Units.Quantity(one.Material["YoungsModulus"]).getValueAs("MPa").Value
        for one in graded.Materials
    ]
    assert 1000 < moduli[0] < moduli[-1] < 8000 and moduli == sorted(moduli)
    assert all(one in made.Group for one in graded.Materials)
    fem = bar.mesh.FemMesh
    sizes = {fem.getGroupName(group): len(fem.getGroupElements(group)) for group in fem.Groups}
    assert sum(sizes[f"{one.Name}_Elements"] for one in graded.Materials) == bar.mesh.TetCount


def test_completing_keeps_what_the_user_has_made(analysis, bar, fgmesh):
    made = analysis(bins=5)
    (solver,) = (one for one in made.Group if hasattr(one, "AnalysisType"))
    solver.AnalysisType, solver.EigenmodesCount = "frequency", 4
    assert fgmesh.make_analysis(bar.mesh, bins=3, analysis=made) == made
    assert solver in made.Group and graded_of(made).BinCount == 3
    assert len([one for one in bar.document.Objects if "_Bin" in one.Name]) == 3
    fgmesh.make_analysis(bar.mesh, mode="continuous", analysis=made)
    (solver,) = (one for one in made.Group if hasattr(one, "AnalysisType"))
    assert (solver.AnalysisType, solver.EigenmodesCount) == ("frequency", 4)
    assert all(one in made.Group for one in bar.constraints)


@pytest.mark.usefixtures("ccx")
def test_materials_follow_a_new_mesh(analysis, bar, fgmesh):
    made = analysis(bins=6)
    before = tip(fgmesh.solve(made)[0])
    bar.mesh.MaterialThreshold = 0.15
    fgmesh.generate(bar.mesh)
    bar.document.recompute()
    assert graded_of(made).Status == "ok"
    fem = bar.mesh.FemMesh
    grouped = [
        element
        for group in fem.Groups
        if "_Bin" in fem.getGroupName(group)
        for element in fem.getGroupElements(group)
    ]
    assert sorted(grouped) == list(fem.Volumes)
    assert tip(fgmesh.solve(made)[0]) == pytest.approx(before, rel=0.02)


def test_a_changed_card_or_law_is_told(analysis, bar, fgmesh, core):
    made = analysis()
    graded = graded_of(made)
    graded.YoungsModulusLaw = "reuss"
    bar.document.recompute()
    assert graded.Status == "out of date: modes, bins or laws were changed"
    with pytest.raises(core.InvalidInput, match="Create the graded analysis again"):
        fgmesh.solve(made)
    fgmesh.make_analysis(bar.mesh, mixing={"YoungsModulus": "reuss"}, analysis=made)
    assert graded.Status == "ok"
    hard = bar.document.getObject("Hard")
    hard.Material = {**hard.Material, "YoungsModulus": "9000 MPa"}
    graded.touch()
    bar.document.recompute()
    assert graded.Status == "out of date: a material card was changed"


def test_the_same_card_in_other_units_is_none_that_was_changed(analysis, bar):
    """FreeCAD 0.20 writes "8000.0 MPa" where 1.x writes "8e+06 kg/(mm*s^2)"."""
    graded = graded_of(analysis())
    hard = bar.document.getObject("Hard")
    assert hard.Material["YoungsModulus"] == "8000.0 MPa"
    hard.Material = {
        **hard.Material,
        "YoungsModulus": "8e+06 kg/(mm*s^2)",
        "Density": "8e-06 kg/mm^3",
        "SpecificHeat": "5e+08 mm^2/(s^2*K)",
    }
    graded.touch()
    bar.document.recompute()
    assert graded.Status == "ok"


def test_materials_that_an_earlier_release_has_made_stay_valid(analysis, bar):
    """It kept a hash of the cards' texts."""
    graded = graded_of(analysis())
    kept = json.loads(graded.MadeFrom)
    del kept["properties"]
    kept["cards"] = "cc56bb3eab35ad20d824dc4a3fda895ad2dd3acac7958b9e8ca9a6579f67d710"
    graded.MadeFrom = json.dumps(kept)
    graded.touch()
    bar.document.recompute()
    assert graded.Status == "ok"
    hard = bar.document.getObject("Hard")
    hard.Material = {**hard.Material, "YoungsModulus": "9000 MPa"}
    graded.touch()
    bar.document.recompute()
    assert graded.Status == "out of date: a material card was changed"


def test_the_continuous_mode_without_a_framework_for_solvers(bar, fgmesh, monkeypatch, tmp_path):
    """FreeCAD 1.2 has no module of that name: there the solver object is solved by solve() alone."""
    properties = adapter.solver_bases()[0]
    monkeypatch.setitem(sys.modules, "femsolver.calculix.solver", None)
    assert adapter.solver_bases() == (properties,) and adapter.solver_view() is None
    for name in ("graded_solver", "solving", "graded_machine"):
        monkeypatch.delitem(sys.modules, f"freecad.fgmesh.fem.{name}", raising=False)
    made = fgmesh.make_analysis(bar.mesh, mode="continuous")
    made.addObjects(bar.constraints)
    bar.document.recompute()
    solving = importlib.import_module("freecad.fgmesh.fem.solving")
    deck = solving.write_deck(made, tmp_path).read_text()
    assert "TYPE=TEMPERATURE" in deck


def test_undo_is_one_step(bar, fgmesh):
    bar.document.UndoMode = 1
    before = {one.Name for one in bar.document.Objects}
    fgmesh.make_analysis(bar.mesh, bins=4)
    assert bar.document.UndoNames[0] == "Create graded analysis"
    bar.document.undo()
    assert {one.Name for one in bar.document.Objects} == before


def test_tables_are_as_fine_as_the_law_bends():
    """Reuss's mean of 1:1000, interpolated as CalculiX does; a straight law needs few rows."""
    from freecad.fgmesh.fem.graded_solver import table_rows

    def reuss(fractions):
        return {
            "YoungsModulus": 1 / (fractions / 1000 + (1 - fractions)),
            "PoissonRatio": 0.3 + 0 * fractions,
        }

    fractions, properties = table_rows(reuss)
    places = np.linspace(0, 1, 100003)
    exact = reuss(places)["YoungsModulus"]
    assert np.interp(places, fractions, properties["YoungsModulus"]) == pytest.approx(exact, rel=2e-5)
    assert len(fractions) < 3000 and (np.diff(fractions) > 0).all()
    straight, _ = table_rows(lambda fractions: {"YoungsModulus": 1 + fractions})
    assert len(straight) < 40


def test_a_graded_material_takes_the_place_of_a_lost_mesh(analysis, bar, fgmesh):
    made = analysis(bins=3)
    bar.document.removeObject(bar.mesh.Name)
    bar.document.recompute()
    assert graded_of(made).Status == "out of date: the mesh is gone"
    other = fgmesh.make_mesh(bar.document, bar.part)
    fgmesh.generate(other)
    fgmesh.make_analysis(other, bins=3, analysis=made)
    assert (graded_of(made).Status, graded_of(made).Mesh) == ("ok", other)


@pytest.mark.usefixtures("ccx")
def test_frequencies_of_both_modes_are_close(analysis, bar, fgmesh):
    """Bins and continuous are two ways to the same; the first frequencies of a bar of 1:8 in modulus."""
    frequencies = []
    for options in ({"mode": "bins", "bins": 60}, {"mode": "continuous"}):
        made = analysis(**options) if not frequencies else analysis(analysis=made, **options)
        (solver,) = (one for one in made.Group if hasattr(one, "AnalysisType"))
        solver.AnalysisType, solver.EigenmodesCount = "frequency", 3
        bar.document.recompute()
        frequencies.append([result.EigenmodeFrequency for result in fgmesh.solve(made)])
    assert len(frequencies[0]) == 3 and min(frequencies[0]) > 0
    assert frequencies[1] == pytest.approx(frequencies[0], rel=0.03)


def test_mass_of_a_graded_density(document, fgmesh):
    """That of the mean density, in the tetrahedra and, for self-weight, in the materials of the bins."""
    bench, _ = exact_problems.exponential_bar(document, fgmesh, MaterialThreshold=0.3, MaxSize=1)
    fgmesh.generate(bench.mesh)
    analysis = fgmesh.make_analysis(bench.mesh, bins=40)
    from freecad.fgmesh.fem.graded_fields import graded_mesh
    from freecad.fgmesh.mixing import read_laws

    fields = graded_mesh(bench.mesh)
    corners = fields.points[fields.tets[:, :4]]
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    densities = fields.in_tets(read_laws({}))["Density"]
    mean_fraction = (7 / np.log(8) - 1) / 7  # of (exp(x ln 8/L) - 1)/7 along the bar
    assert (densities * volumes).sum() == pytest.approx(40 * (1e-9 + 7e-9 * mean_fraction), rel=1e-3)
    graded = graded_of(analysis)
    fem = bench.mesh.FemMesh
    mass = 0.0
    for group in fem.Groups:
        for material in graded.Materials:
            if fem.getGroupName(group) == f"{material.Name}_Elements":
                density = FreeCAD.Units.Quantity(material.Material["Density"]).getValueAs("t/mm^3").Value
                mass += density * volumes[np.array(fem.getGroupElements(group)) - 1].sum()
    assert mass == pytest.approx(40 * (1e-9 + 7e-9 * mean_fraction), rel=1e-2)


def test_three_constituents(document, fgmesh, core):
    """k = 3, of which the third leaves: bins know them, the continuous mode refuses."""
    bench, _ = exact_problems.exponential_bar(document, fgmesh, MaterialThreshold=0.3, MaxSize=1)
    third = bench.card("Third", 500.0, 0.2)
    hard, soft = (document.getObject(name) for name in ("Hard", "Soft"))
    fgmesh.attach_material(bench.part, ["x/20", "0.4*y^2"], constituents=[hard, soft, third])
    fgmesh.generate(bench.mesh)
    analysis = fgmesh.make_analysis(bench.mesh, allowed_error=0.05)
    assert graded_of(analysis).PropertyError <= 0.05
    with pytest.raises(core.InvalidInput, match="3 constituents.*bins"):
        fgmesh.make_analysis(bench.mesh, mode="continuous", analysis=analysis)
    assert graded_of(analysis).Mode == "bins"


def _without_constituents(bar):
    bar.part.FGMConstituents = []


def _without(bar, name):
    hard = bar.document.getObject("Hard")
    hard.Material = {key: value for key, value in hard.Material.items() if key != name}


def _with(bar, name, value):
    hard = bar.document.getObject("Hard")
    hard.Material = {**hard.Material, name: value}


def _stale(bar):
    bar.part.FGMFractions = ["0.5"]
    bar.document.recompute()


@pytest.mark.parametrize(
    "spoil, options, words",
    [
        (_without_constituents, {}, "Part has no constituents.*choose a material card"),
        (lambda bar: _without(bar, "YoungsModulus"), {}, "constituent 1 has no YoungsModulus.*add it"),
        (
            lambda bar: _with(bar, "PoissonRatio", "0.5"),
            {},
            "PoissonRatio of constituent 1 is 0.5.*below 0.5",
        ),
        (
            lambda bar: _with(bar, "YoungsModulus", "-1 MPa"),
            {},
            "YoungsModulus of constituent 1 is -1.*above 0",
        ),
        (lambda bar: _with(bar, "YoungsModulus", "much"), {}, "'much'.*correct the card"),
        (_stale, {}, "out of date: the material has another formula. Mesh it again"),
        (lambda bar: None, {"mode": "smooth"}, "no mode 'smooth'.*bins, continuous"),
        (lambda bar: None, {"bins": 0}, "from 1 to 2000"),
        (lambda bar: None, {"mixing": {"YoungsModulus": "voight"}}, "did you mean voigt"),
        (lambda bar: None, {"mixing": {"Stiffness": "voigt"}}, "no property 'Stiffness'"),
        (lambda bar: None, {"mixing": {"YoungsModulus": "p1*x"}}, "depends on no place"),
        (lambda bar: None, {"mixing": {"YoungsModulus": "p1*v1 - 9e9"}}, "must be .*above 0"),
    ],
)
def test_wrong_use_is_told_and_changes_nothing(spoil, options, words, bar, fgmesh, core):
    spoil(bar)
    before = [one.Name for one in bar.document.Objects]
    with pytest.raises(core.InvalidInput, match=words):
        fgmesh.make_analysis(bar.mesh, **options)
    assert [one.Name for one in bar.document.Objects] == before


def test_a_thing_that_is_no_mesh_and_a_mesh_without_elements(bar, fgmesh, core):
    with pytest.raises(core.InvalidInput, match="Part is no graded mesh"):
        fgmesh.make_analysis(bar.part)
    empty = fgmesh.make_mesh(bar.document, bar.part)
    with pytest.raises(core.InvalidInput, match="not meshed yet"):
        fgmesh.make_analysis(empty)


def test_an_analysis_with_another_mesh(analysis, bar, fgmesh, core):
    made = analysis()
    other = fgmesh.make_mesh(bar.document, bar.part)
    fgmesh.generate(other)
    with pytest.raises(core.InvalidInput, match="has the mesh FGMesh already"):
        fgmesh.make_analysis(other, analysis=made)


def test_missing_constraints_are_told(bar, fgmesh, core):
    """In the words of FreeCAD, which differ from release to release."""
    made = fgmesh.make_analysis(bar.mesh)
    words = "Neither constraint fixed nor constraint displacement|No mechanical boundary conditions"
    with pytest.raises(core.InvalidInput, match=f"not ready to be solved: .*({words})"):
        fgmesh.solve(made)


def test_missing_calculix_is_told(analysis, fgmesh, monkeypatch):
    from freecad.fgmesh.fem.solving import SolverFailed

    made = analysis()
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(SolverFailed, match="CalculiX was not found.*install"):
        fgmesh.solve(made)


@pytest.mark.usefixtures("ccx")
def test_words_of_calculix_are_told(analysis, core, tmp_path):
    """Elements without a material."""
    from freecad.fgmesh.fem import solving

    deck = solving.write_deck(analysis(), tmp_path)
    deck.write_text(re.sub(r"\*SOLID SECTION.*\n", "", deck.read_text()))
    with pytest.raises(solving.SolverFailed, match=r"\*ERROR") as told:
        solving._run(shutil.which("ccx"), deck, core.RunControl())
    assert "CalculiX" in told.value.log


@pytest.mark.usefixtures("ccx")
def test_a_cancelled_run_leaves_the_results_of_before(analysis, bar, fgmesh, core):
    made = analysis()
    (before,) = fgmesh.solve(made)
    control = core.RunControl()
    control.cancel()
    with pytest.raises(core.Cancelled, match="CalculiX was stopped"):
        fgmesh.solve(made, control=control)
    assert before in made.Group and tip(before) > 0


def test_thermal_analysis_needs_bins(analysis, bar, fgmesh, core):
    made = analysis(mode="continuous")
    (solver,) = (one for one in made.Group if hasattr(one, "AnalysisType"))
    solver.AnalysisType = "thermomech"
    with pytest.raises(core.InvalidInput, match="needs the temperature.*with bins"):
        fgmesh.solve(made)


@pytest.mark.usefixtures("ccx")
def test_saved_analyses_open_and_solve_again(analysis, bar, tmp_path, in_fresh_freecad):
    """Both kinds of solver object come back, in a FreeCAD that never saw them."""
    made = analysis(mode="continuous")
    path = str(tmp_path / "bar.FCStd")
    bar.document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import freecad.fgmesh as fgmesh
document = FreeCAD.openDocument({path!r})
analysis = document.getObject({made.Name!r})
(result,) = fgmesh.solve(analysis)
answer = max(vector.x for vector in result.DisplacementVectors)
"""
    )
    assert answer == pytest.approx(0.420786054, rel=0.03)


@pytest.mark.usefixtures("ccx")
def test_the_solver_runs_as_the_fem_workbench_runs_it(analysis, bar):
    """By the machine behind the Run button."""
    from femsolver.run import run_fem_solver

    made = analysis(mode="continuous")
    (solver,) = (one for one in made.Group if hasattr(one, "AnalysisType"))
    run_fem_solver(solver)
    (result,) = (one for one in made.Group if one.isDerivedFrom("Fem::FemResultObject"))
    assert tip(result) == pytest.approx(0.420786054, rel=0.03)


@pytest.mark.usefixtures("ccx")
def test_two_solids_with_materials_of_their_own(document, fgmesh, core):
    """Boxes end to end under tension: each stretches as its own modulus has it. Where the fraction jumps between
    them, the continuous mode refuses."""
    import ObjectsFem
    import Part

    parts = []
    for name, start, fraction in (("Left", 0, "1"), ("Right", 5, "0")):
        part = document.addObject("Part::Feature", name)
        part.Shape = Part.makeBox(5, 2, 2, FreeCAD.Vector(start, 0, 0))
        parts.append(part)
        cards = []
        for number, modulus in enumerate((1000, 4000), 1):
            card = ObjectsFem.makeMaterialSolid(document, f"{name}{number}")
            card.Material = {"Name": card.Name, "YoungsModulus": f"{modulus} MPa", "PoissonRatio": "0"}
            cards.append(card)
        fgmesh.attach_material(part, fraction, constituents=cards)
    both = document.addObject("Part::Compound", "Both")
    both.Links = parts
    document.recompute()
    mesh = fgmesh.make_mesh(document, both)
    fgmesh.generate(mesh)
    analysis = fgmesh.make_analysis(mesh, bins=4)
    faces = {round(face.CenterOfMass.x, 3): f"Face{n}" for n, face in enumerate(both.Shape.Faces, 1)}
    held = ObjectsFem.makeConstraintFixed(document, "Held")
    held.References = [(both, faces[0.0])]
    pull = ObjectsFem.makeConstraintPressure(document, "Pull")
    pull.References, pull.Reversed = [(both, faces[10.0])], True
    adapter.set_quantity(pull, "Pressure", "8 MPa")
    analysis.addObjects([held, pull])
    document.recompute()
    (result,) = fgmesh.solve(analysis)
    assert tip(result) == pytest.approx(5 * 8 / 1000 + 5 * 8 / 4000, rel=1e-4)
    with pytest.raises(core.InvalidInput, match="jumps where Right touches.*take bins"):
        fgmesh.make_analysis(mesh, mode="continuous", analysis=analysis)


@pytest.mark.usefixtures("ccx")
def test_fractions_and_properties_are_fields_of_the_results(analysis, bar, fgmesh, tmp_path):
    """E = 1000 exp(ln 8 x/L) along the axis, probed by FreeCAD's own filter."""
    made = analysis(mode="continuous")
    for _ in range(2):  # a second run takes the place of the first
        (result,) = fgmesh.solve(made)
    pipeline = fields_of(result)
    assert len([one for one in bar.document.Objects if "GradedResult" in one.PropertiesList]) == 1
    line = bar.document.addObject("Fem::FemPostDataAlongLineFilter", "Line")
    clip = bar.document.addObject("Fem::FemPostScalarClipFilter", "Clip")
    for post_filter in (line, clip):
        adapter.add_filter(pipeline, post_filter)
    line.Point1, line.Point2, line.Resolution = FreeCAD.Vector(0.01, 0, 0), FreeCAD.Vector(9.99, 0, 0), 50
    bar.document.recompute()
    expected = {"fraction_1", "fraction_2", "YoungsModulus (Pa)", "Density (kg/m^3)", "von Mises Stress"}
    assert expected <= set(clip.getEnumerationsOfProperty("Scalars"))
    for name, exact in (
        ("YoungsModulus (Pa)", lambda x: 1e9 * np.exp(np.log(8) * x / 10)),
        ("fraction_1", lambda x: (np.exp(np.log(8) * x / 10) - 1) / 7),
        (
            "von Mises Stress",
            lambda x: 100e6 + 0 * x,
        ),  # of a pull of 100 MPa: FreeCAD has it in the same unit
    ):
        places, found = adapter.plotted(line, name)
        x, found = 0.01 + np.array(places), np.array(found)
        assert len(x) == 51
        # Linear between the nodes of a mesh of size 1.
        assert found == pytest.approx(exact(x), rel=0.02, abs=0.005)


@pytest.mark.usefixtures("ccx")
@pytest.mark.parametrize("mode", ["bins", "continuous"])
def test_solving_is_one_undo_step(analysis, bar, fgmesh, mode):
    def results():
        kinds = ("Fem::FemResultObject", "Fem::FemPostPipeline", "App::TextDocument")
        of_fem = [one for one in document.Objects if any(map(one.isDerivedFrom, kinds))]
        meshes = [one for one in document.Objects if one.Name.startswith("ResultMesh")]
        return {one.Name for one in of_fem + meshes}

    made, document = analysis(mode=mode), bar.document
    document.UndoMode = 1
    others = {one.Name for one in document.Objects}
    fgmesh.solve(made)
    steps, first = document.UndoCount, results()
    assert steps == 1 and len(first) >= 3  # the result, its mesh and its pipeline
    fgmesh.solve(made)  # which takes the first results away
    assert document.UndoCount == steps + 1
    document.undo()
    assert results() == first
    document.undo()
    assert results() == set() and {one.Name for one in document.Objects} == others
    document.redo()
    assert results() == first


def test_a_mesh_is_in_one_analysis(analysis, bar, fgmesh, core):
    made = analysis()
    with pytest.raises(core.InvalidInput, match="FGMesh is in Analysis already: complete that one"):
        fgmesh.make_analysis(bar.mesh)
    assert bar.mesh in made.Group
