# SPDX-License-Identifier: GPL-3.0-or-later
"""A task panel with a Help button."""
from PySide import QtGui

from freecad.fgmesh.adapter import flag_number
from freecad.fgmesh.view.help_pages import page_address, show_page


class WithHelp:
    """What FreeCAD asks of a panel is answered by `panel`, with a button more, which opens the page of `command`."""

    def __init__(self, panel, command):
        self._panel, self._command = panel, command

    def __getattr__(self, name):
        return getattr(self._panel, name)

    def getStandardButtons(self):
        buttons = self._panel.getStandardButtons()
        return buttons | flag_number(QtGui.QDialogButtonBox.Help) if page_address(self._command) else buttons

    def helpRequested(self):
        show_page(self._command)
