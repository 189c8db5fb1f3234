# SPDX-License-Identifier: GPL-3.0-or-later
"""A pin that was hardened around its middle, by a table of measured values.

    f = t1

t1 is the share of martensite that hardened_pin.csv tells over r and z: linear between its samples.

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path.
"""
from pathlib import Path

import FreeCAD

import freecad.fgmesh as fgmesh

TABLE = Path(__file__).absolute().with_suffix(".csv")


def build():
    """A new document with the graded pin and its mesh object, not meshed yet. Returns the latter."""
    document = FreeCAD.newDocument("HardenedPin")
    pin = document.addObject("Part::Cylinder", "Pin")
    pin.Radius, pin.Height = 10, 40  # mm
    document.recompute()

    fgmesh.attach_material(
        pin,
        fractions=["t1"],
        constituents=["Martensite", "Ferrite"],
        tables=[TABLE],
    )
    mesh = fgmesh.make_mesh(document, pin)
    mesh.MaterialThreshold = 0.1
    return mesh


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "hardened_pin"):
    mesh = build()
    fgmesh.generate(mesh)
    mesh.Document.recompute()
    mesh.Document.saveAs(str(Path.home() / "hardened_pin.FCStd"))
    print(f"{mesh.Document.FileName}: {mesh.TetCount} tetrahedra, {mesh.Status}")
