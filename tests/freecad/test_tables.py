# SPDX-License-Identifier: GPL-3.0-or-later
"""Sampled tables of graded solids: kept in the document, followed by meshes, written into macros."""
import FreeCAD
import numpy as np
import pytest

TABLE = '# hardness of the specimen; depth < 30 & "dry"\nz, value\n0, 0.1\n10, 0.7\n30, 0.4\n'


@pytest.fixture
def tabled_box(box, fgmesh, tmp_path):
    """The placed box with a table along its own height, from a file that is gone."""
    path = tmp_path / "depth.csv"
    path.write_text(TABLE)
    fgmesh.attach_material(box, "t1", tables=[path])
    path.unlink()
    return box


def fractions_at(solid, heights):
    """At points of these heights above the solid's own origin."""
    from freecad.fgmesh.model.graded_solid import material_of

    points = [solid.Placement.multVec(FreeCAD.Vector(3, 4, z)) for z in heights]
    return material_of(solid).evaluate(np.array(points))[:, 0]


def expected_at(heights):
    return np.interp(heights, [0, 10, 30], [0.1, 0.7, 0.4])


def test_the_solid_keeps_the_text(tabled_box):
    assert tabled_box.FGMTables == [TABLE]
    heights = np.linspace(0, 30, 13)
    assert fractions_at(tabled_box, heights) == pytest.approx(expected_at(heights))


def test_paths_texts_and_arrays(box, fgmesh, core):
    array = core.SampledTable({"z": [0, 10, 30]}, [0.1, 0.7, 0.4])
    fgmesh.attach_material(
        box, "(t1 + t2 + t3)/3", tables=[TABLE.encode(), TABLE.replace("\n", "\r\n"), array]
    )
    assert box.FGMTables[:2] == [TABLE, TABLE]
    assert fractions_at(box, [5, 20]) == pytest.approx(expected_at([5, 20]))
    fgmesh.attach_material(box, "z/30")
    assert box.FGMTables == []


def test_undo_and_copies(tabled_box, fgmesh):
    copy = tabled_box.Document.copyObject(tabled_box)
    assert copy.FGMTables == [TABLE]
    tabled_box.Document.UndoMode = 1
    fgmesh.attach_material(tabled_box, "t1", tables=["z value\n0 0\n1 1\n"])
    tabled_box.Document.undo()
    assert tabled_box.FGMTables == [TABLE]
    link = tabled_box.Document.addObject("App::Link", "Link")
    link.LinkedObject = tabled_box
    tabled_box.Document.recompute()
    assert fractions_at(link, [7]) == pytest.approx(expected_at([7]))


def test_no_text_of_a_document_is_a_path(tabled_box, core, tmp_path):
    path = tmp_path / "stranger.csv"
    path.write_text(TABLE)
    tabled_box.FGMTables = [str(path)]
    with pytest.raises(core.InvalidInput, match="table t1: line 1: the columns must be"):
        fractions_at(tabled_box, [1])


def test_saved_meshed_and_out_of_date(tabled_box, fgmesh, coarse_mesh, tmp_path, in_fresh_freecad):
    mesh = coarse_mesh(tabled_box)
    tabled_box.Document.recompute()
    assert mesh.Status == "ok"
    assert mesh.VariationMax <= mesh.MaterialThreshold
    path = str(tmp_path / "tables.FCStd")
    tabled_box.Document.saveAs(path)
    answer = in_fresh_freecad(
        f"""
import FreeCAD
import freecad.fgmesh as fgmesh
document = FreeCAD.openDocument({path!r})
mesh, box = document.FGMesh, document.Box
document.recompute()
answer = [list(box.FGMTables), mesh.Status, box.getEditorMode("FGMTables")]
box.FGMTables = [box.FGMTables[0].replace("0.7", "0.6")]
document.recompute()
answer.append(mesh.Status)
fgmesh.generate(mesh)
answer += [mesh.Status, max(mesh.Fractions)]
box.FGMTables = box.FGMTables * 2
document.recompute()
answer.append(mesh.Status)
"""
    )
    assert answer[:3] == [[TABLE], "ok", ["Hidden"]]
    assert answer[3] == "out of date: the table t1 was changed"
    assert answer[4] == "ok" and 0.5 < answer[5] <= 0.6
    assert answer[6] == "out of date: the material has other tables"


def test_documents_from_before_tables(mesh):
    """The property is missing, and so is its part of the fingerprint."""
    import json

    from freecad.fgmesh.model import fingerprint
    from freecad.fgmesh.model.options import option_values

    now = fingerprint.take(mesh.Shape, option_values(mesh))
    before = json.loads(json.dumps({name: part for name, part in now.items() if name != "tables"}))
    assert mesh.Shape.removeProperty("FGMTables")
    mesh.Document.recompute()
    assert mesh.Status == "ok"
    assert fingerprint.changes(before, fingerprint.take(mesh.Shape, option_values(mesh))) == []


@pytest.fixture
def replayed(document):
    """The draft of a solid after the lines of another draft were run for it."""
    import freecad.fgmesh

    from freecad.fgmesh.model.material_draft import MaterialDraft

    def run(draft, solid):
        lines = list(draft.script(solid))
        for line in lines:
            exec(line, {"FreeCAD": FreeCAD, "freecad": freecad})  # our own lines, as FreeCAD's console does
        return lines, MaterialDraft.of(solid)

    return run


def test_macros_hold_short_tables(tabled_box, document, replayed):
    from freecad.fgmesh.model.material_draft import MaterialDraft

    draft = MaterialDraft.of(tabled_box)
    assert draft.tables == [TABLE]
    other = document.addObject("Part::Box", "Other")
    document.recompute()
    lines, again = replayed(draft, other)
    assert again.tables == [TABLE] and "hardness" in lines[0]


def test_macros_refer_to_long_tables(box, replayed, tmp_path):
    from freecad.fgmesh.model.material_draft import LONGEST_RECORDED, MaterialDraft

    text = "z,value\n" + "".join(f"{z},{z / 5000}\n" for z in range(5000))
    path = tmp_path / "long.csv"
    path.write_text(text)
    assert len(text) > LONGEST_RECORDED
    draft = MaterialDraft(fractions=["t1"], tables=[text], table_files={text: str(path)})
    lines, again = replayed(draft, box)
    assert str(path) in lines[0] and len(lines[0]) < 1000 and again == draft
    path.unlink()
    again.fractions = ["t2"]
    again.tables.insert(0, TABLE)
    lines, last = replayed(again, box)
    assert "FGMTables[0]" in lines[0] and last == again
