# SPDX-License-Identifier: GPL-3.0-or-later
"""What a command does to a document: one undo step, and lines that FreeCAD's macro recorder keeps."""
from contextlib import contextmanager

import FreeCADGui

from freecad.fgmesh.model.transaction import transaction


@contextmanager
def recorded(document, name):
    """Gives a function that runs a line of Python, recorded. A failure takes all of the step back."""
    FreeCADGui.addModule("freecad.fgmesh")
    with transaction(document, name):
        yield FreeCADGui.doCommand
