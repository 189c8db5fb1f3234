# SPDX-License-Identifier: GPL-3.0-or-later
"""A bracket whose material changes from one of its faces to another.

    f = (d1 / (d1 + d2))^n

d1 and d2 are the distances to two faces of the bracket: the foot, which is all of the second constituent, and the
end of the arm, which is all of the first. The faces may have any place and shape.

Run it as a macro in FreeCAD, or with /usr/bin/python3 where FreeCAD's modules are on the path.
"""
from pathlib import Path

import FreeCAD

import freecad.fgmesh as fgmesh


def build():
    """A new document with the graded bracket and its mesh object, not meshed yet. Returns the latter."""
    document = FreeCAD.newDocument("FaceToFace")
    foot = document.addObject("Part::Box", "Foot")
    foot.Length, foot.Width, foot.Height = 60, 40, 12  # mm
    arm = document.addObject("Part::Box", "Arm")
    arm.Length, arm.Width, arm.Height = 12, 40, 50
    bracket = document.addObject("Part::Fuse", "Bracket")
    bracket.Base, bracket.Tool = foot, arm
    bracket.Refine = True
    document.recompute()

    fgmesh.attach_material(
        bracket,
        fractions=["(d1/(d1 + d2))^n"],
        parameters={"n": 1},
        constituents=["Aluminum-Generic", "Steel-Generic"],
        references=[face_at(bracket, lowest=True), face_at(bracket, lowest=False)],
    )
    mesh = fgmesh.make_mesh(document, bracket)
    mesh.MaterialThreshold = 0.1
    return mesh


def face_at(thing, lowest):
    """FaceN of the lowest, or the highest, face of `thing`."""
    heights = [face.CenterOfMass.z for face in thing.Shape.Faces]
    return f"Face{heights.index(min(heights) if lowest else max(heights)) + 1}"


# FreeCAD runs a macro as __main__, freecadcmd imports it by its name.
if __name__ in ("__main__", "face_to_face"):
    mesh = build()
    fgmesh.generate(mesh)
    mesh.Document.recompute()
    mesh.Document.saveAs(str(Path.home() / "face_to_face.FCStd"))
    print(f"{mesh.Document.FileName}: {mesh.TetCount} tetrahedra, {mesh.Status}")
