# SPDX-License-Identifier: GPL-3.0-or-later
"""A pin in a plate: two solids that touch, each with its own material.

The pin is uniform; in the plate the first constituent fades away from the hole within a few millimetres,
f = exp(-(r - R)/w). At the interface the fraction may jump; the mesh is conforming there.

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path.
"""
from pathlib import Path

import FreeCAD

import freecad.fgmesh as fgmesh

RADIUS = 8  # mm


def build():
    """A new document with both graded solids in a compound and its mesh object, not meshed yet. Returns the latter."""
    document = FreeCAD.newDocument("TwoSolids")
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 50, 40, 15
    block.Placement.Base = FreeCAD.Vector(-25, -20, 0)
    hole = document.addObject("Part::Cylinder", "Hole")
    hole.Radius, hole.Height = RADIUS, 15
    plate = document.addObject("Part::Cut", "Plate")
    plate.Base, plate.Tool = block, hole
    pin = document.addObject("Part::Cylinder", "Pin")
    pin.Radius, pin.Height = RADIUS, 15
    document.recompute()

    constituents = ["Steel-Generic", "Aluminum-Generic"]
    fgmesh.attach_material(pin, ["0.9"], constituents=constituents)
    fgmesh.attach_material(
        plate,
        fractions=["0.9*exp(-max(r - R, 0)/w)"],
        parameters={"R": RADIUS, "w": 6},  # mm
        constituents=constituents,
    )
    both = document.addObject("Part::Compound", "Both")
    both.Links = [plate, pin]
    document.recompute()
    mesh = fgmesh.make_mesh(document, both)
    mesh.MaterialThreshold = 0.2
    return mesh


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "two_solids"):
    mesh = build()
    fgmesh.generate(mesh)
    mesh.Document.recompute()
    mesh.Document.saveAs(str(Path.home() / "two_solids.FCStd"))
    print(f"{mesh.Document.FileName}: {mesh.TetCount} tetrahedra, {mesh.Status}")
