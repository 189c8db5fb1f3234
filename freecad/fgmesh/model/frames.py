# SPDX-License-Identifier: GPL-3.0-or-later
"""The material's frame from what a user points at: a face, an edge, a vertex, a datum, a coordinate system."""
import FreeCAD

from freecad.fgmesh import core

_AXIS_SURFACES = ("Cylinder", "Cone", "Toroid", "SurfaceOfRevolution")
_Z = FreeCAD.Vector(0, 0, 1)


def frame_from(thing, name, solid):
    """Placement, in the own coordinates of `solid`, of the frame that `thing`, or its part `name`, suggests.

    A plane gives its middle and its normal, outward; a surface with an axis, and a circle, that axis; a straight edge
    its start and direction; a ball its centre and a vertex its place, with the z axis of what they belong to; anything without a shape, and an object
    as a whole, its placement. Raises core.InvalidInput where there is nothing of the kind.
    """
    to_solid = global_placement(solid).inverse()
    if not name:
        return to_solid.multiply(_placement(thing))
    shape = thing.Shape.getElement(name) if hasattr(thing, "Shape") else None
    if shape is None:
        raise core.InvalidInput(f"{thing.Label} has no {name}: point at a face, an edge, a vertex or a datum")
    origin, axis, has_sense = _origin_and_axis(shape, name)
    # The shape stands where the object does; its containers move it further.
    to_solid = to_solid.multiply(global_placement(thing)).multiply(thing.Placement.inverse())
    axis = to_solid.Rotation.multVec(axis)
    if not has_sense and max(axis, key=abs) < 0:
        axis = -axis
    return FreeCAD.Placement(to_solid.multVec(origin), FreeCAD.Rotation(_Z, axis))


def _placement(thing):
    if not hasattr(thing, "Placement"):
        raise core.InvalidInput(f"{thing.Label} has no placement: point at a face, an edge or a datum")
    return global_placement(thing)


def _origin_and_axis(shape, name):
    """And whether the sense of the axis means something; else it is made to point along the solid's own axes."""
    if shape.ShapeType == "Vertex":
        return shape.Point, _Z, False
    carrier = shape.Surface if shape.ShapeType == "Face" else shape.Curve
    kind = type(carrier).__name__
    if kind == "Plane":
        u_low, u_high, v_low, v_high = shape.ParameterRange
        return shape.CenterOfMass, shape.normalAt((u_low + u_high) / 2, (v_low + v_high) / 2), True
    if kind == "Sphere":
        return carrier.Center, _Z, False
    if kind == "Line":
        start, end = shape.valueAt(shape.FirstParameter), shape.valueAt(shape.LastParameter)
        return start, end - start, False
    if kind in _AXIS_SURFACES or kind in ("Circle", "Ellipse"):
        origin = carrier.Center if hasattr(carrier, "Center") else carrier.Location
        return origin, carrier.Axis if hasattr(carrier, "Axis") else carrier.Direction, False
    raise core.InvalidInput(
        f"{name} suggests no frame: point at a plane, a cylinder, a cone, a ball, a straight edge, a circle or a vertex"
    )


def global_placement(thing):
    """Where `thing` stands with all its containers; also of a Fem mesh, which FreeCAD 0.20 does not tell."""
    if hasattr(thing, "getGlobalPlacement"):
        return thing.getGlobalPlacement()
    container = thing.getParentGeoFeatureGroup()
    own = FreeCAD.Placement(thing.Placement)
    return container.getGlobalPlacement().multiply(own) if container is not None else own
