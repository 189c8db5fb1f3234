# SPDX-License-Identifier: GPL-3.0-or-later
"""From a mesh to an analysis by mouse, and on with the FEM workbench's own buttons."""
import pytest

PUSHED = """
import ObjectsFem
from freecad.fgmesh import adapter
fixed = ObjectsFem.makeConstraintFixed(document, "Held")
fixed.References = [(part, "Face5")]
push = ObjectsFem.makeConstraintPressure(document, "Push")
push.References = [(part, "Face6")]
adapter.set_quantity(push, "Pressure", "10 MPa")
analysis.addObjects([fixed, push])
document.recompute()
solver = next(one for one in analysis.Group if hasattr(one, "AnalysisType"))
FreeCADGui.activateWorkbench("FemWorkbench")
select(solver)
command("FEM_SolverRun")
wait_until(lambda: any(one.isDerivedFrom("Fem::FemResultObject") for one in analysis.Group), 60)
result = next(one for one in analysis.Group if one.isDerivedFrom("Fem::FemResultObject"))
moved = min(vector.z for vector in result.DisplacementVectors)
"""
"""10 MPa on the box, by the Run button: how far it moves."""


@pytest.mark.usefixtures("ccx")
def test_an_analysis_is_made_constrained_and_solved(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
from windows import wait_for_text
document.UndoMode = 1
steps, before = document.UndoCount, {one.Name for one in document.Objects}
select(mesh)
command("FGMesh_Analysis")
wait_for_text("FGMeshAnalysisMessage", "Materials: 20", 20)
write("FGMeshBins", "8")
wait_for_text("FGMeshAnalysisMessage", "Materials: 8", 20)
write("FGMeshAllowedError", "1")
wait_until(lambda: "within 0.9" in widget("FGMeshAnalysisMessage").text() or "within 1 " in widget("FGMeshAnalysisMessage").text(), 20)
write("FGMeshYoungsModulusLaw", "mori_tanka")
wait_for_text("FGMeshAnalysisMessage", "did you mean mori_tanaka", 20)
picture(f"{pictures}/analysis-wrong-law.png")
panel_button("Ok")
still = widget("FGMeshAnalysisMessage").kind, document.UndoCount - steps
write("FGMeshYoungsModulusLaw", "mori_tanaka")
wait_for_text("FGMeshAnalysisMessage", "Materials:", 20)
picture(f"{pictures}/analysis-panel.png")
panel_button("Ok")
settle(0.5)
analysis = next(one for one in document.Objects if one.isDerivedFrom("Fem::FemAnalysis"))
graded = next(one for one in analysis.Group if "PropertyError" in one.PropertiesList)
made = dict(still=still, steps=document.UndoCount - steps, status=graded.Status, bound=graded.PropertyError, law=graded.YoungsModulusLaw)
"""
        + PUSHED
        + """made["moved"] = moved
fresh_view(document)
picture(f"{pictures}/analysis-solved.png")
return made
"""
    )
    assert answer["still"] == ["error", 0]
    assert (answer["steps"], answer["status"], answer["law"]) == (1, "ok", "mori_tanaka")
    assert 0 < answer["bound"] <= 0.01
    # 10 MPa on 30 mm of steel (210 GPa) and aluminium (70 GPa)
    assert -10 / 70000 * 30 < answer["moved"] < -10 / 210000 * 30


@pytest.mark.usefixtures("ccx")
def test_the_continuous_mode_by_mouse_runs_from_the_fem_workbench(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
from windows import wait_for_text
document.UndoMode = 1
select(mesh)
command("FGMesh_Analysis")
choose("FGMeshMode", "Continuous")
wait_for_text("FGMeshAnalysisMessage", "vary inside", 20)
panel_button("Ok")
settle(0.5)
analysis = next(one for one in document.Objects if one.isDerivedFrom("Fem::FemAnalysis"))
"""
        + PUSHED
        + """
name, solved = solver.Name, [one.Name for one in document.Objects if "Result" in one.Name]
document.undo()
left = [one.Name for one in document.Objects if "Result" in one.Name]
return dict(moved=moved, name=name, solved=solved, left=left, kept=analysis in document.Objects)
"""
    )
    assert len(answer["solved"]) == 2 and answer["left"] == [] and answer["kept"]
    assert answer["name"] == "GradedSolver"
    assert -10 / 70000 * 30 < answer["moved"] < -10 / 210000 * 30


def test_a_stale_mesh_is_told_and_cancel_leaves_nothing(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
from windows import wait_for_text
before = {one.Name for one in document.Objects}
part.FGMFractions = ["z/60"]
document.recompute()
select(mesh)
command("FGMesh_Analysis")
wait_for_text("FGMeshAnalysisMessage", "Mesh it again", 20)
panel_button("Ok")
kind = widget("FGMeshAnalysisMessage").kind
panel_button("Cancel")
return dict(kind=kind, same=before == {one.Name for one in document.Objects})
"""
    )
    assert (answer["kind"], answer["same"]) == ("error", True)
