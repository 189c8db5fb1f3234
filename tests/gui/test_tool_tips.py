# SPDX-License-Identifier: GPL-3.0-or-later
"""Every field and button of every panel tells what it is for."""

WITHOUT_TIPS = """
import freecad.fgmesh as fgmesh
from PySide import QtCore, QtGui
INPUTS = (
    QtGui.QAbstractButton, QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QLineEdit, QtGui.QPlainTextEdit,
    QtGui.QAbstractSlider, QtGui.QAbstractItemView,
)
# What Qt makes inside other inputs, and what FreeCAD puts around panels.
INNER = (*INPUTS, QtGui.QDialogButtonBox)

def around(one):
    while one is not None:
        yield one
        one = one.parentWidget()

def tip_of(one, form):
    # Qt shows the tip of the next widget around, where there is none.
    for other in around(one):
        if other.toolTip().strip() or other is form or isinstance(other, QtGui.QGroupBox):
            return other.toolTip().strip()

def entries_have_tips(one):
    return isinstance(one, QtGui.QComboBox) and bool(one.itemData(1, QtCore.Qt.ToolTipRole))

def is_empty(one):
    # Such a button appears with its text, once there is something to offer.
    return isinstance(one, QtGui.QPushButton) and one.isHidden() and not one.text()

def without_tip(form):
    found = []
    for one in [form, *form.findChildren(QtGui.QWidget)]:
        checkable_box = isinstance(one, QtGui.QGroupBox) and one.isCheckable()
        if not isinstance(one, INPUTS) and not checkable_box:
            continue
        inner = any(isinstance(other, INNER) for other in around(one.parentWidget()))
        if inner or isinstance(one, QtGui.QScrollBar) or getattr(one, "isReadOnly", lambda: False)():
            continue
        editable = not isinstance(one, QtGui.QTableWidget) or one.editTriggers() != QtGui.QAbstractItemView.NoEditTriggers
        count[0] += 1
        if editable and not (tip_of(one, form) or entries_have_tips(one) or is_empty(one)):
            found.append(f"{type(one).__name__} {one.objectName()}")
    return found

from freecad.fgmesh.panels.analysis_panel import AnalysisPanel
from freecad.fgmesh.panels.material_panel import MaterialPanel
from freecad.fgmesh.panels.mesh_panel import MeshPanel
from freecad.fgmesh.panels.preview_panel import PreviewPanel
from freecad.fgmesh.panels.report_panel import ReportPanel
seen = {}
for make in (
    lambda: AnalysisPanel(mesh), lambda: MaterialPanel([part]), lambda: MeshPanel(part, mesh),
    lambda: PreviewPanel(part), lambda: ReportPanel(mesh),
):
    panel, count = make(), [0]
    FreeCADGui.Control.showDialog(panel)
    settle(0.3)
    forms = panel.form if isinstance(panel.form, list) else [panel.form]
    missing = sum((without_tip(form) for form in forms), [])
    seen[type(panel).__name__] = [count[0], missing]
    panel.reject()
    settle(0.1)
return dict(seen=seen)
"""


def test_every_input_of_every_panel_has_a_tool_tip(drive, meshed_box):
    seen = drive(meshed_box + WITHOUT_TIPS)["seen"]
    assert {name: missing for name, (_, missing) in seen.items()} == dict.fromkeys(seen, [])
    least = dict(AnalysisPanel=11, MaterialPanel=10, MeshPanel=14, PreviewPanel=5, ReportPanel=6)
    assert all(seen[name][0] >= number for name, number in least.items()), seen
