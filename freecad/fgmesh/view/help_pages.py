# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of docs/ that are installed beside the workbench, one for each command, named as it is."""
from pathlib import Path

import FreeCADGui
from PySide import QtCore, QtGui

from freecad.fgmesh.view.texts import translate

_FOLDER = Path(__file__).absolute().parents[3] / "docs" / "commands"
_WIDTH, _HEIGHT = 820, 760  # of the window, pixels
_MARGIN = 40


def page_address(command):
    """The page of `command` as a file:// address, which FreeCAD's What's This opens with or without its own help
    add-on; empty where the page is not installed."""
    path = _FOLDER / f"{command}.md"
    return path.as_uri() if path.exists() else ""


def show_page(command):
    """Opens the page of `command` in a window of its own."""
    window = QtGui.QDialog(FreeCADGui.getMainWindow())
    window.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    window.setObjectName("FGMeshHelp")
    window.setWindowTitle(translate("Help"))
    page = _Page(window)
    page.setSource(QtCore.QUrl(page_address(command)))
    layout = QtGui.QVBoxLayout(window)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(page)
    window.resize(_WIDTH, _HEIGHT)
    window.show()


class _Page(QtGui.QTextBrowser):
    """Pictures are as wide as the page at most; links to the web open in the user's browser."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("FGMeshHelpPage")
        self.setOpenExternalLinks(True)

    def loadResource(self, kind, address):
        found = super().loadResource(kind, address)
        if kind != QtGui.QTextDocument.ImageResource:
            return found
        picture = QtGui.QImage(self.source().resolved(address).toLocalFile())
        width = _WIDTH - _MARGIN
        if picture.width() > width:
            picture = picture.scaledToWidth(width, QtCore.Qt.SmoothTransformation)
        return picture
