# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh object: a Fem mesh of FreeCAD's that follows a graded solid and carries options and figures.

It is never meshed in execute(), so that a recompute stays quick: execute() only compares fingerprints and
says in `Status` whether the mesh is out of date.
"""
import json
import time

import Fem  # noqa: F401  registers the Fem types with the document
import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.model import fingerprint, presentation, stored
from freecad.fgmesh.model.graded_parts import graded_parts, no_material
from freecad.fgmesh.model.kept_meshes import KeptMeshes
from freecad.fgmesh.model.options import OPTIONS, add_missing_options, option_values
from freecad.fgmesh.model.stateless import Stateless
from freecad.fgmesh.model.transaction import transaction

NOT_MESHED = "not meshed yet"
_TYPE = "Fem::FemMeshObjectPython"
"""Of new meshes. FreeCAD 1.x has one with a `Shape` of its own, Fem::FemMeshShapeBaseObjectPython, which 0.20 loses on
opening; such a mesh of an earlier FGMesh lives on where FreeCAD has the type."""
_OPTION_NAMES = {"Groups", *(option.property for option in OPTIONS)}

# Prop_Output: a result does not touch the object that shows it. The rest follows from _lock_results().
_OUTPUT = 8
_RESULTS = (
    ("Status", "App::PropertyString", "ok, or what is wrong with the mesh, or why it is out of date"),
    ("PointCount", "App::PropertyInteger", "Points of the mesh"),
    ("FacetCount", "App::PropertyInteger", "Boundary and interface triangles"),
    ("TetCount", "App::PropertyInteger", "Tetrahedra"),
    ("VariationMin", "App::PropertyFloat", "Smallest variation of composition inside a tetrahedron"),
    ("VariationMax", "App::PropertyFloat", "Largest variation of composition inside a tetrahedron"),
    ("VariationMean", "App::PropertyFloat", "Mean variation of composition inside the tetrahedra"),
    ("DihedralMin", "App::PropertyFloat", "Smallest dihedral angle, degrees"),
    ("DihedralMax", "App::PropertyFloat", "Largest dihedral angle, degrees"),
    ("Report", "App::PropertyString", "Every figure of every stage, as JSON"),
    (
        "Fractions",
        "App::PropertyFloatList",
        "Volume fractions of all constituents but the last, at node 1, then at node 2, ...",
    ),
    ("Fingerprint", "App::PropertyString", "What the mesh was made from, for telling when it is out of date"),
)
_HIDDEN = {"Fractions", "Fingerprint"}


class MeshObject(Stateless):
    """The proxy."""

    def __init__(self, mesh):
        _add_missing_properties(mesh)
        mesh.Proxy = self
        presentation.show(mesh)

    def execute(self, mesh):
        update_status(mesh)

    def onChanged(self, mesh, name):
        if "Restore" in mesh.State:
            return
        if name in _OPTION_NAMES:
            update_status(mesh)
        elif name == "Fingerprint":  # set by store(), or by undo and redo
            self.kept.show(mesh)

    @property
    def kept(self):
        # A proxy that comes with a document is made without __init__.
        return self.__dict__.setdefault("_kept", KeptMeshes())

    def onDocumentRestored(self, mesh):
        _add_missing_properties(mesh)
        presentation.show(mesh)


def make_mesh(document, solid, name="FGMesh"):
    """A new mesh object of `solid`, still empty, with the default options. generate() fills it.

    It stands in the App::Part that holds the solid, if any, so that both are seen in the same place. Raises
    core.InvalidInput where the solid has no graded material. One undo step.
    """
    if getattr(solid, "Document", None) != document:
        raise core.InvalidInput("the mesh and its solid must be in the same document")
    if not graded_parts(solid):
        raise core.InvalidInput(no_material(solid))
    with transaction(document, "Make graded mesh"):
        mesh = document.addObject(_TYPE, name)
        mesh.addProperty("App::PropertyLinkGlobal", "Shape", "Meshing", "The graded solid")
        mesh.Shape = solid
        MeshObject(mesh)
        part = _part_of(solid)
        if part is not None:
            part.addObject(mesh)
        update_status(mesh)
    return mesh


def is_mesh(thing):
    """True for an object that make_mesh() made, even where its proxy was lost in a FreeCAD without FGMesh."""
    return "Fingerprint" in getattr(thing, "PropertiesList", ())


def revive(mesh):
    """Gives back the proxy to an object that was saved by a FreeCAD without FGMesh."""
    if not isinstance(mesh.Proxy, MeshObject):
        MeshObject(mesh)


def update_status(mesh):
    """Sets `Status` from the stored report and from what has changed since."""
    status = _status(mesh)
    if mesh.Status != status:
        mesh.Status = status


def store(mesh, fem_mesh, report, fractions, taken):
    """Puts a finished mesh and its figures into the object.

    fem_mesh   Fem.FemMesh
    report     dict, as core.report() gives it
    fractions  (n, k) of all constituents at each node
    taken      the fingerprint from before meshing
    """
    last = report["stages"][-1]
    made_from = json.dumps({**taken, "number": time.time_ns()})
    if mesh.Fingerprint not in mesh.Proxy.kept:
        mesh.Proxy.kept.keep(mesh.Fingerprint, mesh.FemMesh.copy())
    mesh.Proxy.kept.keep(made_from, fem_mesh)
    mesh.PointCount, mesh.FacetCount, mesh.TetCount = report["points"], last["facets"], last["tets"]
    variation, dihedral = last["variation"], last["dihedral"]
    mesh.VariationMin, mesh.VariationMax = variation["min"], variation["max"]
    mesh.VariationMean = variation["mean"]
    mesh.DihedralMin, mesh.DihedralMax = dihedral["min"], dihedral["max"]
    mesh.Report = json.dumps(report)
    mesh.Fractions = fractions[:, :-1].ravel().tolist()
    mesh.Fingerprint = made_from  # brings the Fem mesh with it
    update_status(mesh)


def fractions_of(mesh):
    """(n, k - 1): volume fractions of all constituents but the last at the nodes of the mesh. Raises core.InvalidInput
    where a document tells of other nodes."""
    fractions, nodes = np.array(mesh.Fractions, float), mesh.FemMesh.NodeCount
    if not nodes or not len(fractions) or len(fractions) % nodes:
        raise core.InvalidInput(f"{mesh.Label} does not tell the fractions at its nodes: mesh it again")
    return fractions.reshape(nodes, -1)


def report_of(mesh):
    """The report of `mesh`, a dict as core.report() gives it. Raises core.InvalidInput where the document tells none."""
    report = stored.document_in(mesh, "Report")
    try:
        stages = [(stage["name"], stage["variation"], stage["dihedral"]) for stage in report["stages"]]
        figures = [
            [figures[key] for key in ("min", "max", "histogram")] for _, *two in stages for figures in two
        ]
        counts = [figures[2]["counts"] for figures in figures]
        if (
            counts
            and report["deviation_max"] >= 0
            and isinstance(report["messages"], list)
            and report["status"]
        ):
            return report
    except (KeyError, TypeError):
        pass
    raise stored.damaged(mesh, "Report")


def _status(mesh):
    if not mesh.Fingerprint:
        return NOT_MESHED
    if mesh.FemMesh.VolumeCount != mesh.TetCount:
        return "out of date: the mesh cannot be brought back by undo; mesh again"
    try:
        return _compared(mesh)
    except core.Error as error:
        return f"out of date: {error}"


def _compared(mesh):
    before, now = stored.document_in(mesh, "Fingerprint"), fingerprint.take(mesh.Shape, option_values(mesh))
    try:
        changed = fingerprint.changes(before, now)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError):
        raise stored.damaged(mesh, "Fingerprint") from None
    if changed:
        return "out of date: " + "; ".join(changed)
    report = report_of(mesh)
    if report["status"] == "threshold_not_met":
        broken = report.get("certified", {}).get("broken", 0)  # those above at their corners are among them
        above = max(broken, report["stages"][-1]["variation"]["above_threshold"])
        return f"threshold_not_met: {above} of {mesh.TetCount} tetrahedra, up to {mesh.VariationMax:.3g}"
    if report["status"] == "deviation_not_met":
        return f"deviation_not_met: the boundary is up to {report['deviation_max']:.3g} mm off its faces"
    return report["status"]


def _add_missing_properties(mesh):
    # Results first: changing an option looks at Status.
    for name, kind, tip in _RESULTS:
        stored.restore_property(mesh, kind, name, "Results", tip, _OUTPUT)
        mesh.setEditorMode(name, ["ReadOnly", "Hidden"] if name in _HIDDEN else ["ReadOnly"])
    add_missing_options(mesh)


def _part_of(solid):
    """The App::Part around `solid` or around its body, or None."""
    container = solid.getParentGeoFeatureGroup()
    while container is not None and not container.isDerivedFrom("App::Part"):
        container = container.getParentGeoFeatureGroup()
    return container
