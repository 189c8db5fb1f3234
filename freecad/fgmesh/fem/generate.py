# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing from a document and back into it."""
from freecad.fgmesh import core
from freecad.fgmesh.fem import background
from freecad.fgmesh.fem.graded_material import refill
from freecad.fgmesh.model import mesh_object, presentation
from freecad.fgmesh.model.options import option_values
from freecad.fgmesh.model.transaction import transaction

POLL_SECONDS = 0.1


def generate(mesh, control=None, in_process=False):
    """Meshes the solid of `mesh`, an object that make_mesh() made, and stores mesh and figures in it. The graded
    materials of its analyses are made anew.

    Blocks until the mesh is there; `control`, a core.RunControl, lets another thread watch and cancel, and
    sets limits. What the document says counts: expressions that wait for a recompute are computed first. One
    undo step. Returns the core.MeshingResult, for those who want its arrays.

    Meshing happens in a child process, so that a shape which OpenCASCADE or CGAL cannot bear does FreeCAD no
    harm; `in_process` has it in this one.

    Raises core.InvalidInput, core.GeometryError (worker.Crashed, too) or core.Cancelled, and leaves the mesh
    as it was.
    """
    if not mesh_object.is_mesh(mesh):
        raise core.InvalidInput(
            f"{getattr(mesh, 'Label', mesh)} is no mesh of FGMesh: make one by FGMesh, Mesh graded solid "
            "(in Python: make_mesh())"
        )
    mesh_object.revive(mesh)
    request, result = background.adopted(mesh) or _made(mesh, control or core.RunControl(), in_process)
    with transaction(mesh.Document, "Generate graded mesh"):
        request.store(mesh, result)
        refill(mesh)
    return result


def _made(mesh, control, in_process):
    """(background.Request, core.MeshingResult)."""
    if in_process:
        request = background.Request(mesh.Shape, option_values(mesh))
        return request, core.generate_mesh(*request.arguments, control)
    with background.BackgroundRun(mesh.Shape, option_values(mesh), control) as run:
        with presentation.progress() as show:
            while not run.wait(POLL_SECONDS):
                show(control)
            return run.request, run.result()
