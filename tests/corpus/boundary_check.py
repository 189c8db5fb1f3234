# SPDX-License-Identifier: GPL-3.0-or-later
"""What FreeCAD says of a shape and of points on its faces: run as a program, since OpenCASCADE may crash.

    boundary_check.py SHAPE POINTS.npz

POINTS holds "points" (n, 3), mm, and "faces" (n,), N of the FaceN that each is to lie on. Prints JSON: "euler", the
Euler characteristic of the boundary of the shape's solids; "distance", the largest of a point to its face, mm.
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
    asked, faces = np.load(points_file), shape.Faces
    distances = [
        faces[number - 1].distToShape(Part.Vertex(FreeCAD.Vector(*point)))[0]
        for point, number in zip(asked["points"].tolist(), asked["faces"].tolist())
    ]
    answer = {"euler": sum(map(euler, shape.Solids)), "distance": max(distances, default=0.0)}
    # Not through destructors, which crash in some versions of FreeCAD.
    print(json.dumps(answer), flush=True)


def euler(solid):
    """V - E + F, where a face with holes counts as many less; poles are no edges. Euler's and Poincare's formula."""
    edges = sum(not edge.Degenerated for edge in solid.Edges)
    holes = sum(len(face.Wires) - 1 for face in solid.Faces)
    return len(solid.Vertexes) - edges + len(solid.Faces) - holes


if __name__ == "__main__":
    main(*sys.argv[1:])
