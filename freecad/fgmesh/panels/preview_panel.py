# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel that shows a graded solid coloured by its material."""
import FreeCADGui
import numpy as np
from PySide import QtGui

from freecad.fgmesh import core
from freecad.fgmesh.adapter import flag_number
from freecad.fgmesh.model.graded_parts import materials_of
from freecad.fgmesh.model.shown_quantities import constituent_count, constituent_names
from freecad.fgmesh.panels import showing
from freecad.fgmesh.panels.message_label import MessageLabel
from freecad.fgmesh.panels.preview_box import PreviewBox, range_text
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.texts import translate


class PreviewPanel:
    """Nothing in the document changes."""

    def __init__(self, solid):
        self.solid = solid
        self.message = MessageLabel()
        self.message.setObjectName("FGMeshPreviewMessage")
        self.preview = PreviewBox(solid)
        self.preview.looked_at.connect(self._tell_range)
        self.preview.failed.connect(lambda error: self.message.complain(str(error)))
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Material of {}").format(solid.Label))
        self.form.setWindowIcon(QtGui.QIcon(icon("preview")))
        layout = QtGui.QVBoxLayout(self.form)
        layout.addWidget(self.preview)
        layout.addWidget(self.message)
        self.preview.set_constituents(constituent_names(solid), constituent_count(solid))
        self.preview.setChecked(True)
        self._show()

    def getStandardButtons(self):
        return flag_number(QtGui.QDialogButtonBox.Close)

    def reject(self):
        self.preview.close_preview()
        showing.close()
        return True

    def _show(self):
        try:
            self.preview.set_materials(core.list_of(materials_of(self.solid)))
        except core.Error as error:
            self.message.complain(str(error))

    def _tell_range(self, ranges, _):
        if np.isnan(ranges).any():
            self.message.complain(translate("The formula is not defined anywhere on the solid"))
        else:
            self.message.say(range_text(ranges))
