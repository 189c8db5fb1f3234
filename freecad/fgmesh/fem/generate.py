# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshing from a document and back into it."""
from freecad.fgmesh import core, worker
from freecad.fgmesh.fem.fem_mesh import to_fem_mesh
from freecad.fgmesh.model import fingerprint, graded_parts, mesh_object, presentation
from freecad.fgmesh.model.options import options_of
from freecad.fgmesh.model.references import stored_links
from freecad.fgmesh.model.shapes import brep_text
from freecad.fgmesh.model.transaction import transaction

POLL_SECONDS = 0.1


def generate(mesh, control=None, in_process=False):
    """Meshes the solid of `mesh`, an object that make_mesh() made, and stores mesh and figures in it.

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
            f"{getattr(mesh, 'Label', mesh)} is no mesh of FGMesh: make one with make_mesh()"
        )
    mesh_object.revive(mesh)
    solid = _ready_solid(mesh)
    taken = fingerprint.take(mesh)
    control = control or core.RunControl()
    asked = brep_text(solid.Shape), graded_parts.materials_of(solid), options_of(mesh), control
    result = core.generate_mesh(*asked) if in_process else _in_child(*asked)
    report, fem_mesh = core.report(result), to_fem_mesh(result)
    with transaction(mesh.Document, "Generate graded mesh"):
        mesh_object.store(mesh, fem_mesh, report, result.fraction.tolist(), taken)
    return result


def _in_child(brep, material, options, control):
    with worker.start(brep, material, options, control) as run, presentation.progress() as show:
        while not run.wait(POLL_SECONDS):
            show(control)
        return run.result()


def _ready_solid(mesh):
    solid = mesh.Shape
    if solid is None:
        raise core.InvalidInput(f"{mesh.Label} has lost its solid: set its Shape to a graded solid")
    # The links of references are no dependencies, so that a solid can refer to its own faces.
    links = [link for part, _ in graded_parts.graded_parts(solid) for link in stored_links(part)]
    for thing in dict.fromkeys([*(thing for thing, name in links), solid]):
        if any("Touched" in needed.State for needed in [thing, *thing.OutListRecursive]):
            thing.recompute(True)
    if not solid.isValid():
        raise core.GeometryError(f"{solid.Label} cannot be computed: repair it in FreeCAD first")
    if solid.Shape.isNull() or not solid.Shape.Solids:
        raise core.GeometryError(f"{solid.Label} has no solid to mesh: make a solid of it first")
    return solid
