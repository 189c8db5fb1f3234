# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives FreeCAD's window as its user does: clicks, keys, and looking. Runs inside FreeCAD.

Widgets are named by their objectName. Every wait has an end, after which it fails.
"""
import json
import os
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

_kept = []
"""Widgets that were looked at: PySide2 takes a widget for deleted when the Python object of its parent goes."""


def settle(seconds=0.2):
    """Lets FreeCAD handle events for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.005)


def wait_until(holds, seconds=30.0):
    """Lets FreeCAD handle events until holds() is true; gives the seconds that it took."""
    start = time.monotonic()
    while not holds():
        if time.monotonic() - start > seconds:
            raise AssertionError(f"not within {seconds} s")
        settle(0.02)
    return time.monotonic() - start


def widget(name):
    """The visible widget with that objectName."""
    found = [one for one in _all_widgets() if one.objectName() == name and one.isVisible()]
    if len(found) != 1:
        raise AssertionError(f"{len(found)} visible widgets are called {name}")
    return found[0]


def click(target, position=None):
    """Clicks with the left button in the middle of a widget, or at a position inside it."""
    target = widget(target) if isinstance(target, str) else target
    _reveal(target)
    if not target.isEnabled():
        raise AssertionError(f"{target.objectName() or target} is not enabled")
    place = QtCore.QPointF(position or _hot_spot(target))
    for kind, buttons in (
        (QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton),
        (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton),
    ):
        event = QtGui.QMouseEvent(
            kind,
            place,
            QtCore.QPointF(target.mapToGlobal(place.toPoint())),
            QtCore.Qt.LeftButton,
            buttons,
            QtCore.Qt.NoModifier,
        )
        QtGui.QApplication.sendEvent(target, event)
    settle(0.05)


def press(target, key, modifiers=QtCore.Qt.NoModifier, text=""):
    """One key, for a widget."""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, key, modifiers, text))


def write(target, text):
    """Replaces what a field holds by typing, key after key, as quickly as one can type."""
    target = widget(target) if isinstance(target, str) else target
    _reveal(target)
    target.setFocus()
    press(target, QtCore.Qt.Key_A, QtCore.Qt.ControlModifier)
    press(target, QtCore.Qt.Key_Delete)
    for letter in text:
        press(target, 0, text=letter)
        settle(0.01)
    settle(0.05)


def write_cell(table, row, column, text):
    """Types into a cell of a table, and ends with Return."""
    table = widget(table)
    table.setCurrentCell(row, column)
    table.editItem(table.item(row, column))
    settle(0.05)
    (field,) = [one for one in _all_widgets() if isinstance(one, QtGui.QLineEdit) and table.isAncestorOf(one)]
    write(field, text)
    press(field, QtCore.Qt.Key_Return)
    settle(0.05)


def choose(name, text):
    """Chooses the entry of a combo box that begins with `text`, by keys."""
    box = widget(name)
    _reveal(box)
    texts = [box.itemText(row) for row in range(box.count())]
    wanted = next((row for row, one in enumerate(texts) if one.startswith(text)), None)
    if wanted is None:
        raise AssertionError(f"{name} has no {text!r} among {texts}")
    box.setFocus()
    while box.currentIndex() != wanted:
        before = box.currentIndex()
        press(box, QtCore.Qt.Key_Down if wanted > before else QtCore.Qt.Key_Up)
        if box.currentIndex() == before:
            raise AssertionError(f"{name} does not move from {texts[before]!r}")
    settle(0.05)


def panel_button(which):
    """Clicks a button of the task panel: "Ok", "Cancel", "Close"."""
    kind = getattr(QtGui.QDialogButtonBox, which)
    boxes = [box for box in _all_widgets() if isinstance(box, QtGui.QDialogButtonBox) and box.isVisible()]
    buttons = [box.button(kind) for box in boxes if box.button(kind)]
    if len(buttons) != 1:
        raise AssertionError(f"{len(buttons)} buttons {which} are shown")
    click(buttons[0])
    settle(0.1)


def select(thing, *names):
    """Selects an object, or parts of it, alone."""
    FreeCADGui.Selection.clearSelection()
    for name in names or ("",):
        FreeCADGui.Selection.addSelection(thing.Document.Name, thing.Name, name)
    settle(0.05)


def command(name):
    """Runs a command by its entry in the menu."""
    actions = FreeCADGui.Command.get(name).getAction()
    if not actions or not FreeCADGui.Command.get(name).isActive():
        raise AssertionError(f"{name} is not active")
    FreeCADGui.runCommand(name)
    settle(0.2)


def picture(path):
    """A picture of the whole screen, as the user sees it."""
    settle(0.3)
    FreeCADGui.getMainWindow().screen().grabWindow(0).save(str(path))


def on_screen(view, point):
    """Where a point of the document is seen: in a picture of the whole screen, and in the view's own widget."""
    area = view.graphicsView().viewport()
    ratio = area.devicePixelRatioF()
    x, y = view.getPointOnScreen(FreeCAD.Vector(*point))
    inside = QtCore.QPointF(x / ratio, (view.getSize()[1] - 1 - y) / ratio)
    corner = area.mapToGlobal(QtCore.QPoint(0, 0))
    return [(corner.x() + inside.x()) * ratio, (corner.y() + inside.y()) * ratio], inside


def mouse(view, kind, place, button, buttons):
    """One event of the mouse in the 3D view."""
    area = view.graphicsView().viewport()
    spot = QtCore.QPointF(area.mapToGlobal(place.toPoint()))
    event = QtGui.QMouseEvent(kind, place, spot, button, buttons, QtCore.Qt.NoModifier)
    QtGui.QApplication.sendEvent(area, event)
    settle(0.05)


def drag(view, start, end, steps=8):
    """Drags with the left button from one place of the view's widget to another, in some steps."""
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    mouse(view, QtCore.QEvent.MouseMove, start, none, none)
    mouse(view, QtCore.QEvent.MouseButtonPress, start, left, left)
    for step in range(1, steps + 1):
        mouse(view, QtCore.QEvent.MouseMove, start + (end - start) * step / steps, none, left)
    mouse(view, QtCore.QEvent.MouseButtonRelease, end, left, none)
    settle(0.1)


def click_view(view, point):
    """Clicks in the 3D view on what is seen at a point of the document."""
    place = on_screen(view, point)[1]
    drag(view, place, place, steps=0)


def in_dialog(opens, fills):
    """Calls opens(), which shows a modal dialog, and fills(dialog) as soon as it is there."""
    failed = []

    def look(tries=200):
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            if tries:
                QtCore.QTimer.singleShot(50, lambda: look(tries - 1))
            return
        try:
            fills(dialog)
        except BaseException as error:
            failed.append(error)
            dialog.reject()

    QtCore.QTimer.singleShot(50, look)
    opens()
    if failed:
        raise failed[0]
    settle(0.1)


def record_macro(name):
    """Starts FreeCAD's macro recorder, as its dialog does; gives the path of the file that it will write."""
    folder = []

    def fill(dialog):
        folder.append(_inside(dialog, "lineEditMacroPath").text())
        write(_inside(dialog, "lineEditPath"), name)
        click(_inside(dialog, "buttonStart"))

    in_dialog(lambda: FreeCADGui.runCommand("Std_DlgMacroRecord"), fill)
    return os.path.join(folder[0], name)


def stop_recording():
    # Since 1.1 the command that starts the recorder stops it, too.
    stop, both = "Std_MacroStopRecord", "Std_DlgMacroRecord"
    FreeCADGui.runCommand(stop if stop in FreeCADGui.listCommands() else both)


def fresh_view(document):
    """Looks at all of a document from a corner."""
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.viewIsometric()
    view.fitAll()
    settle(0.2)
    return view


def main(steps, answer_file, workbench):
    """Runs steps() in a FreeCAD that has just started, and ends it. The file takes what it returns, or its error."""

    def run():
        try:
            window = FreeCADGui.getMainWindow()
            window.showMaximized()
            if workbench:
                FreeCADGui.activateWorkbench(workbench)
            settle(0.5)
            answer = steps()
        except BaseException:
            answer = {"error": traceback.format_exc()}
            picture(answer_file + ".png")
        with open(answer_file, "w", encoding="utf-8") as file:
            json.dump(answer, file)
        os._exit(0)

    QtCore.QTimer.singleShot(1000, run)


def _all_widgets():
    found = QtGui.QApplication.allWidgets()
    _kept.append(found)
    return found


def _inside(parent, name):
    (found,) = [one for one in _all_widgets() if one.objectName() == name and parent.isAncestorOf(one)]
    return found


def _reveal(target):
    """Scrolls the panel until a widget is seen."""
    parent = target.parentWidget()
    while parent is not None and not isinstance(parent, QtGui.QScrollArea):
        parent = parent.parentWidget()
    if parent is not None:
        parent.ensureWidgetVisible(target)
        settle(0.02)


def _hot_spot(target):
    """Where a click counts: on the box of a check box, in the middle of other widgets."""
    if isinstance(target, QtGui.QCheckBox):
        return QtCore.QPoint(8, target.height() // 2)
    return target.rect().center()
