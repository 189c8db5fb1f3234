# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests share: the built package on the path, FreeCAD's modules, the folder of the build."""
import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(os.environ.get("FGMESH_BUILD", ROOT / "build")).resolve()

# The built package first: the sources have no extension beside them.
sys.path.insert(0, str(BUILD / "Mod" / "FGMesh"))
sys.path.append("/usr/lib/freecad-python3/lib")


@pytest.fixture(scope="session")
def build_dir():
    """The folder of the build; fails where there is none, since a test that cannot run has not passed."""
    if not (BUILD / "Mod" / "FGMesh").is_dir():
        pytest.fail(f"{BUILD} holds no build: run ./scripts/build, or set FGMESH_BUILD")
    return BUILD


@pytest.fixture(scope="session")
def source_dir():
    return ROOT


@pytest.fixture
def coarse_mesh(build_dir):
    """A function: makes the mesh object of a graded solid, meshes it with few tetrahedra and returns it."""
    import freecad.fgmesh as fgmesh

    def make(solid):
        mesh = fgmesh.make_mesh(solid.Document, solid)
        mesh.MaterialThreshold = 0.3
        fgmesh.generate(mesh)
        return mesh

    return make
