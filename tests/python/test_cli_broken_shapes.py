# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken shapes: each is refused with its exit status, the name of the part that is wrong and a cure."""
import math

import pytest

import broken_shapes as broken
from broken_shapes import SIDE, at, box, brep, part, step, with_cavity

CASES = {
    "open shell": (broken.open_shell, 3, "is open: Edge", "bounds only Face", "add the missing face"),
    "closed shell": (lambda: brep(part().Shell(box().Faces)), 3, "Face1 to Face6", "Solid from shell"),
    "loose faces": (lambda: brep(part().Compound(box().Faces[:3])), 3, "bounds only Face", "sew"),
    "sheet": (lambda: brep(part().makePlane(5, 5)), 3, "no solid", "bounds only Face1"),
    "wire": (
        lambda: brep(part().makePolygon([at(0, 0, 0), at(1, 0, 0), at(1, 1, 0)])),
        3,
        "Edge1",
        "extrude",
    ),
    "nothing": (lambda: brep(part().Compound([])), 3, "the shape is empty", "choose a solid"),
    "faces that cross": (broken.dented_through_the_bottom, 3, "Face1 and Face", "cross", "move them apart"),
    "face that crosses itself": (lambda: brep(part().makeTorus(5, 8)), 3, "Face1 crosses itself", "redraw"),
    "border that crosses itself": (
        broken.bow_tie,
        3,
        "Face5 has a boundary that crosses itself",
        "Check geometry",
    ),
    "zero thickness": (lambda: brep(part().makeBox(10, 10, 1e-6)), 3, "walls of Solid1", "thicken"),
    "cavity through the wall": (
        lambda: with_cavity(part().makeBox(5, 5, 5, at(7, 3, 3))),
        3,
        "Face2 and Face",
        "cross or touch",
        "Boolean",
    ),
    "cavity at the wall": (
        lambda: with_cavity(part().makeBox(5, 5, 5, at(5, 3, 3))),
        3,
        "Face2 and Face",
        "cross or touch",
        "Boolean",
    ),
    "cavity outside": (
        lambda: with_cavity(part().makeBox(5, 5, 5, at(20, 3, 3))),
        3,
        "Solid1 has a cavity that is not inside",
        "Face7",
        "Boolean -> Cut",
    ),
    "gap within a huge tolerance": (broken.moved_point, 3, "Vertex", "1 mm off the end of Edge", "tolerance"),
    "too large": (
        lambda: brep(part().makeSphere(1e9)),
        3,
        "1e+09 mm from the origin",
        "Solid1",
        "scale it down",
    ),
    "too far away": (
        lambda: brep(part().makeBox(1, 1, 1, at(1e9, 0, 0))),
        3,
        "1e+09 mm from the origin",
        "move Solid1",
    ),
    "too small": (
        lambda: brep(part().makeBox(1e-4, 1e-4, 1e-4)),
        3,
        "only 0.000173205 mm",
        "scale Solid1 up",
    ),
    "half space": (lambda: brep(box().Faces[0].makeHalfSpace(at(5, 5, 5))), 3, "Solid1 is open", "Edge1"),
    "no number": (lambda: broken.number_for_ten("nan"), 2, "'nan' in line", "export it again"),
    "infinite number": (lambda: broken.number_for_ten("inf"), 2, "'inf' in line", "export it again"),
    "huge number": (lambda: broken.number_for_ten("1e300"), 2, "'1e300' in line", "export it again"),
    "no number in STEP": (
        lambda: step(box()).replace("(0.,0.,10.)", "(NAN,0.,10.)", 1),
        2,
        "damaged at #",
        "export it again",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_broken_shape(fgmesh, tmp_path, name):
    make, status, *words = CASES[name]
    (tmp_path / "part").write_text(make())
    done = fgmesh("part", "--fraction", "0.5", "-o", "out.vtu")
    assert done.returncode == status, done.stderr
    message = done.stderr.strip().splitlines()[-1]
    assert all(word in message for word in words), message
    assert not (tmp_path / "out.vtu").exists()


SOUND = {
    "large": (lambda: brep(part().makeCylinder(2e8, 4e8)), "mended within the tolerance"),
    "small": (lambda: brep(part().makeSphere(1e-3)), ""),
    "far away": (lambda: brep(part().makeSphere(1, at(1e7, 1e7, 1e7))), ""),
    "huge tolerance, no gap": (lambda: brep(tolerant_box()), ""),
    "cavity": (lambda: with_cavity(part().makeBox(2, 2, 2, at(4, 4, 4))), ""),
    "made of triangles": (lambda: brep(triangulated_ball()), ""),
}


def tolerant_box():
    tolerant = box()
    tolerant.fixTolerance(SIDE / 2)
    return tolerant


def triangulated_ball():
    """A solid of 120 planar triangles, as importers of meshes make it."""
    rings, sides = 6, 12

    def corner(ring, side):
        polar, azimuth = math.pi * ring / rings, 2 * math.pi * side / sides
        return at(
            SIDE * math.sin(polar) * math.cos(azimuth),
            SIDE * math.sin(polar) * math.sin(azimuth),
            SIDE * math.cos(polar),
        )

    faces = []
    for ring in range(rings):
        for side in range(sides):
            a, b = corner(ring, side), corner(ring, side + 1)
            c, d = corner(ring + 1, side + 1), corner(ring + 1, side)
            faces += [
                row
                for row in ((a, c, d), (a, b, c))
                if all((p - q).Length > 1e-6 for p, q in zip(row, row[1:]))
            ]
    shell = part().Shell([part().Face(part().makePolygon([*row, row[0]])) for row in faces])
    shell.sewShape()
    return part().Solid(shell)


@pytest.mark.parametrize("name", SOUND)
def test_odd_but_sound_shape(fgmesh, tmp_path, name):
    make, note = SOUND[name]
    (tmp_path / "part").write_text(make())
    done = fgmesh("part", "--fraction", "0.5", "--stop-after", "initial", "-o", "out.vtu")
    assert done.returncode == 0 and note in done.stderr, done.stderr
    assert (tmp_path / "out.vtu").exists()
