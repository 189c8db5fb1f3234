# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of curved and shifted solids, whose coordinates are no round numbers, as other programs read them."""
import math
import re
import struct
import subprocess

import meshio
import numpy as np
import pytest

AT_THE_ORIGIN = ("cylinder", "ball", "cone", "torus")
SHIFTED = ("cylinder", "plate")


@pytest.fixture(
    scope="module",
    params=[*((name, False) for name in AT_THE_ORIGIN), *((name, True) for name in SHIFTED)],
    ids=[*AT_THE_ORIGIN, *(f"shifted {name}" for name in SHIFTED)],
)
def curved(request, build_dir):
    """The result of meshing a solid; tetrahedra of ten nodes where it is shifted."""
    from freecad.fgmesh import core

    import FreeCAD
    import Part

    shape, shifted = request.param
    solid = {
        "cylinder": lambda: Part.makeCylinder(8, 12),
        "ball": lambda: Part.makeSphere(10),
        "cone": lambda: Part.makeCone(5, 2, 8),
        "torus": lambda: Part.makeTorus(10, 3),
        "plate": lambda: Part.makeBox(20, 20, 4).cut(Part.makeCylinder(5, 4, FreeCAD.Vector(10, 10, 0))),
    }[shape]()
    if shifted:
        axis = FreeCAD.Vector(1, 2, 3)
        solid.Placement = FreeCAD.Placement(FreeCAD.Vector(-1234.5, 0.007, 98.7), FreeCAD.Rotation(axis, 41))
    options = core.MeshingOptions(material_threshold=0.9, surface_deviation=0.8, order=2 if shifted else 1)
    return core.generate_mesh(solid.exportBrepToString().encode(), core.Material(["0.5"]), options)


def size_of(result):
    return np.linalg.norm(np.ptp(result.points, axis=0))


def assert_same_points(found, result):
    """One for one, to the rounding of the largest coordinate."""
    allowed = 4e-16 * np.abs(result.points).max() + 1e-15 * size_of(result)
    assert np.abs(np.asarray(found) - result.points).max() <= allowed


def in_the_order_of(result, found):
    """Rows of `found`, each the nearest to a point of the result."""
    nearest = [np.abs(found - point).max(axis=1).argmin() for point in result.points]
    assert len(set(nearest)) == len(found) == len(result.points)
    return found[nearest]


@pytest.mark.usefixtures("ccx")
def test_calculix(curved, tmp_path, write):
    """What it has read is in its file of results, in six digits; and the volume, which it integrates."""
    path = write(curved, "mesh.inp")
    deck = (
        "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=Steel\n*ELASTIC\n1000., 0.25\n"
        "*SOLID SECTION, ELSET=Solid1, MATERIAL=Steel\n*STEP\n*STATIC\n*BOUNDARY\nSolid1, 1, 3\n"
        "*NODE FILE\nU\n*EL PRINT, ELSET=Solid1, TOTALS=ONLY\nEVOL\n*END STEP\n"
    )
    (tmp_path / "deck.inp").write_text(deck)
    answer = subprocess.run(["ccx", "deck"], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert "Job finished" in answer.stdout and "ERROR" not in answer.stdout, answer.stdout[-2000:]
    rows = re.findall(r"^ -1 *(\d+)(.{12})(.{12})(.{12})$", (tmp_path / "deck.frd").read_text(), re.MULTILINE)
    read = {int(row[0]): [float(text) for text in row[1:]] for row in rows[: len(curved.points)]}
    points = np.array([read[number] for number in range(1, len(curved.points) + 1)])
    assert np.abs(points - curved.points).max() <= 5e-6 * np.abs(curved.points).max()
    volume = float((tmp_path / "deck.dat").read_text().split()[-1])
    assert volume == pytest.approx(curved.solid_volumes[0], rel=1e-5)
    assert_same_points(meshio.read(path).points, curved)
    assert all(len(word.strip()) <= 20 for line in path.read_text().splitlines() for word in line.split(","))


def test_vtk_and_meshio(curved, write):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    path = write(curved, "mesh.vtu")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert np.array_equal(vtk_to_numpy(reader.GetOutput().GetPoints().GetData()), curved.points)
    assert np.array_equal(meshio.read(path).points, curved.points)


def test_gmsh_and_meshio(curved, tmp_path, write):
    path = write(curved, "mesh.msh")
    assert_same_points(in_the_order_of(curved, meshio.read(path).points), curved)
    command = ["gmsh", str(path), "-save", "-format", "msh22", "-o", str(tmp_path / "again.msh")]
    answer = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0 and "Error" not in answer.stdout + answer.stderr
    assert_same_points(in_the_order_of(curved, meshio.read(tmp_path / "again.msh").points), curved)


def test_freecad(curved, write):
    import FreeCAD  # noqa: F401  must come before Fem
    import Fem

    nodes = Fem.read(str(write(curved, "mesh.unv"))).Nodes
    assert_same_points([tuple(nodes[number]) for number in range(1, len(nodes) + 1)], curved)


@pytest.fixture
def write(tmp_path):
    from freecad.fgmesh import io

    def written(result, name):
        io.write_mesh(result, tmp_path / name)
        return tmp_path / name

    return written


def numbers():
    """All doubles that are finite, whatever their exponents, and such as coordinates are."""
    random = np.random.default_rng(7)
    words = random.integers(0, 2**64, 20000, np.uint64)
    anything = [struct.unpack("d", struct.pack("Q", int(word)))[0] for word in words]
    coordinates = random.uniform(-1, 1, 20000) * 10.0 ** random.integers(-7, 7, 20000)
    special = [
        0.0,
        -0.0,
        5e-324,
        1e22,
        -9.9999999999999993e-100,
        0.99999999999999989,
        -1.7976931348623157e308,
    ]
    return [*filter(math.isfinite, anything), *coordinates.tolist(), *special]


def test_numbers_fit_and_are_as_exact_as_fits(build_dir):
    """Read as Fortran reads them, which Python does, too. 20 characters hold at least 13 digits of any number, and all of
    those that have no exponent."""
    from freecad.fgmesh.io.deck_numbers import deck_number

    for number in numbers():
        text = deck_number(number)
        assert re.fullmatch(r"-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", text) and len(text) <= 20
        assert float(text) == pytest.approx(number, rel=5e-13, abs=0)
        if 0.01 <= abs(number) < 1e15:
            assert float(text) == number
        elif 1e-3 <= abs(number) < 0.01:
            assert abs(float(text) - number) <= 1e-18
    for number in (math.nan, math.inf, -math.inf):
        with pytest.raises(ValueError):
            deck_number(number)


def test_rounding_of_coordinates_becomes_zero(build_dir):
    """But not a coordinate that is small because the part is: 1e-15 of its size is nothing to either."""
    from freecad.fgmesh.io.deck_numbers import without_noise

    part = np.array([[6e-16, 0.0, 0.0], [10.0, -8.2e-16, 1e-9]])
    for scale in (1e-3, 1, 1e6):
        assert np.array_equal(without_noise(scale * part), scale * np.array([[0, 0, 0], [10, 0, 1e-9]]))
    far = np.array([[1e6, 1e-12, 0.0], [1e6 + 1, 0.0, 1.0]])
    assert np.array_equal(without_noise(far), far)
