# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh part of a CalculiX or Abaqus deck, to be included by a deck that adds material and loads."""
import numpy as np

from freecad.fgmesh.io.boundary import element_sides
from freecad.fgmesh.io.deck_numbers import deck_number, without_noise

ALL_NODES, ALL_SOLIDS = "AllNodes", "AllSolids"
"""Names of sets that no group may have."""


def write_abaqus(mesh, fields, path):
    """Write a GroupedMesh alone to `path`; fields are nothing that a deck of CalculiX could hold."""
    with open(path, "w", encoding="ascii") as file:
        write_mesh_part(file, mesh)


def write_mesh_part(file, mesh):
    """Write elements C3D4 or C3D10 numbered from 1, with sets for a deck, to an open text file:

    NSET AllNodes, ELSET AllSolids; of groups ELSET SolidN; NSET SolidN, FaceN, EdgeN, VertexN, the nodes of each, for
    supports; SURFACE FaceN (TYPE=ELEMENT), for pressures; others of the user's likewise. The boundary triangles and
    the edges are no elements of the deck: CalculiX would take them for shells and beams.
    """
    _write_elements(file, mesh.points, mesh.tets)
    for group in mesh.of(3):
        write_set(file, "ELSET", group.name, group.members)
    for group in mesh.groups:
        write_set(file, "NSET", group.name, mesh.nodes(group))
    element, side = element_sides(mesh)
    for group in mesh.of(2):
        file.write(f"*SURFACE, NAME={group.name}, TYPE=ELEMENT\n")
        write_rows(file, "%d, S%d", [(column[group.members] + 1).tolist() for column in (element, side)])


def _write_elements(file, points, tets):
    tets = np.asarray(tets)
    file.write(f"** FGMesh, lengths in mm\n*NODE, NSET={ALL_NODES}\n")
    coordinates = [map(deck_number, column) for column in without_noise(points).T.tolist()]
    write_rows(file, "%d, %s, %s, %s", [range(1, len(points) + 1), *coordinates])
    nodes = tets.shape[1]  # in the order of VTK, which is that of these elements
    file.write(f"*ELEMENT, TYPE=C3D{nodes}, ELSET={ALL_SOLIDS}\n")
    write_rows(file, "%d" + ", %d" * nodes, [range(1, len(tets) + 1), *(tets.T + 1).tolist()])


def write_set(file, kind, name, members):
    """A set of elements or nodes, with kind "ELSET" or "NSET"; members: their 0-based numbers, an array.

    At most 8 numbers a line: Abaqus allows 16, and short lines stay readable.
    """
    file.write(f"*{kind}, {kind}={name}\n")
    text = [str(number) for number in (members + 1).tolist()]
    file.write(",\n".join(", ".join(text[i : i + 8]) for i in range(0, len(text), 8)) + "\n")


def write_rows(file, form, columns):
    """A line of the format `form` for each row of the columns."""
    file.write("\n".join(form % row for row in zip(*columns)) + "\n")
