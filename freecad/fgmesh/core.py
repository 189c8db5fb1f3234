# SPDX-License-Identifier: GPL-3.0-or-later
"""FGMesh without FreeCAD: a B-Rep and a graded material in, a tetrahedral mesh out.

All in the caller's process, where a crash of OpenCASCADE or CGAL on a bad shape ends the caller, too;
`freecad.fgmesh.worker` offers the same in a child process.

    from freecad.fgmesh import core
    material = core.Material(["exp(-alpha*d)"], parameters={"alpha": 0.08})
    result = core.generate_mesh("part.step", material, core.MeshingOptions(material_threshold=0.1))
    result.points, result.tets, core.report(result)

Lengths are mm, angles degrees, fractions dimensionless in [0, 1]. `Material`, `MeshingOptions`, `RunControl`
and the exceptions are those of the C++ side; `help()` of each tells its fields. `versions()` tells what this
was built with.

Errors: every error raised on purpose is an `Error`: `InvalidInput` (an option, a file or a material that has
no meaning; also a ValueError), `FormulaError` (an InvalidInput; `position` is the offset in the formula, in
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
    Material,
    MeshingOptions,
    Reference,
    RunControl,
    caret_excerpt,
    versions,
)

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
    "caret_excerpt",
    "frame_rotation",
    "generate_mesh",
    "read_shape",
    "references",
    "report",
    "versions",
]


class MeshingResult:
    """What `generate_mesh` gives. The arrays are read-only; their memory lives as long as any of them.

    points (n, 3) float64, mm; carriers (n, 2) int32: dimension (0 vertex ... 3 solid) and 1-based number of
    the B-Rep entity that carries each point; fraction (n,): of the first constituent.
    tets (m, 4) int32, positively oriented (VTK order), or (m, 10) where options.order is 2: points and rows
    then begin as they would without, with the nodes in the middle of edges behind the corners; tet_solids (m,): N of SolidN; variation (m,);
    dihedral_min (m,), degrees; both of the corners; above_threshold: indices of the tetrahedra above the
    material threshold.
    triangles (t, 3 or 6) int32, boundary and interfaces, outward; triangle_faces (t,): N of FaceN.
    edges (e, 2 or 3) int32, mesh edges along B-Rep edges; edge_edges (e,): N of EdgeN.
    straightened: indices of middle nodes that are not on the true boundary, since a tetrahedron would be
    turned over there.
    stages: list of StageReport; messages: list of str, for a reader.
    status: "ok"; "threshold_not_met" (some tetrahedra stay above); else "deviation_not_met" (the boundary is
    farther from the true one than surface_deviation).
    element_ratio, deviation_max (mm), surface_deviation (mm), volume and shape_volume (mm^3), threads,
    peak_memory_mb: numbers. material_threshold: the threshold that was asked for.
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

    def report(self):
        """As `core.report`."""
        return report(self)


def generate_mesh(brep, material, options=None, control=None):
    """Mesh the solids of a B-Rep: initial mesh, material-oriented refinement, geometry-oriented refinement;
    then nodes in the middle of edges where options.order is 2.

    brep: what `read_shape` takes. material: Material. options: MeshingOptions, its defaults where None.
    control: RunControl, to be watched or cancelled from another thread; the GIL is released meanwhile.
    Gives a MeshingResult. Raises InvalidInput, GeometryError or Cancelled.
    """
    options = MeshingOptions() if options is None else options
    control = RunControl() if control is None else control
    threshold = options.material_threshold
    result = _core.generate_mesh(read_shape(brep), material, options, control)
    return MeshingResult(result, threshold)


def references(brep, names, control=None):
    """What a material's d1 s1 d2 ... measure to: a list of Reference, for `Material(..., references=...)`.

    brep: what `read_shape` takes. names: parts of its solids, as FreeCAD numbers them ("Face3", "Edge1",
    "Vertex2", "Solid1"). control: RunControl, as for `generate_mesh`. Raises InvalidInput that names a part
    which the shape does not have, GeometryError or Cancelled.
    """
    return _core.references(read_shape(brep), list(names), control)


def read_shape(brep):
    """The content (bytes) of a BREP or STEP file.

    brep: bytes are the content itself; a str of several lines likewise; any other str, or a path-like object,
    is the path of the file. Raises InvalidInput where the file cannot be read.
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
        with open(brep, "rb") as file:
            return file.read()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InvalidInput(f"cannot read the shape file {os.fspath(brep)!r}: {reason}") from None


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
    in the middle of a boundary edge that are not on the true boundary ("straightened"). Then the element ratio eta = N threshold^3 / integral |grad f|^3 dV, the largest deviation from the B-Rep (mm),
    volumes (mm^3) and the messages of the run. "certified" is empty: bounds between vertices are not proven
    yet.
    """
    return {
        "status": result.status,
        "threshold": result.material_threshold,
        "stages": [_stage(stage) for stage in result.stages],
        "order": 2 if result.tets.shape[1] == 10 else 1,
        "points": len(result.points),
        "straightened": len(result.straightened),
        "element_ratio": result.element_ratio,
        "certified": {},
        "deviation_max": result.deviation_max,
        "surface_deviation": result.surface_deviation,
        "volume": result.volume,
        "shape_volume": result.shape_volume,
        "threads": result.threads,
        "peak_memory_mb": result.peak_memory_mb,
        "messages": list(result.messages),
    }


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
