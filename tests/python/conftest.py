# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes as files, the command line as a function, and a small mesh that no mesher made."""
import itertools
import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))  # what tests share beside fixtures

SIDE = 10.0
"""Of the box that most tests mesh, mm."""


@pytest.fixture(scope="session")
def shapes(tmp_path_factory):
    """A folder of shape files: box.brep, box.step (SIDE mm), and others that are to be refused."""
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    folder = tmp_path_factory.mktemp("shapes with blanks")
    box = Part.makeBox(SIDE, SIDE, SIDE)
    box.exportBrep(str(folder / "box.brep"))
    box.exportStep(str(folder / "box.step"))
    Part.makeSphere(SIDE).exportBrep(str(folder / "ball.brep"))
    Part.makePlane(SIDE, SIDE).exportBrep(str(folder / "face.brep"))
    Part.Solid(Part.Shell(box.Faces[:5])).exportBrep(str(folder / "open.brep"))
    plane = Part.makePlane(SIDE, SIDE)
    flat = plane.copy()
    flat.reverse()
    Part.Solid(Part.Shell([plane, flat])).exportBrep(str(folder / "flat.brep"))
    (folder / "empty.step").touch()
    (folder / "text.step").write_text("Dear reader,\nthis is a letter.\n")
    (folder / "noise.brep").write_bytes(bytes(np.random.default_rng(1).integers(0, 256, 5000, np.uint8)))
    for name in ("box.brep", "box.step"):
        whole = (folder / name).read_bytes()
        (folder / f"cut.{name[4:]}").write_bytes(whole[: len(whole) * 2 // 3])
    return folder


@pytest.fixture(scope="module")
def brep():
    """Gives a shape's BREP text (bytes) by name."""
    import FreeCAD  # noqa: F401  must come before Part
    import Part

    shapes = {
        "box": Part.makeBox(10, 20, 5),
        "ball": Part.makeSphere(10),
        "cylinder": Part.makeCylinder(8, 12),
        "drilled": Part.makeBox(20, 20, 8).cut(Part.makeCylinder(5, 8, FreeCAD.Vector(8, 10, 0))),
    }
    return lambda name: shapes[name].exportBrepToString().encode()


@pytest.fixture(scope="module")
def meshed(brep):
    """Mesh a shape; the same call gives the same result without work."""
    from freecad.fgmesh import core

    known = {}

    def run(name, formula, **options):
        key = (name, formula, *sorted(options.items()))
        if key not in known:
            known[key] = core.generate_mesh(
                brep(name), core.Material([formula]), core.MeshingOptions(**options)
            )
        return known[key]

    return run


@pytest.fixture(scope="session")
def launcher(build_dir):
    return build_dir / "bin" / "fgmesh"


@pytest.fixture
def fgmesh(launcher, tmp_path):
    """Run the command line, or another `program`, in an empty folder; gives the completed process, output as
    text."""

    def run(*arguments, program=(launcher,), **keywords):
        command = [
            os.fsencode(word) if isinstance(word, bytes) else str(word) for word in (*program, *arguments)
        ]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120, **keywords)

    return run


@pytest.fixture
def least_jacobian(tmp_path):
    """Smallest Jacobian determinant in the tetrahedra of a .msh file, as gmsh finds it."""

    def run(path):
        plugin = "Plugin(AnalyseMeshQuality)"
        script = f'Merge "{path}";\n{plugin}.JacobianDeterminant = 1;\n{plugin}.Run;\n'
        (tmp_path / "look.geo").write_text(script)
        command = ["gmsh", str(tmp_path / "look.geo"), "-"]
        answer = subprocess.run(command, capture_output=True, text=True, timeout=60)
        assert "Error" not in answer.stdout + answer.stderr
        return float(re.search(r"minJ +=\s*([^,\s]+),", answer.stdout).group(1))

    return run


@pytest.fixture
def changed_fgmesh(own_namespace, tmp_path_factory):
    """A function: a program, the command line after some lines of Python."""

    def make(lines):
        script = tmp_path_factory.mktemp("changed") / "fgmesh.py"
        script.write_text(
            f"{own_namespace}import sys\n{lines}\n"
            "from freecad.fgmesh.cli.main import main\nsys.exit(main())\n"
        )
        return sys.executable, "-P", script

    return make


@pytest.fixture
def fgmesh_whose_child(changed_fgmesh, child_double):
    """A function: the command line whose meshing process does `action` in place of meshing."""

    def make(action):
        return changed_fgmesh(
            "from freecad.fgmesh.worker import run\n" f"run.child_command = lambda: {child_double(action)!r}"
        )

    return make


@pytest.fixture
def cube():
    """A result as generate_mesh gives it, built by hand: a cube of side 2 at the origin, 48 tetrahedra (each
    of 8 small cubes cut along its diagonal), fraction x/2, faces 1 to 6: x=0, x=2, y=0, y=2, z=0, z=2; edges 1
    to 4 along x, 5 to 8 along y, 9 to 12 along z, vertices 1 to 8."""
    points = np.array(list(itertools.product((0.0, 1.0, 2.0), repeat=3)))
    tets = []
    for start in itertools.product((0, 1), repeat=3):
        for order in itertools.permutations(range(3)):
            path = np.cumsum([start, *np.eye(3, dtype=int)[list(order)]], axis=0)
            tet = path @ [9, 3, 1]
            right_handed = np.linalg.det(points[tet[1:]] - points[tet[0]]) > 0
            tets.append(tet if right_handed else tet[[0, 2, 1, 3]])
    tets = np.array(tets, np.int32)
    triangles, faces = [], []
    sides = tets[:, [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]].reshape(-1, 3)
    for face, (axis, value) in enumerate(itertools.product(range(3), (0.0, 2.0)), 1):
        on_face = (points[sides][:, :, axis] == value).all(axis=1)
        triangles.append(sides[on_face])
        faces.append(np.full(on_face.sum(), face, np.int32))
    edges = []
    for axis, first, second in itertools.product(range(3), (0.0, 2.0), (0.0, 2.0)):
        a, b, c = np.flatnonzero((np.delete(points, axis, axis=1) == (first, second)).all(axis=1))
        edges += [(a, b), (b, c)]
    fraction = points[:, 0] / 2
    cube = SimpleNamespace(
        points=points,
        fractions=np.column_stack([fraction, 1 - fraction]),
        tets=tets,
        tet_solids=np.ones(len(tets), np.int32),
        variation=np.ptp(fraction[tets], axis=1),
        dihedral_min=np.full(len(tets), 45.0),
        triangles=np.vstack(triangles),
        triangle_faces=np.concatenate(faces),
        coincident_faces=np.empty((0, 2), np.int32),
        edges=np.array(edges, np.int32),
        edge_edges=np.repeat(np.arange(1, 13, dtype=np.int32), 2),
    )
    cube.carriers = carriers_of(cube)
    return cube


def carriers_of(cube):
    """(n, 2) int32: what carries each point."""
    carriers = np.full((len(cube.points), 2), (3, 1), np.int32)
    for triangle, face in zip(cube.triangles, cube.triangle_faces):
        carriers[triangle] = 2, face
    for edge, number in zip(cube.edges, cube.edge_edges):
        carriers[edge] = 1, number
    corners = np.flatnonzero((cube.points % 2 == 0).all(axis=1))
    carriers[corners] = [(0, number) for number in range(1, 9)]
    return carriers


MIDDLE_EDGES = np.array([(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)])
"""Corners around the nodes 4 to 9 of a ten-node tetrahedron, as VTK's manual draws it."""


@pytest.fixture
def cube10(cube):
    """The cube of ten-node tetrahedra with straight edges: 125 points, all of a grid of 0.5."""
    edges = np.unique(np.sort(cube.tets[:, MIDDLE_EDGES].reshape(-1, 2), axis=1), axis=0)
    node_of = {tuple(edge): node for node, edge in enumerate(edges.tolist(), len(cube.points))}

    def raised(cells, middle_edges):
        rows = np.sort(cells[:, middle_edges], axis=2).tolist()
        middle = [[node_of[tuple(edge)] for edge in row] for row in rows]
        return np.hstack([cells, np.array(middle, np.int32)])

    cube.tets, cube.triangles = raised(cube.tets, MIDDLE_EDGES), raised(cube.triangles, MIDDLE_EDGES[:3])
    cube.edges = raised(cube.edges, MIDDLE_EDGES[:1])
    cube.points = np.vstack([cube.points, cube.points[edges].mean(axis=1)])
    cube.fractions = np.column_stack([cube.points[:, 0] / 2, 1 - cube.points[:, 0] / 2])
    cube.carriers = carriers_of(cube)
    return cube


@pytest.fixture
def bent_cube10(cube10):
    """The same sheared by z += x^2 / 8, which keeps the volume: the map is quadratic, so it is exact."""
    cube10.points = cube10.points + np.outer(cube10.points[:, 0] ** 2 / 8, [0, 0, 1])
    return cube10
