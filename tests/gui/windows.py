# SPDX-License-Identifier: GPL-3.0-or-later
"""Menus, dialogs and panels of FreeCAD's window, beside what `driver` does. Runs inside FreeCAD."""
import driver
import FreeCADGui
from PySide import QtCore, QtGui


def widgets_inside(parent):
    """The visible widgets in another one."""
    return [one for one in driver._all_widgets() if one.isVisible() and parent.isAncestorOf(one)]


def is_shown(name):
    return any(one.objectName() == name and one.isVisible() for one in driver._all_widgets())


def wait_for_text(name, part, seconds):
    """Whether a label says `part` within some seconds."""
    try:
        driver.wait_until(lambda: part in driver.widget(name).text(), seconds)
    except AssertionError:
        return False
    return True


def scroll_to_top(name):
    """Scrolls the panel that a widget is in."""
    panel_area(name).verticalScrollBar().setValue(0)
    driver.settle(0.05)


def panel_area(name):
    """The scroll area of the panel that a widget is in."""
    parent = driver.widget(name).parentWidget()
    while not isinstance(parent, QtGui.QScrollArea):
        parent = parent.parentWidget()
    return parent


def open_menu(title):
    """Opens a menu of the menu bar, and leaves it open."""
    bar = FreeCADGui.getMainWindow().menuBar()
    (action,) = [one for one in bar.actions() if one.text().replace("&", "") == title]
    driver._kept.append((bar, action))
    bar.setActiveAction(action)
    driver.settle(0.3)


def close_menus():
    popup = QtGui.QApplication.activePopupWidget()
    while popup is not None:
        popup.close()
        popup = QtGui.QApplication.activePopupWidget()
    driver.settle(0.1)


def show_preference_page(dialog, group):
    """Turns to a group of pages in the dialog of Edit, Preferences."""
    # A list in FreeCAD 0.20, a tree in 1.x, which turns to the page when it is clicked.
    for view in [one for one in widgets_inside(dialog) if isinstance(one, QtGui.QAbstractItemView)]:
        model = view.model()
        found = model.match(model.index(0, 0), QtCore.Qt.DisplayRole, group, 1, QtCore.Qt.MatchExactly)
        if found:
            view.scrollTo(found[0])
            driver.click(view.viewport(), view.visualRect(found[0]).center())
            break
    else:
        raise AssertionError(f"the preferences have no group {group}")
    driver.settle(0.3)


def dialog_button(dialog, which):
    """A button of a dialog: "Ok", "Cancel"."""
    (box,) = [one for one in widgets_inside(dialog) if isinstance(one, QtGui.QDialogButtonBox)]
    return box.button(getattr(QtGui.QDialogButtonBox, which))


def picture_of(target, path):
    """A picture of one window."""
    driver.settle(0.3)
    place = target.frameGeometry()
    pixels = target.screen().grabWindow(0, place.x(), place.y(), place.width(), place.height())
    pixels.save(str(path))
