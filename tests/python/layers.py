# SPDX-License-Identifier: GPL-3.0-or-later
"""The layers of the project (CONTRIBUTING.md draws them), and what breaks them in a source tree."""
import ast
import re

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)

CPP_LAYERS = {
    "core": set(),
    "material": {"core"},
    "brep": {"core"},
    "domain": {"core"},
    "quality": {"core"},
    "mesh": {"core", "domain", "quality"},
    "pipeline": {"core", "brep", "domain", "mesh", "quality"},
    "bindings": {"core", "material", "brep", "domain", "mesh", "quality", "pipeline"},
}
"""Folder of cpp/: the other folders that it may include."""

STAGES = {"initial", "material_refinement", "geometry_refinement"}
"""Files of cpp/mesh/ that never include each other."""

LIBRARIES = {
    "OCCT": (re.compile(r"\.hxx$"), {"brep"}),
    "CGAL": (re.compile(r"^CGAL/"), {"domain", "mesh"}),
    "pybind11": (re.compile(r"^pybind11/"), {"bindings"}),
}
"""Library: its headers, and the folders of cpp/ that may include them."""

MODEL = {"adapter", "core", "mixing", "model", "surfaces"}
PYTHON_LAYERS = {
    "adapter": set(),
    "own_namespace": set(),
    "colours": set(),
    "system_limits": set(),
    "input_file": {"_core"},
    "sampled_table": {"_core", "input_file"},
    "core": {"_core", "input_file", "sampled_table"},
    "io": {"core"},
    "mixing": {"core"},
    "surfaces": {"core"},
    "worker": {"core", "surfaces", "system_limits"},
    "cli": {"core", "input_file", "io", "system_limits", "worker"},
    "__main__": {"cli"},
    "pictures": {"colours", "core", "io"},
    "model": {"adapter", "core", "mixing", "surfaces"},
    "fem": MODEL | {"io", "worker"},
    "view": MODEL | {"colours", "fem"},
    "panels": MODEL | {"colours", "fem", "io", "pictures", "view", "worker"},
    "commands": MODEL | {"colours", "fem", "view", "panels", "worker"},
    "init_gui": MODEL | {"colours", "fem", "view", "panels", "commands", "worker"},
    "init": {"fem"},
    "__init__": MODEL | {"fem", "io", "pictures"},
}
"""Module or folder of freecad/fgmesh/: the others that it may import."""

WITHOUT_FREECAD = {
    "own_namespace",
    "core",
    "input_file",
    "sampled_table",
    "system_limits",
    "io",
    "mixing",
    "surfaces",
    "worker",
    "cli",
    "__main__",
    "colours",
    "pictures",
    "__init__",
}
WITH_GUI = {"view", "panels", "commands", "init_gui"}
FREECAD = {
    "FreeCAD",
    "Part",
    "Fem",
    "Mesh",
    "MeshPart",
    "ObjectsFem",
    "femtools",
    "feminout",
    "femmesh",
    "femsolver",
    "femobjects",
    "PartDesign",
    "Import",
}
VERSIONS = re.compile(
    r"FreeCAD\.Version\b|supportedTypes|\b(?:import|from) (?:importFCMat|Materials|PySide[26])\b"
)
"""What only the adapter asks for: which FreeCAD this is."""
GUI = re.compile(r"^(FreeCADGui|FemGui|PartGui|PySide\d?|PyQt\d|shiboken\d?|pivy)$")


def cpp_violations(root):
    """Messages, one for each include below root/cpp that breaks the layers."""
    for path in sorted((root / "cpp").rglob("*.[ch]pp")):
        place = path.relative_to(root / "cpp")
        folder = place.parts[0]
        if folder not in CPP_LAYERS:
            yield f"cpp/{place}: the folder {folder} has no place in the layers"
            continue
        for mark, header in INCLUDE.findall(path.read_text(encoding="utf-8")):
            reason = _forbidden_own(place, header) if mark == '"' else _forbidden_library(folder, header)
            if reason:
                yield f"cpp/{place} includes {header}: {reason}"


def _forbidden_own(place, header):
    folder, _, name = header.partition("/")
    if not name or folder not in CPP_LAYERS:
        return "own headers are named by their folder"
    if folder != place.parts[0] and folder not in CPP_LAYERS[place.parts[0]]:
        return (
            f"{place.parts[0]} may include {', '.join(sorted(CPP_LAYERS[place.parts[0]])) or 'nothing'} only"
        )
    stages = {place.stem, name.rsplit(".", 1)[0]} & STAGES
    if place.parts[0] == folder == "mesh" and len(stages) == 2:
        return "stages never include each other"
    return None


def _forbidden_library(folder, header):
    for library, (pattern, folders) in LIBRARIES.items():
        if pattern.search(header) and folder not in folders:
            return f"{library} stays in {', '.join(sorted(folders))}"
    return None


def python_violations(root):
    """Messages, one for each import below root/freecad/fgmesh that breaks the layers."""
    package = root / "freecad" / "fgmesh"
    for path in sorted(package.rglob("*.py")):
        place = path.relative_to(package)
        layer = place.parts[0].removesuffix(".py")
        if layer not in PYTHON_LAYERS:
            yield f"freecad/fgmesh/{place}: {layer} has no place in the layers"
            continue
        for module in sorted(set(imported_modules(path.read_text(encoding="utf-8")))):
            reason = _forbidden_import(layer, module)
            if reason:
                yield f"freecad/fgmesh/{place} imports {module}: {reason}"


def version_questions(root):
    """Messages, one for each file below root/freecad/fgmesh but the adapter that asks which FreeCAD this is."""
    package = root / "freecad" / "fgmesh"
    for path in sorted(package.rglob("*.py")):
        found = VERSIONS.search(path.read_text(encoding="utf-8"))
        if found and path != package / "adapter.py":
            yield f"{path.relative_to(root)} has {found[0]}, which belongs into adapter.py"


def imported_modules(source):
    """Names of all modules that `source` imports anywhere, those named in texts for importlib included."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            name = "." * node.level + (node.module or "")
            is_package = name == "freecad.fgmesh"
            yield from (f"{name}.{alias.name}" for alias in node.names) if is_package else [name]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            if re.fullmatch(r"freecad\.fgmesh(\.\w+)+", node.value):
                yield node.value


def _forbidden_import(layer, module):
    top = module.split(".")[0]
    if module.startswith("."):
        return "imports are absolute"
    if GUI.match(top) and layer not in WITH_GUI:
        return "only view, panels, commands and init_gui know the GUI"
    if top in FREECAD and layer in WITHOUT_FREECAD:
        return f"{layer} works without FreeCAD"
    if not module.startswith("freecad.fgmesh."):
        return None
    imported = module.split(".")[2]
    if imported != layer and imported not in PYTHON_LAYERS[layer]:
        return f"{layer} may import {', '.join(sorted(PYTHON_LAYERS[layer]))} only"
    return None
