# SPDX-License-Identifier: GPL-3.0-or-later
"""Composition and properties as fields beside stresses and displacements, where FreeCAD's post-processing finds them."""
import tempfile
from pathlib import Path

import Fem

from freecad.fgmesh import core
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.fem.graded_material import is_graded_material, request_of
from freecad.fgmesh.model.constituents import SI_UNITS
from freecad.fgmesh.model.transaction import transaction

_RESULT = "GradedResult"
"""The property by which a pipeline is known as ours."""


def add_fields(result):
    """A post-processing pipeline of `result`, a result object of a graded analysis, in place of the one it may have:
    the fields that FreeCAD gives it, `fraction_1` ... and the properties, as "Density (kg/m^3)", at the nodes; in SI
    units, as FreeCAD's own.

    At an interface, where they may jump, a node has the values of one of the solids. Returns the pipeline, which
    is in the analysis. One undo step. Raises core.InvalidInput where the result is not that of the mesh as it is.
    """
    analysis = result.getParentGroup()
    graded = next(filter(is_graded_material, analysis.Group if analysis else []), None)
    if graded is None:
        raise core.InvalidInput(f"{result.Label} is no result of a graded analysis")
    fields = graded_mesh(graded.Mesh)
    if len(fields.points) != len(result.NodeNumbers):
        raise core.InvalidInput(f"{result.Label} is of another mesh than {graded.Mesh.Label}: solve again")
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "result.vtu")
        Fem.writeResult(path, result)
        _add_point_data(path, fields.at_nodes(request_of(graded).laws(), SI_UNITS))
        with transaction(result.Document, "Add graded fields"):
            remove_fields(analysis, result)
            pipeline = result.Document.addObject("Fem::FemPostPipeline", f"{result.Name}_Fields")
            pipeline.addProperty(
                "App::PropertyLink", _RESULT, "FGMesh", "The result that the fields belong to"
            )
            setattr(pipeline, _RESULT, result)
            pipeline.read(path)
            analysis.addObject(pipeline)
    return pipeline


def _add_point_data(path, values):
    """Adds {name: (n,)} to the .vtu file at `path`. By VTK: others do not read every file that FreeCAD writes."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    for name, column in values.items():
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(grid)
    if not writer.Write():
        raise core.Error(f"{path} cannot be written: is the disk full?")


def fields_of(result):
    """The pipeline that add_fields() has made of `result`; None where there is none."""
    return next((one for one in result.Document.Objects if getattr(one, _RESULT, None) == result), None)


def remove_fields(analysis, result=None):
    """Removes the pipelines of `result`, of all results where None, that add_fields() has made."""
    for thing in analysis.Group:
        if _RESULT in thing.PropertiesList and result in (None, getattr(thing, _RESULT)):
            thing.Document.removeObject(thing.Name)
