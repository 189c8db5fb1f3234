# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids of more than two constituents in documents, and the cards that constituents may be."""
from pathlib import Path

import numpy as np
import pytest

FORMULAS = ["0.5*z/h", "0.3*exp(-x/8)"]
NAMES = ["Steel-Generic", "Aluminum-Generic", "Copper-Generic"]


@pytest.fixture
def mixed_box(box, fgmesh):
    return fgmesh.attach_material(box, FORMULAS, {"h": 30}, constituents=NAMES)


def test_all_fractions_are_kept_at_the_nodes(mixed_box, fgmesh):
    from freecad.fgmesh.model.mesh_object import fractions_of

    mesh = fgmesh.make_mesh(mixed_box.Document, mixed_box)
    result = fgmesh.generate(mesh)
    assert mesh.Status == "ok"
    assert fractions_of(mesh).shape == (mesh.PointCount, 2)
    np.testing.assert_array_equal(fractions_of(mesh), result.fractions[:, :2])
    inverse = mixed_box.Placement.inverse()
    own = np.array([tuple(inverse.multVec(node)) for node in mesh.FemMesh.Nodes.values()])
    expected = np.column_stack([own[:, 2] / 60, 0.3 * np.exp(-own[:, 0] / 8)])
    np.testing.assert_allclose(fractions_of(mesh), expected, atol=1e-9)


def test_figures_of_tetrahedra_are_those_of_the_mesh(mixed_box, fgmesh):
    from freecad.fgmesh.model.mesh_object import fractions_of
    from freecad.fgmesh.model.tet_figures import variations

    mesh = fgmesh.make_mesh(mixed_box.Document, mixed_box)
    mesh.MaterialThreshold = 0.2
    result = fgmesh.generate(mesh)
    found = variations(fractions_of(mesh), result.tets)
    np.testing.assert_allclose(found, result.variation, atol=1e-12)


def test_each_constituent_and_each_common_property_can_be_shown(mixed_box):
    from freecad.fgmesh.model.shown_quantities import shown_quantities

    quantities = {one.title(): one for one in shown_quantities(NAMES, 3, mixed_box.Document)}
    assert list(quantities)[:3] == [f"fraction of {name}" for name in NAMES]
    fractions = np.array([[0.2, 0.3, 0.5], [1, 0, 0]])
    np.testing.assert_array_equal(quantities["fraction of Copper-Generic"].values(fractions), [0.5, 0])
    density = quantities["density, kg/m^3"]
    assert density.of_constituents == pytest.approx((7900, 2700, 8930), rel=0.02)
    mixed = (
        0.2 * density.of_constituents[0] + 0.3 * density.of_constituents[1] + 0.5 * density.of_constituents[2]
    )
    assert density.values(fractions)[0] == pytest.approx(mixed)
    assert [one.title() for one in shown_quantities([], 3, mixed_box.Document)] == [
        f"fraction of constituent {number}" for number in (1, 2, 3)
    ]


def test_the_draft_of_a_panel_brings_all_back(mixed_box):
    from freecad.fgmesh.model.material_draft import MaterialDraft

    draft = MaterialDraft.of(mixed_box)
    assert (draft.constituents, draft.fractions) == (NAMES, FORMULAS)
    assert draft.material(mixed_box).fractions == FORMULAS
    (line,) = draft.script(mixed_box)
    assert repr(FORMULAS) in line and repr(NAMES) in line


def test_a_name_too_few_is_told(box, fgmesh):
    from freecad.fgmesh import core

    with pytest.raises(core.InvalidInput, match="2 constituents need 1 formulas, not 2"):
        fgmesh.attach_material(box, FORMULAS, {"h": 30}, constituents=NAMES[:2])


def test_a_grading_for_the_second_constituent_has_parameters_of_its_own(box):
    from freecad.fgmesh.model import gradings

    linear = gradings.GRADINGS[0]
    given = {"start": 1.0, "length": 2.0}
    assert gradings.numbered(linear.formula, given, 1) == (linear.formula, given)
    formula, parameters = gradings.numbered(linear.formula, given, 2)
    assert formula == "clamp((z - start2)/length2, 0, 1)"
    assert parameters == {"start2": 1.0, "length2": 2.0}


def test_each_card_that_is_offered_is_the_one_that_is_read(document):
    """By the density that its file tells, where it tells one, whatever the name inside."""
    from freecad.fgmesh.model import constituents

    paths = constituents.card_paths()
    assert len(paths) > 50
    compared = 0
    for name, path in paths.items():
        card = constituents.properties(name, document)
        assert card, path
        density = [line for line in Path(path).read_text("utf-8").splitlines() if "Density" in line]
        if density and card.get("Density"):
            told = density[0].replace("=", ":").split(":", 1)[1].strip().strip("\"'")
            unit = constituents.UNITS["Density"]
            found, expected = (constituents.number_in(text, unit) for text in (card["Density"], told))
            assert found == pytest.approx(expected, rel=1e-9), path
            compared += 1
    assert compared > 20
