# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a mesh as properties of its object, with the defaults of core.MeshingOptions."""
from typing import Any, NamedTuple

from freecad.fgmesh import core

GROUP = "Meshing"
STAGES = ["initial", "material", "geometry"]


class Option(NamedTuple):
    property: str
    field: str  # of core.MeshingOptions
    type: str
    tip: str
    shapes_mesh: bool = True  # False: another value gives no other mesh worth the name


OPTIONS = (
    Option(
        "MaterialThreshold",
        "material_threshold",
        "App::PropertyFloat",
        "Largest difference of composition allowed inside one tetrahedron, above 0 and at most 1",
    ),
    Option(
        "SurfaceDeviation",
        "surface_deviation",
        "App::PropertyLength",
        "Largest distance of the mesh's boundary to the true one; 0: the part's diagonal / 2000, "
        "or less where the volume would be more than 0.5 % off",
    ),
    Option(
        "MinSize",
        "min_size",
        "App::PropertyLength",
        "No refinement makes edges shorter than this; 0: the part's diagonal / 2000",
    ),
    Option(
        "MaxSize",
        "max_size",
        "App::PropertyLength",
        "Edges much longer than this are split; 0: the part's diagonal / 8",
    ),
    Option(
        "Anisotropy",
        "anisotropy",
        "App::PropertyFloat",
        "Largest stretch of an element across the gradient; 1: isotropic (more is not available yet)",
    ),
    Option(
        "SecondOrder",
        "order",
        "App::PropertyBool",
        "Ten-node tetrahedra in place of four-node ones, with nodes on the true faces and edges",
    ),
    Option("StopAfter", "stop_after", "App::PropertyEnumeration", "The last of the three stages to run"),
    Option(
        "Threads",
        "threads",
        "App::PropertyInteger",
        "Processors to use; without effect yet, one is used",
        shapes_mesh=False,
    ),
    Option(
        "Seed", "seed", "App::PropertyInteger", "Start of the random numbers; the same seed, the same mesh"
    ),
)


def add_missing_options(mesh):
    """Gives `mesh` the option properties that it has not, with their defaults: all of them to a new object,
    those of a later version to one from an old document."""
    defaults = core.MeshingOptions()
    for option in OPTIONS:
        if option.property in mesh.PropertiesList:
            continue
        mesh.addProperty(option.type, option.property, GROUP, option.tip)
        if option.property == "StopAfter":
            mesh.StopAfter = STAGES
        setattr(mesh, option.property, _to_property(option, getattr(defaults, option.field)))


def option_values(mesh):
    """{property: plain value} of the options that shape the mesh, for comparing and storing."""
    return {o.property: _plain(getattr(mesh, o.property)) for o in OPTIONS if o.shapes_mesh}


def options_of(mesh):
    """The core.MeshingOptions that `mesh` asks for. Raises core.InvalidInput where one is out of range."""
    values = {o.field: _to_field(o, _plain(getattr(mesh, o.property))) for o in OPTIONS}
    return core.MeshingOptions(**values)


def _plain(value: Any):
    return getattr(value, "Value", value)


def _to_property(option, value):
    return value == 2 if option.property == "SecondOrder" else value


def _to_field(option, value):
    if option.property == "SecondOrder":
        return 2 if value else 1
    if option.property == "Seed":
        return value % 2**32  # any whole number is a seed
    return value
