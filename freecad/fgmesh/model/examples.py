# SPDX-License-Identifier: GPL-3.0-or-later
"""The example documents: each is built by a macro of the folder examples/, which users may read and change."""
import importlib.util
from pathlib import Path
from typing import NamedTuple

from freecad.fgmesh.model.texts import TRANSLATE_LATER

_FOLDER = Path(__file__).absolute().parents[3] / "examples"


class Example(NamedTuple):
    title: str  # English; translated in the context "FGMesh"
    macro: str


EXAMPLES = (
    Example(TRANSLATE_LATER("FGMesh", "Ball, exponential about its centre (case study I)"), "case_study_1"),
    Example(TRANSLATE_LATER("FGMesh", "Cylinder, power law along its axis (case study II)"), "case_study_2"),
    Example(TRANSLATE_LATER("FGMesh", "Bracket, from one face to another"), "face_to_face"),
    Example(TRANSLATE_LATER("FGMesh", "Pin, hardened, by a table of measured values"), "hardened_pin"),
    Example(TRANSLATE_LATER("FGMesh", "Beam, steel below and aluminium above, for analysis"), "graded_beam"),
    Example(TRANSLATE_LATER("FGMesh", "Pin in a plate, two solids with a material each"), "two_solids"),
)


def open_example(example):
    """A new document with graded solids and a mesh object that is not meshed yet. Returns the document."""
    path = _FOLDER / f"{example.macro}.py"
    spec = importlib.util.spec_from_file_location(f"fgmesh_example_{example.macro}", path)
    macro = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(macro)
    return macro.build().Document
