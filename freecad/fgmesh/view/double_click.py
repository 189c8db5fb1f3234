# SPDX-License-Identifier: GPL-3.0-or-later
"""What a double click on an object in the tree does. Loaded as FreeCAD starts: nothing heavy is imported here."""
import FreeCADGui


def run_on(thing, command):
    """Selects `thing` and runs a command of ours, which FreeCAD knows once the workbench has been active. False where a
    panel is open."""
    if FreeCADGui.Control.activeDialog():
        return False
    FreeCADGui.activateWorkbench("FGMeshWorkbench")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(thing)
    FreeCADGui.runCommand(command)
    return True
