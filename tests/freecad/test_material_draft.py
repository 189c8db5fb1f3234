# SPDX-License-Identifier: GPL-3.0-or-later
"""A material that is being written: read from a solid, checked, turned into lines that give the same material."""
import math

import FreeCAD
import pytest

from freecad.fgmesh import core


@pytest.fixture
def draft_class(build_dir):
    from freecad.fgmesh.model.material_draft import MaterialDraft

    return MaterialDraft


def run(lines):
    import freecad.fgmesh

    for line in lines:
        exec(line, {"FreeCAD": FreeCAD, "freecad": freecad})  # our own lines, as FreeCAD's console does


def test_lines_give_another_solid_the_same_material(graded_box, document, draft_class):
    graded_box.setExpression("FGM_h", "Height")
    graded_box.FGMFrame = FreeCAD.Placement(
        FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 30)
    )
    other = document.addObject("Part::Box", "Other")
    other.Height = 30
    document.recompute()
    draft = draft_class.of(graded_box)
    assert draft.parameters == {"h": "Height"}
    run(draft.script(other))
    document.recompute()
    assert draft_class.of(other) == draft
    other.Height = 12
    document.recompute()
    assert other.FGM_h == 12


def test_lines_with_references_and_odd_texts(box, document, draft_class):
    odd = document.addObject("Part::Box", "Odd")
    odd.Label = 'it\'s "odd" \\ \n'
    document.recompute()
    draft = draft_class(
        ["Steel's", 'Alu"minum'], ["d1/(d1+d2) + 0*a"], {"a": "2 cm"}, references=[(box, "Face1"), (odd, "")]
    )
    run(draft.script(box))
    assert list(box.FGMConstituents) == ["Steel's", 'Alu"minum']
    assert box.FGM_a == 20
    assert list(box.FGMReferenceNames) == ["Box.Face1", "Odd"]
    assert draft_class.of(box).references == draft.references


@pytest.mark.parametrize(
    "text, value",
    [
        ("0.08", 0.08),
        ("2 cm", 20),
        ("2*3", 6),
        ("30 deg", math.pi / 6),
        ("Height / 2", 15),
        ("Height/10 mm", 3),
    ],
)
def test_values_of_parameters(box, draft_class, text, value):
    assert draft_class(parameters={"p": text}).values(box) == {"p": pytest.approx(value)}


@pytest.mark.parametrize("text", ["", "  ", "nothing", "Height +", "Height * ", "'a'"])
def test_a_wrong_parameter_is_named(box, draft_class, text):
    with pytest.raises(core.InvalidInput, match="parameter alpha"):
        draft_class(parameters={"alpha": text}).values(box)


def test_an_untouched_solid_has_an_empty_draft(box, draft_class):
    assert draft_class.of(box) == draft_class()
    with pytest.raises(core.FormulaError):
        draft_class.of(box).material(box)
