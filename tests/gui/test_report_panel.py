# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a mesh: its figures, files and looks."""
import csv


def test_figures_files_and_looks(drive, meshed_box, tmp_path):
    answer = drive(
        f"folder = {str(tmp_path)!r}\n"
        + meshed_box
        + """
steps = document.UndoCount
select(mesh)
command("FGMesh_Report")
table = widget("FGMeshStages")
rows = {table.item(row, 0).text(): [table.item(row, column).text() for column in (1, 2, 3)] for row in range(table.rowCount())}
proved = widget("FGMeshCertificate").text()
picture(f"{pictures}/report-panel.png")
for look in ("Largest variation", "Smallest angles", "Plain", "Fraction"):
    choose("FGMeshLook", look)
    picture(f"{pictures}/report-{look.split()[0].lower()}.png")
choose("FGMeshCutAxis", "Y")
picture(f"{pictures}/report-cut.png")

from freecad.fgmesh.panels import report_panel
answers = iter(["figures", "angles.svg"])
report_panel.QtGui.QFileDialog.getSaveFileName = lambda *asked: (folder + "/" + next(answers), "")
click("FGMeshSaveTable")
choose("FGMeshHistogram", "Dihedral")
click("FGMeshSavePicture")
panel_button("Close")
return dict(rows=rows, proved=proved, tets=mesh.TetCount, low=mesh.DihedralMin, steps=document.UndoCount - steps)
"""
    )
    assert answer["rows"]["tetrahedra"][2] == str(answer["tets"])
    assert float(answer["rows"]["angle min"][2]) == round(answer["low"], 2)
    assert answer["rows"]["above threshold"][1:] == ["0", "0"]
    assert answer["proved"].startswith("Proved over the whole of each tetrahedron")
    assert answer["steps"] == 0
    with open(tmp_path / "figures.csv", newline="") as file:
        lines = list(csv.reader(file))
    assert lines[0] == ["figure", "initial", "material", "geometry"]
    assert ["tetrahedra", str(answer["tets"])] == [lines[3][0], lines[3][3]]
    start = lines.index(["dihedral from", "dihedral to", "initial", "material", "geometry"])
    assert sum(int(line[4]) for line in lines[start + 1 :]) == 6 * answer["tets"]
    assert "<svg" in (tmp_path / "angles.svg").read_text()


def test_a_file_that_cannot_be_written_is_told(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
select(mesh)
command("FGMesh_Report")
from freecad.fgmesh.panels import report_panel
panel = report_panel.ReportPanel(mesh)
panel._save("/nowhere/at/all.csv", panel.save_table)
said = panel.message.kind, panel.message.text()
panel_button("Close")
return dict(said=said)
"""
    )
    assert answer["said"][0] == "error" and "/nowhere/at/all.csv" in answer["said"][1]
