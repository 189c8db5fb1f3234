# SPDX-License-Identifier: GPL-3.0-or-later
"""How a window looks, measured: texts that are cut off, contrasts. Runs inside FreeCAD."""
import FreeCADGui
import numpy as np
import windows
from PySide import QtCore, QtGui

OF_FREECAD = 4
"""Pixels that FreeCAD's own titles of panels are too low by."""


def cut_texts(anchor):
    """What is not wholly seen in the task panel that the widget `anchor` is in, but for scrolling down: a list of
    (class, name or text, what is wrong)."""
    area = windows.panel_area(anchor)
    found = []
    for one in windows.widgets_inside(area.widget()):
        wrong = _cut(one) or _beyond(one, area.viewport())
        if wrong:
            text = one.text() if hasattr(one, "text") and callable(one.text) else ""
            found.append((one.metaObject().className(), one.objectName() or text, wrong))
    return found


def contrast(widget):
    """Of the text of a widget, as it is drawn, to what it is drawn upon."""
    return text_contrast(pixels_of(widget.grab().toImage()))


def text_contrast(pixels):
    """The largest contrast of any pixel to the commonest one, in (h, w, 3) of 0 to 255."""
    colours, counts = np.unique(pixels.reshape(-1, 3), axis=0, return_counts=True)
    light = luminance(colours)
    background = light[counts.argmax()]
    ratios = (np.maximum(light, background) + 0.05) / (np.minimum(light, background) + 0.05)
    return float(ratios.max())


def ink(widget):
    """The commonest colour of a widget as it is drawn upon its window, and the largest contrast to it."""
    top = widget.window()
    corner = widget.mapTo(top, QtCore.QPoint(0, 0))
    pixels = pixels_of(top.grab(QtCore.QRect(corner, widget.size())).toImage())
    colours, counts = np.unique(pixels.reshape(-1, 3), axis=0, return_counts=True)
    return colours[counts.argmax()].tolist(), text_contrast(pixels)


def luminance(colours):
    """Relative luminance of sRGB colours (n, 3) of 0 to 255, by WCAG 2.1."""
    parts = np.asarray(colours) / 255
    linear = np.where(parts <= 0.03928, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return linear @ [0.2126, 0.7152, 0.0722]


def pixels_of(image):
    """(h, w, 3) of 0 to 255."""
    image = image.convertToFormat(QtGui.QImage.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def colour_bar_pixels():
    """(h, w, 3) of the colour bar on the screen, and by how much it is enlarged."""
    from freecad.fgmesh.view import colour_bar

    bar = next(one() for one in reversed(colour_bar.ColourBar._shown) if one() is not None)
    view = FreeCADGui.ActiveDocument.ActiveView.graphicsView().viewport()
    screen = FreeCADGui.getMainWindow().screen().grabWindow(0)
    ratio = screen.devicePixelRatio()
    corner = view.mapToGlobal(QtCore.QPoint(0, 0)) * ratio
    height = view.height() * ratio
    scale = max(1.0, height / 1000) if height >= 480 else height / 480
    width, tall = bar._size[0] * scale, bar._size[1] * scale
    place = QtCore.QRect(
        int(corner.x() + 16 * scale), int(corner.y() + (height - tall) / 2), int(width), int(tall)
    )
    return pixels_of(screen.copy(place).toImage()), scale


def _cut(one):
    """Whether a widget has less room than its text needs."""
    if isinstance(one, QtGui.QLabel) and one.wordWrap():
        needed = one.heightForWidth(one.width())
        return f"{one.height()} high, needs {needed}" if one.height() < needed else ""
    if isinstance(one, QtGui.QTableWidget):
        return _cut_cells(one)
    if isinstance(one, QtGui.QComboBox):
        option = QtGui.QStyleOptionComboBox()
        option.initFrom(one)
        option.editable = one.isEditable()
        style = one.style()
        place = style.subControlRect(QtGui.QStyle.CC_ComboBox, option, QtGui.QStyle.SC_ComboBoxEditField, one)
        needed = one.fontMetrics().boundingRect(one.currentText()).width()
        return f"{place.width()} wide, needs {needed}" if place.width() < needed else ""
    if isinstance(one, (QtGui.QLabel, QtGui.QAbstractButton, QtGui.QAbstractSpinBox)):
        needed = one.minimumSizeHint()
        narrow = one.width() < needed.width() or one.height() < needed.height() - OF_FREECAD
        return f"{one.size().toTuple()}, needs {needed.toTuple()}" if narrow and _has_text(one) else ""
    if isinstance(one, QtGui.QPlainTextEdit) and one.objectName() == "FGMeshFormula":
        needed = 2 * one.fontMetrics().lineSpacing()
        return f"{one.viewport().height()} high, needs {needed}" if one.viewport().height() < needed else ""
    return ""


def _cut_cells(table):
    """Cells that are narrower than their text, and rows and columns that are not seen without scrolling."""
    found = []
    for column in range(table.columnCount()):
        needed, width = table.sizeHintForColumn(column), table.columnWidth(column)
        if width < needed:
            found.append(f"column {column}: {width} of {needed}")
    across, down, seen = table.horizontalHeader().length(), table.verticalHeader().length(), table.viewport()
    if across > seen.width():
        found.append(f"{across} wide in {seen.width()}")
    if down > seen.height() and table.rowCount() <= 10:
        found.append(f"{down} high in {seen.height()}")
    return ", ".join(found)


def _has_text(one):
    return not hasattr(one, "text") or bool(one.text())


def _beyond(one, viewport):
    """Whether a widget reaches over the left or the right border of what is seen."""
    left = one.mapTo(viewport, QtCore.QPoint(0, 0)).x()
    right = left + one.width()
    if left < 0 or right > viewport.width():
        return f"from {left} to {right} in {viewport.width()}"
    return ""
