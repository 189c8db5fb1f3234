# SPDX-License-Identifier: GPL-3.0-or-later
"""A document that goes from one FreeCAD to another. Run by freecadcmd, with FGMesh among the add-ons:
FGMESH_EXCHANGE is "make" or "look", FGMESH_DOCUMENT its path without ending; answers go beside it, as JSON.
"""
import json
import os
import tempfile
import traceback

import FreeCAD

import freecad.fgmesh as fgmesh
from freecad.fgmesh import adapter

MODES = ("bins", "continuous")


def make(path):
    objects = adapter.fem_module("ObjectsFem")
    for mode in MODES:
        document = FreeCAD.newDocument(f"Exchanged{mode}")
        box = document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height = 10, 20, 30
        document.recompute()
        fgmesh.attach_material(box, "z/h", {"h": 30.0}, ["Steel-Generic", "Aluminum-Generic"])
        mesh = fgmesh.make_mesh(document, box)
        mesh.MaterialThreshold = 0.3
        fgmesh.generate(mesh)
        analysis = fgmesh.make_analysis(mesh, mode=mode, bins=8)
        fixed = objects.makeConstraintFixed(document, "Held")
        fixed.References = [(box, "Face5")]
        push = objects.makeConstraintPressure(document, "Push")
        push.References = [(box, "Face6")]
        adapter.set_quantity(push, "Pressure", "10 MPa")
        analysis.addObjects([fixed, push])
        document.recompute()
        document.saveAs(f"{path}-{mode}.FCStd")
    return {}


def look(path):
    return {mode: seen(f"{path}-{mode}.FCStd") for mode in MODES}


def seen(path):
    """What is in the document as it was opened, and after meshing and completing the analysis again."""
    document = FreeCAD.openDocument(path)
    document.recompute()
    mesh, graded = document.FGMesh, document.GradedMaterial
    (analysis,) = (one for one in document.Objects if one.isDerivedFrom("Fem::FemAnalysis"))
    kept = dict(
        status=mesh.Status,
        materials=graded.Status,
        tets=[mesh.TetCount, mesh.FemMesh.VolumeCount],
        bins=len(graded.Materials),
        modulus=megapascals(graded.Materials[0].Material["YoungsModulus"]),
        deck=deck_of(document, analysis),
    )
    mesh.MaterialThreshold = 0.2
    document.recompute()
    changed = mesh.Status
    mesh.MaterialThreshold = 0.3
    fgmesh.generate(mesh)
    fgmesh.make_analysis(mesh, mode=graded.Mode, bins=8, analysis=analysis)
    document.recompute()
    again = dict(status=mesh.Status, materials=graded.Status, tets=[mesh.TetCount, mesh.FemMesh.VolumeCount])
    return dict(kept=kept, changed=changed, again=again)


def megapascals(text):
    return FreeCAD.Units.Quantity(text).getValueAs("MPa").Value


def deck_of(document, analysis):
    """Lines of the deck that the solver object as it was opened writes; the pressure is given anew, since FreeCAD 0.20
    opens one of 1.x as 0."""
    from freecad.fgmesh.fem.solving import write_deck

    adapter.set_quantity(document.Push, "Pressure", "10 MPa")
    document.recompute()
    with tempfile.TemporaryDirectory() as folder:
        text = write_deck(analysis, folder).read_text()
    return [text.count("*ELASTIC"), text.count("TYPE=TEMPERATURE"), "*DLOAD" in text]


def main():
    path = os.environ["FGMESH_DOCUMENT"]
    try:
        answer = {"make": make, "look": look}[os.environ["FGMESH_EXCHANGE"]](path)
    except BaseException:
        answer = {"error": traceback.format_exc()}
    with open(os.environ["FGMESH_ANSWER"], "w", encoding="utf-8") as file:
        json.dump(answer, file)
    os._exit(0)


main()
