# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials that a solid may be made of: FreeCAD's cards, the user's own, and those of the document."""
import sys
from pathlib import Path

import FreeCAD

_FOLDERS = ("Mod/Material/StandardMaterial", "Mod/Material/Resources/Materials")  # FreeCAD 0.20, 1.x
_USER_FOLDER = "Material"


def card_paths():
    """{name: path} of the material cards of FreeCAD and of its user, whose cards come before those of the same
    name."""
    resources, user = Path(FreeCAD.getResourceDir()), Path(FreeCAD.getUserAppDataDir())
    found = {}
    for folder in [*(resources / folder for folder in _FOLDERS), user / _USER_FOLDER]:
        found.update((path.stem, str(path)) for path in sorted(folder.rglob("*.FCMat")))
    return found


def material_objects(document):
    """The material objects of `document`, as the FEM workbench makes them for solids."""
    return [
        thing for thing in document.Objects if hasattr(thing, "Material") and isinstance(thing.Material, dict)
    ]


def available(document):
    """Names that `attach_material` takes as constituents: of the document's material objects, then of cards."""
    objects = [thing.Name for thing in material_objects(document)]
    return objects + [name for name in sorted(card_paths(), key=str.lower) if name not in objects]


def properties(name, document):
    """{property: text with unit} of a constituent: a material object of `document`, else a card. Empty where there
    is none of that name."""
    for thing in material_objects(document):
        if thing.Name == name:
            return dict(thing.Material)
    path = card_paths().get(name)
    return _card(path) if path else {}


def _reader_of_cards():
    """FreeCAD's own, which only its windows and its command line have on their path."""
    try:
        import importFCMat
    except ImportError:
        sys.path.append(str(Path(FreeCAD.getResourceDir()) / "Mod" / "Material"))
        import importFCMat
    return importFCMat


def _card(path):
    try:
        import Materials  # FreeCAD 1.x
    except ImportError:
        return dict(_reader_of_cards().read(path))
    stem = Path(path).stem
    for material in Materials.MaterialManager().Materials.values():
        if material.Name in (stem, stem.replace("-", " ")):
            return {name: str(value) for name, value in material.Properties.items()}
    return {}
