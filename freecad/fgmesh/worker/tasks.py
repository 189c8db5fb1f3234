# SPDX-License-Identifier: GPL-3.0-or-later
"""What the child can be asked for. A task is a class: the parent makes an object of it with the arguments of the
function in `core` that the child is to call, and asks it for a request and for the result; the child calls
`answer`, and needs no object.

    request(shapes, arrays)                   plain values for JSON; adds shapes to the list, arrays to the file
    answer(asked, shapes, arrays, control)    what `transfer.pack` takes, by the function in `core`
    result(answer)                            what that function gives

`process` is what messages call the child.
"""
import json

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.surfaces.sample_points import sample_points
from freecad.fgmesh.surfaces.surface import Surface, shown_surface
from freecad.fgmesh.worker.transfer import pack, unpack


class Meshing:
    """`core.generate_mesh`."""

    process = "meshing process"

    def __init__(self, brep, material, options=None, control=None):
        self._options = core.MeshingOptions() if options is None else options
        self._threshold = self._options.material_threshold
        self._shape = core.read_shape(brep, control)
        self._materials = core.list_of(material)

    def request(self, shapes, arrays):
        tables = []
        materials = [_plain_material(material, shapes, tables) for material in self._materials]
        return {
            "shape": _place(self._shape, shapes),
            "materials": materials,
            "tables": [_plain_table(table, arrays) for table in tables],
            "options": self._options.as_dict(),
        }

    @staticmethod
    def arguments(asked, shapes, arrays):
        """Shape, materials and options again."""
        tables = [_table(plain, arrays) for plain in asked["tables"]]
        materials = list(_materials(asked["materials"], shapes, tables))
        return shapes[asked["shape"]], materials, core.MeshingOptions(**asked["options"])

    @classmethod
    def answer(cls, asked, shapes, arrays, control):
        result = core.generate_mesh(*cls.arguments(asked, shapes, arrays), control)
        return result._result  # what is computed from it need not travel

    def result(self, answer):
        return core.MeshingResult(answer, self._threshold)


class Estimating(Meshing):
    """`core.estimate`."""

    process = "estimating process"

    @classmethod
    def answer(cls, asked, shapes, arrays, control):
        return core.estimate(*cls.arguments(asked, shapes, arrays), control)

    def result(self, answer):
        return answer


class Measuring:
    """`core.distances`."""

    process = "measuring process"

    def __init__(self, references, points):
        self._references = list(references)
        self._points = np.asarray(points, float)

    def request(self, shapes, arrays):
        return {
            "references": [_plain_reference(one, shapes) for one in self._references],
            "points": pack(self._points, arrays),
        }

    @staticmethod
    def answer(asked, shapes, arrays, control):
        references = [_reference(one, shapes) for one in asked["references"]]
        return core.distances(references, unpack(asked["points"], arrays), control)

    def result(self, answer):
        return answer


class Showing:
    """A `surfaces.surface.Surface` and `surfaces.sample_points` of it."""

    process = "triangulating process"

    def __init__(self, brep, diagonal):
        self._shape, self._diagonal = brep, diagonal

    def request(self, shapes, arrays):
        return {"shape": _place(self._shape, shapes), "diagonal": self._diagonal}

    @staticmethod
    def answer(asked, shapes, arrays, control):
        surface = shown_surface(shapes[asked["shape"]], asked["diagonal"], control=control)
        return [surface, *sample_points(surface)]

    def result(self, answer):
        found, points, solids = answer
        surface = Surface(found.points, found.normals, found.solids, found.triangles, found.diagonal)
        surface.edges, surface.welded = found.edges, found.welded  # computed already
        return surface, (points, solids)


TASKS = {task.__name__: task for task in (Meshing, Estimating, Measuring, Showing)}


def _place(thing, things):
    """The place of a shape or a table in the list, to which it is added where it is new."""
    if thing not in things:
        things.append(thing)
    return things.index(thing)


def _plain_reference(reference, shapes):
    return _place(reference.shape, shapes), reference.name


def _reference(plain, shapes):
    place, name = plain
    return core.references(shapes[place], [name], read=False)[0]


def _plain_table(table, arrays):
    return [[name, pack(places, arrays)] for name, places in table.places.items()], pack(table.values, arrays)


def _table(plain, arrays):
    places, values = plain
    return core.SampledTable(
        {name: unpack(packed, arrays) for name, packed in places}, unpack(values, arrays)
    )


def _plain_material(material, shapes, tables):
    """The arguments of core.Material, as JSON can hold them."""
    return {
        "fractions": material.fractions,
        "parameters": material.parameters,
        "origin": list(material.origin),
        "rotation": material.rotation.tolist(),
        "references": [_plain_reference(one, shapes) for one in material.references],
        "tables": [_place(table, tables) for table in material.tables],
    }


def _materials(asked, shapes, tables):
    """The materials, whose references the functions of `core` read."""
    made = {}  # the same object for solids with the same material, which is then evaluated once
    for arguments in asked:
        text = json.dumps(arguments)
        if text not in made:
            references = [_reference(one, shapes) for one in arguments.pop("references")]
            used = [tables[place] for place in arguments.pop("tables")]
            made[text] = core.Material(**arguments, references=references, tables=used)
        yield made[text]
