# SPDX-License-Identifier: GPL-3.0-or-later
"""Case study I: an exponential distribution about a point.

    f = exp(-alpha * d),    d = |P - O|

The published case leaves its solid and its constants open. Assumed here: a ball of radius 50 mm about O, and
alpha = 0.08 / mm. The distribution has a kink at O and is steepest there, so the mesh is fine in the middle
and coarse near the surface, until the last stage makes the surface round.

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path.
"""
from pathlib import Path

import FreeCAD

import freecad.fgmesh as fgmesh


def build():
    """A new document with the graded ball and its mesh object, not meshed yet. Returns the latter."""
    document = FreeCAD.newDocument("CaseStudy1")
    ball = document.addObject("Part::Sphere", "Ball")
    ball.Radius = 50  # mm
    document.recompute()

    fgmesh.attach_material(
        ball,
        fractions=["exp(-alpha*d)"],
        parameters={"alpha": 0.08},  # 1/mm
        constituents=["Steel-Generic", "Aluminum-Generic"],
    )

    mesh = fgmesh.make_mesh(document, ball)
    mesh.MaterialThreshold = 0.1
    mesh.SurfaceDeviation = 0.04  # mm: even where all facets have it the volume is right within 0.2 %
    return mesh


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "case_study_1"):
    mesh = build()
    fgmesh.generate(mesh)
    mesh.Document.recompute()
    mesh.Document.saveAs(str(Path.home() / "case_study_1.FCStd"))
    print(f"{mesh.Document.FileName}: {mesh.TetCount} tetrahedra, {mesh.Status}")
