# SPDX-License-Identifier: GPL-3.0-or-later
"""A cantilever, steel below and aluminium above, in four kinds of analysis: static, frequency, buckling, thermal.

The fraction of steel falls linearly through the height. The beam bends, swings and buckles as one of the bending
stiffness D = I2 - I1^2/I0, I_n being the integral of E z^n over its section; heated, it bends by itself.

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path.
"""
import re
from pathlib import Path

import FreeCAD

import freecad.fgmesh as fgmesh
from freecad.fgmesh.adapter import set_quantity

LENGTH, WIDTH, HEIGHT = 100, 10, 8  # mm
LOAD = 100  # N
WARMER = 50  # K


def build():
    """A new document with the graded beam and its mesh object, not meshed yet. Returns the latter."""
    document = FreeCAD.newDocument("GradedBeam")
    beam = document.addObject("Part::Box", "Beam")
    beam.Length, beam.Width, beam.Height = LENGTH, WIDTH, HEIGHT
    document.recompute()
    fgmesh.attach_material(
        beam,
        fractions=["1 - z/h"],
        parameters={"h": HEIGHT},
        constituents=["Steel-Generic", "Aluminum-Generic"],
    )
    mesh = fgmesh.make_mesh(document, beam)
    mesh.MaterialThreshold = 0.3
    mesh.SecondOrder = True  # four-node tetrahedra are too stiff in bending
    mesh.MaxSize = 5
    return mesh


def analyse(mesh, kind, mode, analysis=None):
    """Makes an analysis of the meshed beam, or changes it to another kind: with the loads of that. Returns the analysis
    and its results."""
    import ObjectsFem

    document, beam = mesh.Document, mesh.Shape
    analysis = fgmesh.make_analysis(mesh, mode=mode, bins=40, analysis=analysis)
    for constraint in [thing for thing in analysis.Group if thing.isDerivedFrom("Fem::Constraint")]:
        document.removeObject(constraint.Name)
    (solver,) = (thing for thing in analysis.Group if hasattr(thing, "AnalysisType"))
    solver.AnalysisType = kind

    def constrain(make, face, **values):
        constraint = make(document)
        if face:
            constraint.References = [(beam, face)]
        for name, value in values.items():
            set_quantity(constraint, name, value)
        analysis.addObject(constraint)
        return constraint

    root, end, lower, upper = "Face1", "Face2", "Face5", "Face6"
    constrain(ObjectsFem.makeConstraintFixed, root)
    if kind == "static":
        force = constrain(ObjectsFem.makeConstraintForce, end, Force=f"{LOAD} N")
        force.Direction, force.Reversed = (beam, ["Edge1"]), True
    elif kind == "buckling":
        constrain(ObjectsFem.makeConstraintPressure, end, Pressure="1 MPa")
    elif kind == "frequency":
        solver.EigenmodesCount = 2
    elif kind == "thermomech":
        constrain(ObjectsFem.makeConstraintInitialTemperature, None, initialTemperature="300 K")
        for face in (lower, upper):
            constrain(ObjectsFem.makeConstraintTemperature, face, Temperature=f"{300 + WARMER} K")
    document.recompute()
    return analysis, fgmesh.solve(analysis)


def buckling_factor(document):
    """The first of the factors that CalculiX has written, as FreeCAD keeps them in the document."""
    texts = [thing.Text for thing in document.Objects if thing.isDerivedFrom("App::TextDocument")]
    return float(
        re.search(r"FACTOR\s+OUTPUT.*?\n\s+1\s+(\S+)", re.sub(r"(?<=\w) (?=\w)", "", texts[-1]), re.DOTALL)[1]
    )


def main():
    mesh = build()
    fgmesh.generate(mesh)
    document = mesh.Document
    analysis, (static,) = analyse(mesh, "static", "continuous")
    deflection = min(vector.z for vector in static.DisplacementVectors)
    _, modes = analyse(mesh, "frequency", "continuous", analysis)
    frequencies = [mode.EigenmodeFrequency for mode in modes]
    analyse(mesh, "buckling", "continuous", analysis)
    factor = buckling_factor(document)
    _, (warm,) = analyse(mesh, "thermomech", "bins", analysis)
    bent = max((vector.z for vector in warm.DisplacementVectors), key=abs)
    print(f"{mesh.TetCount} tetrahedra, {mesh.Status}")
    print(f"deflection under {LOAD} N: {deflection:.4f} mm")
    print(f"first frequencies: {frequencies[0]:.0f} and {frequencies[1]:.0f} Hz")
    print(f"buckles under {factor * WIDTH * HEIGHT:.0f} N")
    print(f"{WARMER} K warmer, its end rises by {bent:.4f} mm")
    document.saveAs(str(Path.home() / "graded_beam.FCStd"))
    return deflection, frequencies, factor, bent


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "graded_beam"):
    main()
