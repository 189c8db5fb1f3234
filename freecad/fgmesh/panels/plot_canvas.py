# SPDX-License-Identifier: GPL-3.0-or-later
"""Matplotlib figures in the colours of the panel around them, light or dark."""
from PySide import QtGui


def plot_canvas(figure):
    """A widget that shows a Figure upon the panel's own background."""
    from matplotlib.backends.backend_qt5agg import FigureCanvasQTAgg

    figure.patch.set_facecolor("none")
    canvas = FigureCanvasQTAgg(figure)
    canvas.setStyleSheet("background-color: transparent;")
    return canvas


def use_text_colour(figure, label):
    """Gives all that is written and ruled in the axes of a Figure the colour of a QLabel's text."""
    label.ensurePolished()  # style sheets have set colours by then
    colour = label.palette().color(QtGui.QPalette.WindowText).name()
    for axis in figure.axes:
        axis.set_facecolor("none")
        axis.tick_params(colors=colour)
        for spine in axis.spines.values():
            spine.set_edgecolor(colour)
        for line in axis.lines:
            line.set_color(colour)
        for text in (axis.title, axis.xaxis.label, axis.yaxis.label, *axis.texts):
            text.set_color(colour)
