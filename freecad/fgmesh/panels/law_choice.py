# SPDX-License-Identifier: GPL-3.0-or-later
"""A field for the mixing law of a property: one of those that are known, or a formula."""
from freecad.fgmesh import mixing
from freecad.fgmesh.panels.wide_combo import WideCombo
from freecad.fgmesh.view.texts import translate


class LawChoice(WideCombo):
    """Its `text()` is what mixing.read_laws() takes; empty for the usual law."""

    def __init__(self, name, parent=None):
        super().__init__(f"FGMesh{name}Law", parent)
        self.setEditable(True)
        self.addItem("")
        for law in mixing.laws_of(name):
            # Tamura's law is of no use without its stress, which the user has to put into the parentheses.
            self.addItem("tamura(4500)" if law == "tamura" else law)
        self.setToolTip(
            translate(
                "How the property of a mixture follows from those of its constituents: a law of the list, or a formula over "
                "the fractions v1 v2 ... and the constituents' values p1 p2 ...; empty: the usual law"
            )
        )
        self.lineEdit().setPlaceholderText(translate("usual: {}").format(mixing.PROPERTIES[name].default))

    def text(self):
        return self.currentText().strip()

    def set_text(self, text):
        self.setEditText(text)
