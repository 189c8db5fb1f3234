# SPDX-License-Identifier: GPL-3.0-or-later
"""The graded material and the graded solver of an analysis in the tree."""
import FreeCADGui
from PySide import QtGui

from freecad.fgmesh.adapter import solver_view
from freecad.fgmesh.model.stateless import Stateless
from freecad.fgmesh.view import icon
from freecad.fgmesh.view.double_click import run_on
from freecad.fgmesh.view.texts import translate


class GradedMaterialView(Stateless):
    """The proxy of the view provider."""

    def __init__(self, view):
        view.Proxy = self

    def getIcon(self):
        return icon("analysis")

    def doubleClicked(self, view):
        mesh = view.Object.Mesh
        return mesh is not None and run_on(mesh, "FGMesh_Analysis")

    def setupContextMenu(self, view, menu):
        action = QtGui.QAction(translate("Fields on the results"), menu)
        action.triggered.connect(lambda: _add_fields(view.Object))
        menu.addAction(action)


def _add_fields(graded):
    from freecad.fgmesh import core  # only here, so that FreeCAD starts quickly
    from freecad.fgmesh.fem.result_fields import add_fields

    analysis = graded.getParentGroup()
    results = [one for one in analysis.Group if one.isDerivedFrom("Fem::FemResultObject")] if analysis else []
    try:
        if not results:
            raise core.InvalidInput(translate("There are no results yet: solve the analysis first"))
        for result in results:
            add_fields(result)
    except core.Error as error:
        QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "FGMesh", str(error))


def show_graded_material(graded):
    """Gives `graded` this view provider where it has none."""
    view = graded.ViewObject
    if view is not None and not isinstance(view.Proxy, GradedMaterialView):
        GradedMaterialView(view)


class GradedSolverView(Stateless):
    """Where FreeCAD has no panel for a solver of ours: a double click solves."""

    def __init__(self, view):
        view.Proxy = self

    def doubleClicked(self, view):
        _solve(view.Object)
        return True


def _solve(solver):
    from freecad.fgmesh import core  # only here, so that FreeCAD starts quickly
    from freecad.fgmesh.fem.solving import solve

    try:
        solve(solver.getParentGroup())
    except core.Error as error:
        QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "FGMesh", str(error))


def show_graded_solver(solver):
    """Gives `solver` the view provider of FreeCAD's own solvers, with their panel, or ours."""
    view = solver.ViewObject
    if view is not None:
        kind = solver_view() or GradedSolverView
        if not isinstance(view.Proxy, kind):
            kind(view)
