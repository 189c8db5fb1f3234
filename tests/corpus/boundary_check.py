# SPDX-License-Identifier: GPL-3.0-or-later
"""What FreeCAD says of a shape and of points on its boundary: run as a program, since OpenCASCADE may crash.

    boundary_check.py SHAPE POINTS.npz

POINTS holds "points" (n, 3), mm, and "carriers" (n, 2): the dimension (0, 1, 2) and N of the VertexN, EdgeN or FaceN
that each is to lie on. Prints JSON: of each solid of the shape "euler", the Euler characteristic of its boundary, and
"volume", mm^3; "distance", the largest of a point to its carrier, mm.
"""
import json
import sys

import numpy as np

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402
import Part  # noqa: E402


def main(shape_file, points_file):
    shape = Part.Shape()
    shape.read(shape_file)
    asked, parts = np.load(points_file), (shape.Vertexes, shape.Edges, shape.Faces)
    distances = [
        distance(FreeCAD.Vector(*point), parts[dimension][number - 1])
        for point, (dimension, number) in zip(asked["points"].tolist(), asked["carriers"].tolist())
    ]
    answer = {
        "euler": list(map(euler, shape.Solids)),
        "volume": [solid.Volume for solid in shape.Solids],
        "distance": max(distances, default=0.0),
    }
    # Not through destructors, which crash in some versions of FreeCAD.
    print(json.dumps(answer), flush=True)


def distance(point, part):
    """Of a point to a vertex, edge or face. OpenCASCADE takes a good part of some faces, as of a half torus fused with its
    mirror image, to lie outside of them; their triangles tell."""
    found = part.distToShape(Part.Vertex(point))[0]
    if part.ShapeType != "Face" or found <= part.Tolerance:
        return found
    from_surface = part.Surface.projectPoint(point, "LowerDistance")
    fineness = part.BoundBox.DiagonalLength / 1000
    points, triangles = part.tessellate(fineness)
    corners = np.array([tuple(corner) for corner in points])[np.array(triangles)]
    return from_surface if distance_to_triangles(np.array(point), corners) <= 2 * fineness else found


def distance_to_triangles(point, corners):
    """Of a point to the nearest of some triangles (n, 3, 3)."""
    sides = np.roll(corners, -1, axis=1) - corners
    ways = point - corners
    lengths = (sides**2).sum(axis=2)
    along = np.clip((ways * sides).sum(axis=2) / np.where(lengths > 0, lengths, 1), 0, 1)
    to_sides = np.linalg.norm(ways - along[..., None] * sides, axis=2).min(axis=1)
    normals = np.cross(sides[:, 0], sides[:, 1])
    inside = ((np.cross(sides, ways) * normals[:, None]).sum(axis=2) >= 0).all(axis=1)
    areas = np.linalg.norm(normals, axis=1)
    heights = np.abs((ways[:, 0] * normals).sum(axis=1)) / np.where(areas > 0, areas, 1)
    return np.where(inside & (areas > 0), heights, to_sides).min()


def euler(solid):
    """V - E + F, where a face with holes counts as many less; poles are no edges. Euler's and Poincare's formula.
    Vertices that stand alone in a solid are not counted."""
    edges = sum(not edge.Degenerated for edge in solid.Edges)
    holes = sum(len(face.Wires) - 1 for face in solid.Faces)
    vertices = Part.Compound(solid.Edges).Vertexes  # by their hash codes some would be one, by chance
    return len(vertices) - edges + len(solid.Faces) - holes


if __name__ == "__main__":
    main(*sys.argv[1:])
