# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes as files, the command line as a function, and a small mesh that no mesher made."""
import itertools
import subprocess
from types import SimpleNamespace

import numpy as np
import pytest

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


@pytest.fixture(scope="session")
def launcher(build_dir):
    return build_dir / "bin" / "fgmesh"


@pytest.fixture
def fgmesh(launcher, tmp_path):
    """Run the command line in an empty folder; gives the completed process, output as text."""

    def run(*arguments, **keywords):
        command = [str(launcher), *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120, **keywords)

    return run


@pytest.fixture
def cube():
    """A result as generate_mesh gives it, built by hand: a cube of side 2 at the origin, 48 tetrahedra (each
    of 8 small cubes cut along its diagonal), fraction x/2, faces 1 to 6: x=0, x=2, y=0, y=2, z=0, z=2."""
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
    inner = (points == 1.0).all(axis=1)
    fraction = points[:, 0] / 2
    return SimpleNamespace(
        points=points,
        carriers=np.where(inner[:, None], (3, 1), (2, 1)).astype(np.int32),
        fraction=fraction,
        tets=tets,
        tet_solids=np.ones(len(tets), np.int32),
        variation=np.ptp(fraction[tets], axis=1),
        dihedral_min=np.full(len(tets), 45.0),
        triangles=np.vstack(triangles),
        triangle_faces=np.concatenate(faces),
    )
