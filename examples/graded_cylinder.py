# SPDX-License-Identifier: GPL-3.0-or-later
"""A thick cylinder under pressure inside, E = E0 (r/a)^3 between two plates: a quarter of it, solved, probed along its
radius and drawn beside the exact solution (Horgan and Chan, Journal of Elasticity 55 (1999) 43).

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path. The plot goes to
graded_cylinder.svg in the home folder.
"""
import math
from pathlib import Path

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

import freecad.fgmesh as fgmesh
from freecad.fgmesh.adapter import add_filter, hold, plotted, set_quantity
from freecad.fgmesh.fem.result_fields import fields_of

INNER, OUTER, HEIGHT = 10.0, 20.0, 1.5  # mm
SOFT, POISSON, POWER = 1000.0, 0.3, 3  # E at r = a, MPa
PRESSURE = 100.0  # MPa


def build():
    """A new document with the graded quarter and its mesh object, not meshed yet. Returns the latter."""
    import ObjectsFem

    document = FreeCAD.newDocument("GradedCylinder")
    quarter = document.addObject("Part::Feature", "Quarter")
    outer, inner = (
        Part.makeCylinder(radius, HEIGHT, Vector(), Vector(0, 0, 1), 90) for radius in (OUTER, INNER)
    )
    quarter.Shape = outer.cut(inner)
    stiffest = SOFT * (OUTER / INNER) ** POWER
    cards = []
    for name, modulus in (("Outside", stiffest), ("Inside", SOFT)):
        card = ObjectsFem.makeMaterialSolid(document, name)
        card.Material = {"Name": name, "YoungsModulus": f"{modulus} MPa", "PoissonRatio": str(POISSON)}
        cards.append(card)
    document.recompute()
    fgmesh.attach_material(
        quarter,
        fractions=["((r/a)^n - 1)/((b/a)^n - 1)"],
        parameters={"a": INNER, "b": OUTER, "n": POWER},
        constituents=cards,
    )
    mesh = fgmesh.make_mesh(document, quarter)
    mesh.SecondOrder = True
    mesh.MaxSize = 1.0
    return mesh


def analyse(mesh):
    """The pipeline of the solved analysis, in the continuous mode."""
    import ObjectsFem

    document, quarter = mesh.Document, mesh.Shape
    analysis = fgmesh.make_analysis(mesh, mode="continuous")

    def faces(choose):
        numbered = enumerate(quarter.Shape.Faces, 1)
        return [(quarter, f"Face{number}") for number, face in numbered if choose(face)]

    pressed = ObjectsFem.makeConstraintPressure(document, "Pressure")
    pressed.References = faces(
        lambda face: isinstance(face.Surface, Part.Cylinder) and face.Surface.Radius < OUTER
    )
    set_quantity(pressed, "Pressure", f"{PRESSURE} MPa")
    analysis.addObject(pressed)
    for axis, length in (("x", "XLength"), ("y", "YLength"), ("z", "ZLength")):
        held = ObjectsFem.makeConstraintDisplacement(document, f"Hold{axis.upper()}")
        held.References = faces(lambda face: getattr(face.BoundBox, length) < 1e-6)
        hold(held, axis)
        analysis.addObject(held)
    document.recompute()
    (result,) = fgmesh.solve(analysis)
    return fields_of(result)


def probe(pipeline, field):
    """(r, values) of a field of the pipeline along a radius in the middle of the quarter."""
    line = pipeline.Document.addObject("Fem::FemPostDataAlongLineFilter", "Line")
    add_filter(pipeline, line)
    inside = 1e-6 * OUTER  # off the border, where rounding decides what is in the solid
    diagonal = Vector(math.sqrt(0.5), math.sqrt(0.5), 0)
    ends = [diagonal * radius + Vector(0, 0, HEIGHT / 2) for radius in (INNER + inside, OUTER - inside)]
    line.Point1, line.Point2 = ends
    line.Resolution = 100
    places, values = plotted(line, field)
    return INNER + np.array(places), np.array(values)


def exact(r):
    """(radial displacement mm, hoop stress MPa) at the radii r."""
    poisson = POISSON / (1 - POISSON)
    k, rho = OUTER / INNER, np.asarray(r) / INNER
    root = math.sqrt(POWER**2 + 4 - 4 * poisson * POWER)
    m1, m2 = (-POWER + root) / 2, (-POWER - root) / 2
    stiffness = SOFT * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    first = PRESSURE / stiffness * k**m2 / ((m1 + poisson) * (k**m1 - k**m2))
    second = -PRESSURE / stiffness * k**m1 / ((m2 + poisson) * (k**m1 - k**m2))
    displacement = INNER * (first * rho**m1 + second * rho**m2)
    strain = first * m1 * rho ** (m1 - 1) + second * m2 * rho ** (m2 - 1)
    hoop = stiffness * rho**POWER * (poisson * strain + displacement / r)
    return displacement, hoop


def draw(probes, path):
    """A picture of what probes() gives."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    for axes, ((label, unit), (r, values, true)) in zip(figure.subplots(1, len(probes)), probes.items()):
        axes.plot(r, true, label="exact")
        axes.plot(r[::5], values[::5], "o", label="FGMesh and CalculiX")
        axes.set(xlabel="r (mm)", ylabel=f"{label} ({unit})")
        axes.legend()
    figure.savefig(path, metadata={"Date": None})


def probes(mesh):
    """{(label, unit): (r, values, exact values)} of displacement and hoop stress, meshed and solved."""
    fgmesh.generate(mesh)
    pipeline = analyse(mesh)
    # FreeCAD's pipelines have metres and pascals.
    fields = {
        "Displacement": ("radial displacement", "mm", 1e3),
        "Major Principal Stress": ("hoop stress", "MPa", 1e-6),
    }
    found = {}
    for number, (field, (label, unit, factor)) in enumerate(fields.items()):
        r, values = probe(pipeline, field)
        found[label, unit] = (r, factor * values, exact(r)[number])
    return found


def main():
    mesh = build()
    found = probes(mesh)
    path = Path.home() / "graded_cylinder.svg"
    draw(found, path)
    for (label, unit), (_, values, true) in found.items():
        print(f"{label}: at most {np.abs(values - true).max():.2g} {unit} off, of {np.abs(true).max():.4g}")
    print(f"plotted in {path}")
    mesh.Document.saveAs(str(Path.home() / "graded_cylinder.FCStd"))
    return found


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "graded_cylinder"):
    main()
