# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD in German: every place where a user reads speaks it."""
import xml.etree.ElementTree as xml

import pytest

LOOK = """
from PySide import QtGui
import freecad.fgmesh as fgmesh

def texts():
    shown = [one for one in QtGui.QApplication.allWidgets() if one.isVisible()]
    found = set()
    for one in shown:
        for name in ("text", "title", "windowTitle", "toolTip", "placeholderText", "plainText"):
            ask = getattr(one, name, None)
            value = ask() if callable(ask) else None
            if isinstance(value, str):
                found.add(value.replace("&", ""))
        if isinstance(one, QtGui.QComboBox):
            found.update(one.itemText(row) for row in range(one.count()))
        if isinstance(one, QtGui.QTableWidget):
            heads = [one.horizontalHeaderItem(column) for column in range(one.columnCount())]
            cells = [one.item(row, 0) for row in range(one.rowCount())]
            found.update(item.text() for item in heads + cells if item)
    return sorted(found - {""})

document = FreeCAD.newDocument("Teil")
part = document.addObject("Part::Cylinder", "Cylinder")
part.Radius, part.Height = 20, 60
document.recompute()
fresh_view(document)
fgmesh.attach_material(part, "z/60", constituents=["Steel-Generic", "Aluminum-Generic"])
seen = {"window": texts()}
names = [f"FGMesh_{name}" for name in ("Material", "Preview", "Mesh", "Report", "Analysis", "Examples")]
(actions,) = zip(*[FreeCADGui.Command.get(name).getAction() for name in names])
seen["menu"] = [action.text().replace("&", "") for action in actions]
seen["tips"] = [action.toolTip() for action in actions]
select(part)
command("FGMesh_Material")
seen["material"] = texts()
picture(f"{pictures}/german-material.png")
panel_button("Cancel")
select(part)
command("FGMesh_Preview")
wait_until(lambda: "bis" in widget("FGMeshPreviewMessage").text())
seen["preview"] = texts()
panel_button("Close")
select(part)
command("FGMesh_Mesh")
write("FGMeshMaterialThreshold", "0,2")
write("FGMeshMaxSize", "8,5 mm")
write("FGMeshMinSize", "klein")
settle(0.2)
seen["refused"] = [widget("FGMeshRunMessage").text()]
write("FGMeshMinSize", "")
click("FGMeshStart")
wait_until(lambda: document.getObject("FGMesh") is not None and widget("FGMeshStart").isEnabled(), 60)
seen["mesh"] = texts()
picture(f"{pictures}/german-mesh.png")
click("FGMeshOpenReport")
wait_until(lambda: "FGMeshStages" in [one.objectName() for one in QtGui.QApplication.allWidgets() if one.isVisible()])
settle(0.3)
seen["report"] = texts()
picture(f"{pictures}/german-report.png")
panel_button("Close")
select(document.FGMesh)
command("FGMesh_Analysis")
wait_until(lambda: "Materialien" in widget("FGMeshAnalysisMessage").text())
seen["analysis"] = texts()
picture(f"{pictures}/german-analysis.png")
panel_button("Cancel")

def fill(dialog):
    show_preference_page(dialog, "FGMesh")
    seen["preferences"] = texts()
    picture(f"{pictures}/german-preferences.png")
    dialog.reject()

in_dialog(lambda: FreeCADGui.runCommand("Std_DlgPreferences"), fill)
mesh = document.FGMesh
return dict(seen=seen, values=[mesh.MaterialThreshold, mesh.MaxSize.Value], undo=list(document.UndoNames)[:1])
"""


@pytest.fixture(scope="module")
def translations(source_dir):
    found = {}
    for context in xml.parse(source_dir / "translations" / "FGMesh_de.ts").getroot().iter("context"):
        for message in context.iter("message"):
            source, translation = message.find("source").text, message.find("translation").text
            found[context.find("name").text, source] = translation
    return found


def test_menu_panels_and_preferences_are_german(drive, preferences, translations):
    answer = drive(LOOK, settings=preferences(General={"Language": "German", "UseLocaleFormatting": 1}))
    seen = answer["seen"]
    commands = [
        f"FGMesh_{name}" for name in ("Material", "Preview", "Mesh", "Report", "Analysis", "Examples")
    ]
    german = [[done for (context, _), done in translations.items() if context == name] for name in commands]
    assert [text in texts for text, texts in zip(seen["menu"], german)] == [True] * 6, seen["menu"]
    for tip, texts in zip(seen["tips"], german):
        assert any(text in tip for text in texts), tip
    for place, title in {
        "material": "Gradientenwerkstoff von Cylinder",
        "preview": "Material von Cylinder",
        "mesh": "Netz von Cylinder",
        "report": "Bericht zu FGMesh",
        "analysis": "Analyse von FGMesh",
        "preferences": "Vernetzungsläufe",
    }.items():
        assert title in seen[place], seen[place]
    assert seen["refused"][0].startswith("MinSize: 'klein' ist keine Länge")
    assert answer["values"] == [0.2, 8.5]
    assert answer["undo"] == ["Gradierten Festkörper vernetzen"]
    # FreeCAD's own list of workbenches has Mesh in German, too.
    english = {text for (_, text), done in translations.items() if text != done} - set(seen.pop("window"))
    for place, texts in seen.items():
        assert english & set(texts) == set(), place
