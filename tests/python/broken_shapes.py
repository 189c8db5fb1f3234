# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes that no mesher should accept, made in code: functions that give the text of a BREP or STEP file."""
import tempfile
from pathlib import Path

SIDE = 10.0


def part():
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    return Part


def at(*position):
    import FreeCAD

    return FreeCAD.Vector(*position)


def brep(shape):
    return shape.exportBrepToString()


def step(shape):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "part.step")
        shape.exportStep(str(path))
        return path.read_text()


def box():
    return part().makeBox(SIDE, SIDE, SIDE)


def solid(faces):
    return part().Solid(part().Shell(faces))


def open_shell():
    return brep(solid(box().Faces[:5]))


def with_cavity(inner):
    cavity = inner.Shells[0].copy()
    cavity.reverse()
    return brep(part().makeSolid(part().Compound([box().Shells[0], cavity])))


def dented_through_the_bottom():
    p = [at(x, y, z) for z in (0, 10) for x, y in ((0, 0), (10, 0), (10, 10), (0, 10))] + [at(5, 5, -3)]
    corners = [(3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    corners += [(4, 5, 8), (5, 6, 8), (6, 7, 8), (7, 4, 8)]
    faces = [part().Face(part().makePolygon([p[i] for i in (*row, row[0])])) for row in corners]
    shell = part().Shell(faces)
    shell.sewShape()
    return brep(part().Solid(shell))


def bow_tie():
    points = [at(0, 0, 0), at(10, 10, 0), at(10, 0, 0), at(0, 10, 0), at(0, 0, 0)]
    return brep(part().Face(part().makePolygon(points)).extrude(at(0, 0, 5)))


def moved_point():
    """The tolerance that the STEP reader gives this hides a gap of 1 mm."""
    text = step(box())
    return text.replace("CARTESIAN_POINT('',(0.,0.,10.))", "CARTESIAN_POINT('',(1.,0.,10.))", 1)


def number_for_ten(number):
    return brep(box()).replace(" 10 ", f" {number} ")
