# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a mesh as properties of its object, with the defaults of core.MeshingOptions."""
from typing import Any, NamedTuple

from freecad.fgmesh import core
from freecad.fgmesh.model import stored
from freecad.fgmesh.model.texts import TRANSLATE_LATER

GROUP = "Meshing"
STAGES = ["initial", "material", "geometry"]
GROUP_KINDS = ["Solid", "Face", "Edge", "Vertex"]
"""Parts of a shape that get groups in the Fem mesh."""


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
        TRANSLATE_LATER(
            "FGMesh",
            "Largest difference of composition allowed inside one tetrahedron, above 0 and at most 1",
        ),
    ),
    Option(
        "SurfaceDeviation",
        "surface_deviation",
        "App::PropertyLength",
        TRANSLATE_LATER(
            "FGMesh",
            "Largest distance of the mesh's boundary to the true one; 0: the part's diagonal / 2000, "
            "or less where the volume would be more than 0.5 % off",
        ),
    ),
    Option(
        "MinSize",
        "min_size",
        "App::PropertyLength",
        TRANSLATE_LATER(
            "FGMesh", "No refinement makes edges shorter than this; 0: the part's diagonal / 2000"
        ),
    ),
    Option(
        "MaxSize",
        "max_size",
        "App::PropertyLength",
        TRANSLATE_LATER("FGMesh", "No edge is longer than this; 0: about the part's diagonal / 8"),
    ),
    Option(
        "Anisotropy",
        "anisotropy",
        "App::PropertyFloat",
        TRANSLATE_LATER(
            "FGMesh",
            "How many times longer elements may be across the gradient than along it; 1: isotropic",
        ),
    ),
    Option(
        "SecondOrder",
        "order",
        "App::PropertyBool",
        TRANSLATE_LATER(
            "FGMesh", "Ten-node tetrahedra in place of four-node ones, with nodes on the true faces and edges"
        ),
    ),
    Option(
        "Certify",
        "certify",
        "App::PropertyBool",
        TRANSLATE_LATER(
            "FGMesh",
            "Prove the threshold over the whole of each tetrahedron, not at its corners alone, and split those that "
            "break it in between",
        ),
    ),
    Option(
        "Paper",
        "paper",
        "App::PropertyBool",
        TRANSLATE_LATER(
            "FGMesh",
            "Keep to the paper's own loop, which takes more elements and leaves flat ones; for comparisons",
        ),
    ),
    Option(
        "StopAfter",
        "stop_after",
        "App::PropertyEnumeration",
        TRANSLATE_LATER("FGMesh", "The last of the three stages to run"),
    ),
    Option(
        "Threads",
        "threads",
        "App::PropertyInteger",
        TRANSLATE_LATER("FGMesh", "Processors to use at most, 0 for all; the mesh does not depend on it"),
        shapes_mesh=False,
    ),
    Option(
        "Seed",
        "seed",
        "App::PropertyInteger",
        TRANSLATE_LATER("FGMesh", "Start of the random numbers; the same seed, the same mesh"),
    ),
)

_SHAPING_NOTHING = {option.property for option in OPTIONS if not option.shapes_mesh}


def add_missing_options(mesh):
    """Gives `mesh` the option properties that it has not, with their defaults: all of them to a new object,
    those of a later version to one from an old document."""
    defaults = default_values()
    tip = f"Parts of the shape that get groups in the mesh: {', '.join(GROUP_KINDS)}"
    if stored.restore_property(mesh, "App::PropertyStringList", "Groups", GROUP, tip):
        mesh.Groups = defaults["Groups"]
    for option in OPTIONS:
        if not stored.restore_property(mesh, option.type, option.property, GROUP, option.tip):
            continue
        if option.property == "StopAfter":
            mesh.StopAfter = STAGES
        setattr(mesh, option.property, defaults[option.property])


def option_values(mesh):
    """{property: plain value} of all options of `mesh`, for comparing and storing."""
    return {"Groups": list(mesh.Groups), **{o.property: _plain(getattr(mesh, o.property)) for o in OPTIONS}}


def default_values():
    """As option_values() of a new mesh object."""
    defaults = core.MeshingOptions()
    return {
        "Groups": GROUP_KINDS,
        **{o.property: _to_property(o, getattr(defaults, o.field)) for o in OPTIONS},
    }


def shaping_values(values):
    """Those of option_values() that another mesh comes from."""
    return {name: value for name, value in values.items() if name not in _SHAPING_NOTHING}


def meshing_options(values):
    """The core.MeshingOptions of option_values(). Raises core.InvalidInput where one is out of range."""
    unknown = set(values["Groups"]) - set(GROUP_KINDS)
    if unknown:
        raise core.InvalidInput(
            f"Groups: {min(unknown)!r} is no kind of part; there are {', '.join(GROUP_KINDS)}"
        )
    options = core.MeshingOptions()
    for option in OPTIONS:
        value = values[option.property]
        try:
            setattr(options, option.field, _to_field(option, value))
        except TypeError:
            raise core.InvalidInput(f"{option.property} cannot be {value!r}: give it another value") from None
    options.validate()
    return options


def options_of(mesh):
    """The core.MeshingOptions that `mesh` asks for. Raises core.InvalidInput where one is out of range."""
    return meshing_options(option_values(mesh))


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
