# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tests share: the built package on the path, FreeCAD's modules, the folder of the build."""
import os
import platform
import shutil
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


@pytest.fixture(scope="session")
def ccx():
    """The path of CalculiX's solver. Debian 13 alone has no package of it: what needs it is skipped there."""
    found = shutil.which("ccx")
    if found is None and platform.freedesktop_os_release().get("VERSION_CODENAME") == "trixie":
        pytest.skip("calculix-ccx is missing, which Debian 13 does not have")
    return found


@pytest.fixture
def freecad_home(build_dir):
    """A function: makes `home` that of a user who has FGMesh among the add-ons, or not, and these settings as user.cfg."""
    import FreeCAD

    major, minor = map(int, FreeCAD.Version()[:2])
    version = f"v{major}-{minor}" if (major, minor) >= (1, 1) else ""

    def make(home, with_workbench=True, settings=""):
        mod = home / ".local" / "share" / "FreeCAD" / version / "Mod"
        mod.mkdir(parents=True, exist_ok=True)
        if with_workbench and not (mod / "FGMesh").exists():
            (mod / "FGMesh").symlink_to(build_dir / "Mod" / "FGMesh")
        if settings:
            configured = home / ".config" / "FreeCAD" / version
            configured.mkdir(parents=True, exist_ok=True)
            (configured / "user.cfg").write_text(settings)

    return make


@pytest.fixture(scope="session")
def own_namespace(build_dir):
    """The first line of a program that imports FGMesh as its own programs do, without what else is in `freecad`."""
    path = build_dir / "Mod" / "FGMesh" / "freecad" / "fgmesh" / "own_namespace.py"
    return f"import runpy; runpy.run_path({str(path)!r})['install']()\n"


@pytest.fixture
def child_double(own_namespace, tmp_path_factory):
    """A function: the command line of a meshing process that does `action` in place of meshing, or of another
    function of `core`. The names of `action` are control, the run's; asked, all arguments; real, the function
    that it replaces; some modules.
    """

    def make(action, name="generate_mesh"):
        script = tmp_path_factory.mktemp("double") / "child.py"
        script.write_text(
            f"{own_namespace}import ctypes, os, signal, sys, time\n"
            "import numpy as np\nfrom freecad.fgmesh import core\nfrom freecad.fgmesh.worker import child\n"
            f"real = core.{name}\n\ndef double(*asked):\n    control = asked[-1]\n"
            f"    {action}\n\n"
            f"core.{name} = double\nchild.main()\n"
        )
        return [sys.executable, "-P", str(script)]

    return make


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
