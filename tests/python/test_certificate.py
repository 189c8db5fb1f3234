# SPDX-License-Identifier: GPL-3.0-or-later
"""What is proved of the threshold between the corners of tetrahedra, against samples of closed forms. Lengths in mm."""
import json

import numpy as np
import pytest

from freecad.fgmesh import core
from freecad.fgmesh.cli.summary import summary


def brep_text(shape):
    return shape.exportBrepToString().encode()


@pytest.fixture(scope="module")
def brep():
    """Gives a shape's BREP text (bytes) by name."""
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    return {
        "box": brep_text(Part.makeBox(10, 8, 6)),
        "small": brep_text(Part.makeBox(1, 0.3, 0.3)),
        "ball": brep_text(Part.makeSphere(10)),
        "cylinder": brep_text(Part.makeCylinder(6, 20)),
    }


def inside(result, steps=8):
    """Points of a grid in each tetrahedron, corners included: (m, g, 3)."""
    shares = [
        (i, j, k, steps - i - j - k)
        for i in range(steps + 1)
        for j in range(steps + 1 - i)
        for k in range(steps + 1 - i - j)
    ]
    return np.einsum("gc,mcx->mgx", np.array(shares) / steps, result.points[result.tets[:, :4]])


def ranges(function, result):
    """The range of a function of x, y, z over the grid in each tetrahedron."""
    values = function(*np.moveaxis(inside(result), -1, 0))
    return values.max(axis=1) - values.min(axis=1)


def distance(x, y, z):
    return np.sqrt(x * x + y * y + z * z)


CASES = {
    "ball": ("ball", "exp(-0.4*d)", lambda x, y, z: np.exp(-0.4 * distance(x, y, z)), 0.1),
    "wave": ("small", "0.5+0.1*sin(20*x)", lambda x, y, z: 0.5 + 0.1 * np.sin(20 * x), 0.1),
    "waves": (
        "small",
        "0.5+0.1*sin(20*x)*cos(25*y)",
        lambda x, y, z: 0.5 + 0.1 * np.sin(20 * x) * np.cos(25 * y),
        0.1,
    ),
    "root": ("box", "sqrt(d)/4", lambda x, y, z: np.sqrt(distance(x, y, z)) / 4, 0.1),
    "bend": ("box", "if(x<5,x/10,0.5+(x-5)/20)", lambda x, y, z: np.where(x < 5, x / 10, 0.25 + x / 20), 0.1),
}


@pytest.mark.parametrize("shape, formula, function, threshold", CASES.values(), ids=CASES)
def test_what_is_proved_holds_between_corners(brep, shape, formula, function, threshold):
    options = core.MeshingOptions(material_threshold=threshold)
    result = core.generate_mesh(brep[shape], core.Material([formula]), options)
    figures = core.report(result)["certified"]
    assert figures["holds"] is True and result.status == "ok"
    assert (figures["tets"], figures["broken"], figures["unproved"]) == (len(result.tets), 0, 0)
    largest = ranges(function, result).max()
    assert largest <= figures["bound"] * (1 + 1e-12) <= threshold * (1 + 2e-9)
    assert len(result.broken) == len(result.unproved) == 0
    assert f"all of each tet, at most {figures['bound']:.4f}" in summary(result)


def test_without_it_tetrahedra_break_the_threshold_unseen(brep):
    shape, formula, function, threshold = CASES["ball"]
    options = core.MeshingOptions(material_threshold=threshold, certify=False)
    result = core.generate_mesh(brep[shape], core.Material([formula]), options)
    assert core.report(result)["certified"] == {} and not result.certificate.made
    assert result.status == "ok" and result.variation.max() <= threshold
    assert ranges(function, result).max() > threshold
    assert "certified" not in summary(result)


def test_three_constituents(brep):
    material = core.Material(["0.3+0.2*sin(x/2)", "exp(-d/4)/3"])
    result = core.generate_mesh(brep["box"], material, core.MeshingOptions(material_threshold=0.1))
    proved = np.setdiff1d(np.arange(len(result.tets)), [*result.broken, *result.unproved])
    points = inside(result, 4)[proved]
    x = points[..., 0]
    first, second = 0.3 + 0.2 * np.sin(x / 2), np.exp(-np.linalg.norm(points, axis=-1) / 4) / 3
    fractions = np.stack([first, second, 1 - first - second], axis=-1)
    apart = np.linalg.norm(fractions[:, :, None] - fractions[:, None], axis=-1).max(axis=(1, 2))
    assert len(result.broken) == 0 and len(proved) > 0.95 * len(result.tets)
    assert apart.max() <= 0.1 * (1 + 2e-9)


def test_distances_to_the_solid_itself(brep):
    """Inside of a cylinder the distance to its boundary is known."""
    shape = brep["cylinder"]
    material = core.Material(["1+s1/8"], references=core.references(shape, ["Solid1"]))
    options = core.MeshingOptions(material_threshold=0.2, surface_deviation=0.05)
    result = core.generate_mesh(shape, material, options)
    figures = core.report(result)["certified"]
    assert figures["broken"] == 0 and figures["unproved"] < 0.01 * figures["tets"]

    def depth(x, y, z):
        return np.minimum(np.minimum(z, 20 - z), 6 - np.hypot(x, y)) / 8

    assert np.delete(ranges(depth, result), result.unproved).max() <= 0.2 * (1 + 1e-6)


def test_a_jump_is_told_and_not_refined_for_ever(brep):
    result = core.generate_mesh(brep["box"], core.Material(["0.5*step(7.3,x)+x/50"]))
    without = core.generate_mesh(brep["box"], core.Material(["x/50"]))
    assert len(result.tets) < 1.5 * len(without.tets)
    figures = core.report(result)["certified"]
    assert result.status == "threshold_not_met" and figures["holds"] is False
    x = result.points[result.tets][:, :, 0]
    across = np.flatnonzero((x.min(axis=1) < 7.3) & (x.max(axis=1) >= 7.3))
    assert list(result.broken) == list(across) and figures["broken"] == len(across)
    assert any("jumps" in message for message in result.messages)


def test_a_jump_too_small_for_the_threshold_is_no_fault(brep):
    result = core.generate_mesh(brep["box"], core.Material(["0.05*step(7.3,x)+0.2"]))
    assert result.status == "ok" and core.report(result)["certified"]["holds"]


def test_the_initial_mesh_is_not_certified(brep):
    options = core.MeshingOptions(stop_after="initial")
    assert core.report(core.generate_mesh(brep["box"], core.Material(["x/10"]), options))["certified"] == {}


def test_the_command_line_leaves_it_out_when_asked(fgmesh, shapes, tmp_path):
    arguments = ["--fraction", "x/10", "--threshold", "0.3", "--report", "a.json"]
    assert fgmesh(shapes / "box.brep", *arguments, "-o", "a.vtu").returncode == 0
    assert json.loads((tmp_path / "a.json").read_text())["certified"]["holds"] is True
    assert fgmesh(shapes / "box.brep", *arguments, "--no-certificate", "-o", "b.vtu").returncode == 0
    assert json.loads((tmp_path / "a.json").read_text())["certified"] == {}


def test_the_mesh_does_not_depend_on_threads(brep):
    shape, formula, _, threshold = CASES["ball"]
    one, two = (
        core.generate_mesh(
            brep[shape],
            core.Material([formula]),
            core.MeshingOptions(material_threshold=threshold, threads=threads),
        )
        for threads in (1, 2)
    )
    assert np.array_equal(one.points, two.points) and np.array_equal(one.tets, two.tets)
    assert one.certificate.bound == two.certificate.bound
