# SPDX-License-Identifier: GPL-3.0-or-later
"""Our own pages are what a user gets who asks for help; and the context menu has our commands."""

ASKING = """
import os
from PySide import QtCore, QtGui
try:
    from PySide2.QtGui import QDesktopServices
    from PySide2.QtWidgets import QWhatsThis
except ImportError:
    from PySide6.QtGui import QDesktopServices
    from PySide6.QtWidgets import QWhatsThis

class Desktop(QtCore.QObject):
    @QtCore.Slot(QtCore.QUrl)
    def open(self, address):
        opened.append(address.toLocalFile())

opened, asked = [], []
desktop = Desktop()
QDesktopServices.setUrlHandler("file", desktop, "open")
try:
    import Help  # FreeCAD 1.x has the add-on, which may open the page in several ways
    Help.show = lambda page, *_: opened.append(QtCore.QUrl(page).toLocalFile())
except ImportError:
    pass

def dismiss():
    for box in QtGui.QApplication.topLevelWidgets():
        if isinstance(box, QtGui.QMessageBox) and box.isVisible():
            asked.append(box.text())
            box.reject()

timer = QtCore.QTimer()
timer.timeout.connect(dismiss)
timer.start(50)
"""


def test_whats_this_opens_our_page_without_an_add_on(drive):
    answer = drive(
        ASKING
        + """
names = [f"FGMesh_{name}" for name in ("Material", "Preview", "Mesh", "Report", "Analysis", "Examples")]
for name in names:
    text = FreeCADGui.Command.get(name).getAction()[0].text()
    (button, *_) = [
        one for one in QtGui.QApplication.allWidgets()
        if isinstance(one, QtGui.QToolButton) and one.isVisible() and one.defaultAction() and one.defaultAction().text() == text
    ]
    QWhatsThis.enterWhatsThisMode()
    settle(0.1)
    place = QtCore.QPoint(8, 8)
    QtGui.QApplication.sendEvent(button, QtGui.QHelpEvent(QtCore.QEvent.WhatsThis, place, button.mapToGlobal(place)))
    settle(0.3)
return dict(opened=opened, asked=asked, there=[os.path.exists(path) for path in opened], names=names)
"""
    )
    assert answer["asked"] == []
    assert [path.rsplit("/", 1)[-1] for path in answer["opened"]] == [f"{n}.md" for n in answer["names"]]
    assert answer["there"] == [True] * 6


def test_each_panel_has_a_button_for_its_page(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
heads, pictures_shown = {}, {}
for name, thing, leave in (
    ("Material", part, "Cancel"), ("Preview", part, "Close"), ("Mesh", part, "Close"),
    ("Report", mesh, "Close"), ("Analysis", mesh, "Cancel"),
):
    select(thing)
    command(f"FGMesh_{name}")
    panel_button("Help")
    page = widget("FGMeshHelpPage")
    heads[name] = page.toPlainText().splitlines()[0]
    pictures_shown[name] = page.document().size().width() <= page.viewport().width() + 1
    settle(0.2)
    picture(f"{pictures}/help-{name}.png")
    widget("FGMeshHelp").close()
    settle(0.1)
    panel_button(leave)
return dict(heads=heads, fit=pictures_shown, left=bool(FreeCADGui.Control.activeDialog()))
"""
    )
    assert answer["heads"] == {
        "Material": "Graded material ...",
        "Preview": "Preview of the material",
        "Mesh": "Mesh graded solid ...",
        "Report": "Report of the mesh",
        "Analysis": "Create graded analysis ...",
    }
    assert all(answer["fit"].values()), answer["fit"]
    assert answer["left"] is False


def test_context_menu_of_the_tree_has_what_suits_the_selection(drive, meshed_box):
    answer = drive(
        meshed_box
        + """
from PySide import QtCore, QtGui
plain = document.addObject("Part::Box", "Plain")
document.recompute()
sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
seen = {}
(tree, *_) = [one for one in QtGui.QApplication.allWidgets() if isinstance(one, QtGui.QTreeWidget) and one.isVisible()]

def keep_menu(name):
    menu = QtGui.QApplication.activePopupWidget()
    if menu is None:
        return QtCore.QTimer.singleShot(50, lambda: keep_menu(name))
    seen[name] = [action.text().replace("&", "") for action in menu.actions()]
    menu.close()

for thing in (part, plain, mesh, sheet):
    select(thing)
    settle(0.3)
    (item, *_) = tree.findItems(thing.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
    place = tree.visualItemRect(item).center()
    QtCore.QTimer.singleShot(50, lambda: keep_menu(thing.Name))
    event = QtGui.QContextMenuEvent(QtGui.QContextMenuEvent.Mouse, place, tree.viewport().mapToGlobal(place))
    QtGui.QApplication.sendEvent(tree.viewport(), event)
    settle(0.3)
return dict(seen=seen)
"""
    )
    names = ["Graded material ...", "Preview of the material", "Mesh graded solid ...", "Report of the mesh"]
    found = {name: [text for text in texts if text in names] for name, texts in answer["seen"].items()}
    assert found == {"Box": names[:3], "Plain": names[:1], "FGMesh": names[2:], "Sheet": []}
