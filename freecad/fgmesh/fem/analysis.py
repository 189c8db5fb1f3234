# SPDX-License-Identifier: GPL-3.0-or-later
"""A FEM analysis of a graded mesh, as FreeCAD's FEM workbench knows it."""
from freecad.fgmesh import core
from freecad.fgmesh.adapter import SOLVER_SETTINGS, fem_module, make_standard_solver
from freecad.fgmesh.fem.graded_fields import check_current
from freecad.fgmesh.fem.graded_material import (
    Request,
    fill,
    is_graded_material,
    new_graded_material,
    set_request,
)
from freecad.fgmesh.model import mesh_object
from freecad.fgmesh.model.transaction import transaction


def make_analysis(mesh, mode="bins", bins=20, mixing=None, allowed_error=0.0, analysis=None):
    """Makes a FEM analysis of `mesh`, a graded mesh that is up to date, or completes `analysis`.

    mode           "bins": elements of nearly the same properties share a material, and FreeCAD's own solver object
                   does the rest; "continuous": properties vary inside the elements, for a solver object of ours
    bins           how many materials at most, 1 to 2000
    mixing         {property of material cards: law}, as `mixing.read_laws` has them; the rest by the usual ones
    allowed_error  relative error of the properties, above which there are more bins; 0 where `bins` decides

    What the user has put into the analysis stays there, but for a solver object of the other mode, whose settings
    move to a new one. Raises core.InvalidInput, core.GeometryError and leaves the document as it was. One undo
    step. Returns the analysis.
    """
    request = Request(mode, bins, allowed_error, {} if mixing is None else mixing)
    request.laws()
    check_current(mesh)
    document = mesh.Document
    _check_analysis(analysis, mesh)
    mesh_object.revive(mesh)
    with transaction(document, "Create graded analysis"):
        if analysis is None:
            analysis = fem_module("ObjectsFem").makeAnalysis(document, "Analysis")
        if mesh not in analysis.Group:
            analysis.addObject(mesh)
        graded = next(filter(is_graded_material, analysis.Group), None)
        if graded is None:
            graded = new_graded_material(document, mesh)
            analysis.addObject(graded)
        graded.Mesh = mesh
        set_request(graded, request)
        fill(graded)
        _provide_solver(analysis, mode)
    return analysis


def analyses_for(mesh):
    """What make_analysis() can take as `analysis` for `mesh`: the one that the mesh is in; else None, for a new one, and
    those of its document that have no mesh yet."""
    found = [one for one in mesh.Document.Objects if one.isDerivedFrom("Fem::FemAnalysis")]
    own = [one for one in found if mesh in one.Group]
    return own or [None, *(one for one in found if not _other_meshes(one, mesh))]


def solvers_of(analysis):
    """The solver objects for CalculiX in `analysis`."""
    kinds = ("Fem::SolverCcxTools", "Fem::SolverCalculix")
    return [thing for thing in analysis.Group if getattr(getattr(thing, "Proxy", None), "Type", "") in kinds]


def _check_analysis(analysis, mesh):
    for other in mesh.InList:
        if other.isDerivedFrom("Fem::FemAnalysis") and other != analysis:
            # FreeCAD would take it out of there without a word.
            raise core.InvalidInput(
                f"{mesh.Label} is in {other.Label} already: complete that one, or make another mesh of the solid"
            )
    if analysis is None:
        return
    if not (hasattr(analysis, "isDerivedFrom") and analysis.isDerivedFrom("Fem::FemAnalysis")):
        raise core.InvalidInput(f"{getattr(analysis, 'Label', analysis)} is no FEM analysis")
    if analysis.Document != mesh.Document:
        raise core.InvalidInput(f"{analysis.Label} and {mesh.Label} must be in the same document")
    others = _other_meshes(analysis, mesh)
    if others:
        raise core.InvalidInput(
            f"{analysis.Label} has the mesh {others[0].Label} already, and can have one only: take that out first"
        )


def _other_meshes(analysis, mesh):
    """Those that would be solved: results have meshes, too."""
    meshes = [one for one in analysis.Group if one.isDerivedFrom("Fem::FemMeshObject") and one != mesh]
    return [one for one in meshes if "Result" not in getattr(getattr(one, "Proxy", None), "Type", "")]


def _provide_solver(analysis, mode):
    """Has `analysis` a solver object for `mode`, with the settings of one for the other mode."""
    # Only here: it loads the solver framework of the FEM workbench.
    from freecad.fgmesh.fem.graded_solver import is_graded_solver, make_graded_solver

    solvers = solvers_of(analysis)
    others = [solver for solver in solvers if is_graded_solver(solver) != (mode == "continuous")]
    if len(others) == len(solvers):
        make = make_graded_solver if mode == "continuous" else make_standard_solver
        new = make(analysis.Document)
        for solver in others[:1]:
            for name in new.PropertiesList:
                if new.getGroupOfProperty(name) in SOLVER_SETTINGS and name in solver.PropertiesList:
                    setattr(new, name, getattr(solver, name))
        analysis.addObject(new)
    for solver in others:
        analysis.Document.removeObject(solver.Name)
