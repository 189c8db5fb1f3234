# SPDX-License-Identifier: GPL-3.0-or-later
"""Things of a document as Python text, for lines that a macro keeps."""
import FreeCAD


def object_text(thing):
    """Python text that finds `thing` again, in whatever document a macro is replayed."""
    return f"{document_text(thing.Document)}.getObject({thing.Name!r})"


def document_text(document):
    """Likewise for a document: the active one, where it is."""
    if document == FreeCAD.ActiveDocument:
        return "FreeCAD.ActiveDocument"
    return f"FreeCAD.getDocument({document.Name!r})"


def placement_text(placement):
    base, turn = tuple(placement.Base), tuple(placement.Rotation.Q)
    return f"FreeCAD.Placement(FreeCAD.Vector{base!r}, FreeCAD.Rotation{turn!r})"
