# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh part of a CalculiX or Abaqus deck, to be included by a deck that adds material and loads."""
import numpy as np

from freecad.fgmesh.io.boundary import element_sides
from freecad.fgmesh.io.groups import face_groups, members, node_groups


def write_abaqus(result, path):
    """Write elements C3D4 or C3D10 numbered from 1, with sets for a deck:

    ELSET SolidN; NSET SolidN, FaceN, EdgeN, VertexN, the nodes of each, for supports; SURFACE FaceN
    (TYPE=ELEMENT), for pressures. The boundary triangles and the edges are no elements of the deck: CalculiX
    would take them for shells and beams.
    """
    tets = np.asarray(result.tets)
    with open(path, "w", encoding="ascii") as file:
        file.write("** FGMesh, lengths in mm\n*NODE, NSET=AllNodes\n")
        _write_rows(
            file,
            "%d, %.17g, %.17g, %.17g",
            [np.arange(1, len(result.points) + 1), *np.asarray(result.points).T],
        )
        nodes = tets.shape[1]  # in the order of VTK, which is that of these elements
        file.write(f"*ELEMENT, TYPE=C3D{nodes}, ELSET=AllSolids\n")
        _write_rows(file, "%d" + ", %d" * nodes, [np.arange(1, len(tets) + 1), *(tets.T + 1)])
        for name, elements in members("Solid", result.tet_solids):
            file.write(f"*ELSET, ELSET={name}\n")
            _write_numbers(file, elements + 1)
        for name, nodes in node_groups(result):
            file.write(f"*NSET, NSET={name}\n")
            _write_numbers(file, nodes + 1)
        element, side = element_sides(result)
        for name, triangles in face_groups(result):
            file.write(f"*SURFACE, NAME={name}, TYPE=ELEMENT\n")
            _write_rows(file, "%d, S%d", [element[triangles] + 1, side[triangles] + 1])


def _write_rows(file, form, columns):
    file.write("\n".join(form % row for row in zip(*(column.tolist() for column in columns))) + "\n")


def _write_numbers(file, numbers):
    """At most 8 numbers a line: Abaqus allows 16, and short lines stay readable."""
    text = [str(number) for number in numbers.tolist()]
    file.write(",\n".join(", ".join(text[i : i + 8]) for i in range(0, len(text), 8)) + "\n")
