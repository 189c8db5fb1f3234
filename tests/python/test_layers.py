# SPDX-License-Identifier: GPL-3.0-or-later
"""Includes and imports point down, and the check notices one that does not."""
import shutil

import pytest

from layers import cpp_violations, python_violations, version_questions


def test_cpp_includes_point_down(source_dir):
    assert list(cpp_violations(source_dir)) == []


def test_python_imports_point_down(source_dir):
    assert list(python_violations(source_dir)) == []


@pytest.mark.parametrize(
    "line",
    ["FreeCAD.Version()", "document.supportedTypes()", "from PySide6 import QtGui", "import Materials"],
)
def test_only_the_adapter_asks_for_a_version(copied_tree, line):
    assert list(version_questions(copied_tree)) == []
    for name in ("model/frames.py", "adapter.py"):
        with (copied_tree / "freecad" / "fgmesh" / name).open("a") as stream:
            stream.write(f"\n{line}\n")
    (found,) = version_questions(copied_tree)
    assert "frames.py" in found


def test_freecad_stays_a_namespace(source_dir):
    assert not (source_dir / "freecad" / "__init__.py").exists()


def test_every_cpp_folder_has_its_own_target(source_dir):
    for folder in {path.parent for path in (source_dir / "cpp").rglob("*.[ch]pp")}:
        assert (folder / "CMakeLists.txt").exists(), f"cpp/{folder.name} has no target"


@pytest.fixture
def copied_tree(source_dir, tmp_path):
    shutil.copytree(source_dir / "cpp", tmp_path / "cpp")
    ignore = shutil.ignore_patterns("__pycache__")
    shutil.copytree(source_dir / "freecad", tmp_path / "freecad", ignore=ignore)
    return tmp_path


@pytest.mark.parametrize(
    "file, line",
    [
        ("core/vec3.hpp", '#include "mesh/mesh_state.hpp"'),
        ("material/material.hpp", '#include "brep/brep_model.hpp"'),
        ("quality/planted.hpp", '  #  include "domain/cgal_types.hpp"'),
        ("pipeline/planted.cpp", '#include "material/material.hpp"'),
        ("mesh/initial.cpp", '#include "mesh/material_refinement.hpp"'),
        ("domain/planted.cpp", "#include <TopoDS.hxx>"),
        ("material/planted.cpp", "#include <CGAL/Interval_nt.h>"),
        ("pipeline/planted.cpp", "#include <pybind11/pybind11.h>"),
        ("core/planted.cpp", '#include "../mesh/initial.hpp"'),
        ("helpers/planted.cpp", "#include <vector>"),
    ],
)
def test_planted_include_is_caught(copied_tree, file, line):
    before = set(cpp_violations(copied_tree))
    planted = copied_tree / "cpp" / file
    planted.parent.mkdir(exist_ok=True)
    with planted.open("a") as stream:
        stream.write(f"\n{line}\n")
    assert len(set(cpp_violations(copied_tree)) - before) == 1


@pytest.mark.parametrize(
    "file, line",
    [
        ("core.py", "import FreeCAD"),
        ("core.py", "from freecad.fgmesh import io"),
        ("io/planted.py", "from freecad.fgmesh.cli import main"),
        ("cli/planted.py", "def late():\n    import Part"),
        ("cli/planted.py", "import PySide2.QtCore"),
        ("model/planted.py", "from freecad.fgmesh.fem import generate"),
        ("model/planted.py", "from PySide import QtCore"),
        ("fem/planted.py", "import FreeCADGui"),
        ("fem/planted.py", "import importlib\nimportlib.import_module('freecad.fgmesh.view.mesh_view')"),
        ("model/planted.py", "from ..fem import generate"),
        ("helpers.py", "import math"),
    ],
)
def test_planted_import_is_caught(copied_tree, file, line):
    before = set(python_violations(copied_tree))
    planted = copied_tree / "freecad" / "fgmesh" / file
    planted.parent.mkdir(exist_ok=True)
    with planted.open("a") as stream:
        stream.write(f"\n{line}\n")
    assert len(set(python_violations(copied_tree)) - before) == 1
