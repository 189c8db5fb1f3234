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
        parts[dimension][number - 1].distToShape(Part.Vertex(FreeCAD.Vector(*point)))[0]
        for point, (dimension, number) in zip(asked["points"].tolist(), asked["carriers"].tolist())
    ]
    answer = {
        "euler": list(map(euler, shape.Solids)),
        "volume": [solid.Volume for solid in shape.Solids],
        "distance": max(distances, default=0.0),
    }
    # Not through destructors, which crash in some versions of FreeCAD.
    print(json.dumps(answer), flush=True)


def euler(solid):
    """V - E + F, where a face with holes counts as many less; poles are no edges. Euler's and Poincare's formula.
    Vertices that stand alone in a solid are not counted."""
    edges = sum(not edge.Degenerated for edge in solid.Edges)
    holes = sum(len(face.Wires) - 1 for face in solid.Faces)
    vertices = {vertex.hashCode() for edge in solid.Edges for vertex in edge.Vertexes}
    return len(vertices) - edges + len(solid.Faces) - holes


if __name__ == "__main__":
    main(*sys.argv[1:])
