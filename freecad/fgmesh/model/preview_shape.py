# SPDX-License-Identifier: GPL-3.0-or-later
"""What of an object of a document is needed to show its solids as triangles."""
from freecad.fgmesh import core
from freecad.fgmesh.model.shapes import brep_text
from freecad.fgmesh.surfaces.surface import shown_surface


def surface_request(thing):
    """(BREP text, diagonal in mm) of thing.Shape, as `worker.start_surface` takes them: quick, whatever the shape.
    Raises core.InvalidInput where there is no solid."""
    shape = thing.Shape
    if shape.isNull() or not shape.Solids:
        raise core.InvalidInput(f"{thing.Label} has no solid")
    return brep_text(shape), shape.BoundBox.DiagonalLength


def surface_of(thing, **limits):
    """The surfaces.surface.Surface of all solids of thing.Shape, made at once, which for shapes of many faces takes
    seconds; limits: as shown_surface() takes them. Raises core.InvalidInput where there is no solid."""
    return shown_surface(*surface_request(thing), **limits)
