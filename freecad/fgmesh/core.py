# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh without FreeCAD: a B-Rep and a graded material in, a tetrahedral mesh out.

All in the caller's process, where a crash of OpenCASCADE or CGAL on a bad shape ends the caller, too;
`freecad.fgmesh.worker` offers the same in a child process.

    from freecad.fgmesh import core
    material = core.Material(["exp(-alpha*d)"], parameters={"alpha": 0.08})
    result = core.generate_mesh("part.step", material, core.MeshingOptions(material_threshold=0.1))
    result.points, result.tets, core.report(result)

Lengths are mm, angles degrees, fractions dimensionless in [0, 1]. `Material`, `MeshingOptions`, `RunControl`
and the exceptions are those of the C++ side; `help()` of each tells its fields. `read_table` reads what t1 t2 ... of
formulas are the values of; `table_text` gives one as text, `table_texts` all of a material. `versions()` tells what this
was built with.

Errors: every error raised on purpose is an `Error`: `InvalidInput` (an option, a file or a material that has
no meaning; also a ValueError), `FormulaError` (an InvalidInput; `formula` is the index of the formula, `position` the offset in it, in
bytes of UTF-8; `caret_excerpt` shows the place), `GeometryError` (the shape cannot be meshed), `Cancelled`
(stopped by `RunControl` or by its limits).
"""
import math
import os

try:
    from freecad.fgmesh import _core
except ImportError as error:
    raise ImportError(
        f"FGMesh's compiled part freecad.fgmesh._core cannot be loaded ({error}). "
        "Build it with ./scripts/build and use the folder build/Mod/FGMesh, with /usr/bin/python3."
    ) from error

from freecad.fgmesh._core import (
    Cancelled,
    Error,
    FormulaError,
    GeometryError,
    InvalidInput,
    MeshingOptions,
    Reference,
    RunControl,
    SampledTable,
    caret_excerpt,
    reach_points,
    shown_triangles,
    versions,
)
from freecad.fgmesh import input_file
from freecad.fgmesh.sampled_table import read as read_table
from freecad.fgmesh.sampled_table import read_all as _read_tables
from freecad.fgmesh.sampled_table import text as table_text
from freecad.fgmesh.sampled_table import texts as table_texts

__all__ = [
    "Cancelled",
    "Error",
    "FormulaError",
    "GeometryError",
    "InvalidInput",
    "Material",
    "MeshingOptions",
    "MeshingResult",
    "Reference",
    "RunControl",
    "SampledTable",
    "caret_excerpt",
    "distances",
    "estimate",
    "frame_rotation",
    "generate_mesh",
    "reach_points",
    "read_references",
    "read_shape",
    "read_table",
    "references",
    "report",
    "shown_triangles",
    "table_text",
    "table_texts",
    "versions",
]


class _ChecksArguments(type(_core.Material)):
    """Refuses what is no text, and turns texts and paths among `tables` into what the compiled class takes. Not its __init__ does: while that fails,
    whoever looks at the object (a traceback with values does) reads memory that nobody has written."""

    def __call__(cls, fractions, parameters=None, *arguments, tables=(), **named):
        parameters = {} if parameters is None else parameters
        for formula in fractions:
            _check_text(formula, "the formula")
        for name in parameters:
            _check_text(name, "the name of the parameter")
        return super().__call__(fractions, parameters, *arguments, tables=_read_tables(tables), **named)


class Material(_core.Material, metaclass=_ChecksArguments):
    __doc__ = _core.Material.__doc__


class MeshingResult:
    """What `generate_mesh` gives. The arrays are read-only; their memory lives as long as any of them.

    points (n, 3) float64, mm; carriers (n, 2) int32: dimension (0 vertex ... 3 solid) and 1-based number of
    the B-Rep entity that carries each point, one point for each vertex; fractions (n, k): of all constituents, k those
    of the material that has most, and zeros behind where one has fewer; on an interface of solids with different
    materials those in the solid with the lower number.
    tets (m, 4) int32, positively oriented (VTK order), or (m, 10) where options.order is 2: points and rows
    then begin as they would without, with the nodes in the middle of edges behind the corners; tet_solids (m,): N of SolidN; variation (m,);
    dihedral_min (m,), degrees; both of the corners; above_threshold: indices of the tetrahedra above the
    material threshold; tet_fractions (m, 4 or 10, k): those at the nodes of each tetrahedron, in the
    material of its own solid. forced_angles, small_angles: indices of the tetrahedra with a dihedral angle below
    angle_goal (degrees), of those where the shape forces it (at an edge whose faces, or a vertex where two edges
    of a face meet below angle_goal, or across a wall thinner than min_size) and of all others. broken, unproved:
    indices of the tetrahedra that are known to break the threshold, at their corners or between them, and of those
    for which it is not proved over all of their inside; certificate: the figures of the proof, see report().
    triangles (t, 3 or 6) int32, the boundary, outward, and each interface once, outward from the solid with the
    lower number; triangle_faces (t,): N of FaceN. Where faces of the shape coincide that is the lowest;
    coincident_faces (c, 2): index of such a triangle, N of another FaceN that it lies on.
    edges (e, 2 or 3) int32, mesh edges along B-Rep edges; edge_edges (e,): N of EdgeN. N of an edge or vertex,
    here and in carriers, is the lowest where some coincide, and 0 where solids had to be separated along it.
    straightened: indices of middle nodes that are not on the true boundary, since a tetrahedron would be
    turned over there.
    stages: list of StageReport; messages: list of str, for a reader.
    status: "ok"; "threshold_not_met" (some tetrahedra stay above, at their corners or in between); else
    "deviation_not_met" (the boundary is farther from the true one than surface_deviation).
    element_ratio, deviation_max (mm), surface_deviation (mm), volume and shape_volume (mm^3), threads,
    peak_memory_mb: numbers. solid_volumes, shape_solid_volumes: of SolidN at N - 1, mm^3; what several solids
    hold counts for the one that it is given to. material_threshold: the threshold that was asked for.
    """

    def __init__(self, result, material_threshold):
        self._result = result
        self.material_threshold = material_threshold

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._result, name)

    def __dir__(self):
        return sorted({*super().__dir__(), *(name for name in dir(self._result) if not name.startswith("_"))})

    @property
    def tet_fractions(self):
        stored = self._result.tet_fractions  # empty where the points tell all
        return stored if len(stored) else self.fractions[self.tets]

    def report(self):
        """As `core.report`."""
        return report(self)


def generate_mesh(brep, material, options=None, control=None):
    """Mesh the solids of a B-Rep: initial mesh, material-oriented refinement, geometry-oriented refinement;
    then nodes in the middle of edges where options.order is 2.

    brep: what `read_shape` takes. material: one Material for all solids, or a list with that of SolidN at N - 1.
    options: MeshingOptions, its defaults where None. control: RunControl, to be watched or cancelled from
    another thread; the GIL is released meanwhile.

    Solids share their interfaces in the mesh. Those that touch without sharing faces, overlap or are nested are
    separated first, and messages tell what was done: a region in several solids belongs to the lowest, but a
    solid that would be left with nothing (a ball inside a box) takes its own. Gives a MeshingResult. Raises InvalidInput, GeometryError or Cancelled.
    """
    options = MeshingOptions() if options is None else options
    control = RunControl() if control is None else control
    threshold = options.material_threshold
    shape = read_shape(brep, control)
    materials = _with_references(list_of(material), control)
    return MeshingResult(_core.generate_mesh(shape, materials, options, control), threshold)


def estimate(brep, material, options=None, control=None):
    """What `generate_mesh` would give for the same arguments, in about a second: an object with

    tets: the expected number of tetrahedra; mostly within 30 % of the true one.
    memory_mb: the largest memory (MB) that a process is to need which does nothing but this, as that of `worker`.

    The shape is read and its initial mesh is made, which is most of the time that it takes. Raises what
    `generate_mesh` raises of shape, material and options.
    """
    options = MeshingOptions() if options is None else options
    control = RunControl() if control is None else control
    shape = read_shape(brep, control)
    return _core.estimate(shape, _with_references(list_of(material), control), options, control)


def list_of(material):
    """The materials that `generate_mesh` was given, as a list."""
    return [material] if isinstance(material, Material) else list(material)


def references(brep, names, control=None, read=True):
    """What a material's d1 s1 d2 ... measure to: a list of Reference, for `Material(..., references=...)`.

    brep: what `read_shape` takes. names: parts of its solids, as FreeCAD numbers them ("Face3", "Edge1",
    "Vertex2", "Solid1"). control: RunControl, as for `generate_mesh`. Without `read` nobody looks at the
    shape yet: a Material with such references has a checked formula, but no value before `read_references`;
    `worker` does that in its child process. Raises InvalidInput that names a part which the shape does not have,
    GeometryError or Cancelled.
    """
    shape, names = read_shape(brep, control), list(names)
    for name in names:
        _check_text(name, "the reference")
    return _core.references(shape, names, control) if read else _core.unread_references(shape, names)


def read_references(material, control=None):
    """`material` itself where its references have been read, else the same with those that have.

    Raises InvalidInput that names a part which its shape does not have, GeometryError or Cancelled.
    """
    return _with_references([material], control)[0]


def distances(references, points, control=None):
    """Distances (n, r) in mm from points (n, 3) to r references, those to solids with a sign, below zero inside.

    They are what `Material.evaluate(points, distances)` takes: whoever has them can evaluate a material whose
    references nobody has read. References that have not been read are read here first. control: RunControl,
    as for `generate_mesh`. Raises InvalidInput, GeometryError or Cancelled.
    """
    return _core.distances(_all_read(list(references), control), points, control)


def _with_references(materials, control):
    """Of each of `materials` what `read_references` gives; each shape is read once. The same for the same."""
    once = {id(material): material for material in materials}
    given = [one for material in once.values() for one in material.references]
    read = iter(_all_read(given, control))
    for key, material in once.items():
        found = [next(read) for _ in material.references]
        if not all(one.is_read for one in material.references):
            once[key] = Material(
                material.fractions,
                material.parameters,
                material.origin,
                material.rotation,
                found,
                tables=material.tables,
            )
    return [once[id(material)] for material in materials]


def _all_read(given, control):
    """References that have been read in the place of those that have not; each shape is read once."""
    unread = {}  # a dictionary is a set in order
    for reference in (one for one in given if not one.is_read):
        unread.setdefault(reference.shape, {})[reference.name] = None
    made = {}
    for shape, names in unread.items():
        try:
            made.update(((shape, one.name), one) for one in references(shape, names, control))
        except GeometryError as error:
            raise GeometryError(f"the shape of the reference {next(iter(names))}: {error}") from None
    return [one if one.is_read else made[one.shape, one.name] for one in given]


LARGEST_SHAPE = 1 << 30
"""Bytes of a shape file: far more than what OpenCASCADE reads in an hour."""


def read_shape(brep, control=None):
    """The content (bytes) of a BREP or STEP file.

    brep: bytes are the content itself; a str of several lines likewise; any other str, or a path-like object,
    is the path of the file or of a pipe. control: RunControl, as for `generate_mesh`. Raises InvalidInput where the file
    cannot be read, or has more than LARGEST_SHAPE bytes; Cancelled.
    """
    if isinstance(brep, (bytes, bytearray, memoryview)):
        return bytes(brep)
    if isinstance(brep, str) and "\n" in brep:
        return brep.encode("utf-8", "surrogateescape")
    if not isinstance(brep, (str, os.PathLike)):
        raise InvalidInput(
            f"a shape is bytes, text or the path of a STEP or BREP file, not {type(brep).__name__}"
        )
    try:
        return input_file.read(brep, LARGEST_SHAPE, control)
    except InvalidInput as error:
        raise InvalidInput(f"cannot read the shape file {os.fspath(brep)!r}: {error}") from None


def _check_text(text, name):
    """Raise InvalidInput where `text` holds what is no character, which the compiled part does not take."""
    try:
        if isinstance(text, str):
            text.encode()
    except UnicodeEncodeError as error:
        raise InvalidInput(
            f"{name} {text[:60]!r} holds bytes that are no UTF-8 text, at character {error.start + 1}"
        ) from None


def frame_rotation(axis):
    """The rotation (3x3 nested list, columns x, y, z) of the frame whose z axis points along `axis`.

    Its x axis is the part of the world's X across `axis`; of the world's Y where `axis` lies within 26
    degrees of X. The axis (0, 0, 1) gives the identity. Raises InvalidInput for an axis without direction.
    """
    length = math.hypot(*axis)
    if len(axis) != 3 or not math.isfinite(length) or length == 0:
        raise InvalidInput(
            f"the axis {tuple(axis)} has no direction: give three finite numbers, not all zero"
        )
    z = [component / length for component in axis]
    start = (0.0, 1.0, 0.0) if abs(z[0]) > 0.9 else (1.0, 0.0, 0.0)
    along = sum(s * c for s, c in zip(start, z))
    x = [s - along * c for s, c in zip(start, z)]
    norm = math.hypot(*x)
    x = [component / norm for component in x]
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    return [list(row) for row in zip(x, y, z)]


def report(result):
    """The figures of a MeshingResult as plain values, ready for json.dump.

    One entry a stage under "stages" (counts of corners, facets and tetrahedra; variation and dihedral angles
    with histograms; seconds), the order of the tetrahedra, the number of all points ("points") and of those
    in the middle of a boundary edge that are not on the true boundary ("straightened"). How many tetrahedra have
    a dihedral angle below "angle_goal", since the shape forces it ("forced_angles") and without
    ("small_angles"). Then the element ratio eta = N threshold^3 / integral |grad f|^3 dV, the largest deviation
    from the B-Rep (mm), volumes (mm^3), in all and of each solid under "solids", and the messages of the run.
    "certified" tells what is proved of the threshold over the whole of each tetrahedron, where the stages look at
    its corners: whether it "holds", among how many "tets", how many are "broken" (two points in one differ by more)
    and "unproved", the largest "bound" of the variation that was proved, and the "seconds" that this took. It is empty
    where the option certify is off, or the initial mesh was asked for.
    """
    return {
        "status": result.status,
        "threshold": result.material_threshold,
        "stages": [_stage(stage) for stage in result.stages],
        "order": 2 if result.tets.shape[1] == 10 else 1,
        "points": len(result.points),
        "straightened": len(result.straightened),
        "angle_goal": result.angle_goal,
        "forced_angles": len(result.forced_angles),
        "small_angles": len(result.small_angles),
        "element_ratio": result.element_ratio,
        "certified": _certified(result.certificate),
        "deviation_max": result.deviation_max,
        "surface_deviation": result.surface_deviation,
        "volume": result.volume,
        "shape_volume": result.shape_volume,
        "solids": [
            {"name": f"Solid{number}", "volume": volume, "shape_volume": exact}
            for number, (volume, exact) in enumerate(
                zip(result.solid_volumes.tolist(), result.shape_solid_volumes.tolist()), 1
            )
        ],
        "threads": result.threads,
        "peak_memory_mb": result.peak_memory_mb,
        "messages": list(result.messages),
    }


def _certified(certificate):
    names = ("holds", "tets", "broken", "unproved", "bound", "seconds")
    return {name: getattr(certificate, name) for name in names} if certificate.made else {}


def _stage(stage):
    return {
        "name": stage.name,
        "points": stage.points,
        "facets": stage.facets,
        "tets": stage.tets,
        "variation": {
            "min": stage.variation_min,
            "max": stage.variation_max,
            "mean": stage.variation_mean,
            "above_threshold": stage.above_threshold,
            "histogram": _histogram(stage.variation_histogram),
        },
        "dihedral": {
            "min": stage.dihedral_min,
            "max": stage.dihedral_max,
            "histogram": _histogram(stage.dihedral_histogram),
        },
        "seconds": stage.seconds,
    }


def _histogram(histogram):
    return {
        "low": histogram.low,
        "high": histogram.high,
        "counts": [int(count) for count in histogram.counts],
    }
