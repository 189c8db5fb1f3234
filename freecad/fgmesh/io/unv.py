# SPDX-License-Identifier: GPL-3.0-or-later
"""I-DEAS universal files (.unv), which meshio does not write. Read by Salome and FreeCAD.

Datasets (https://www.ceas3.uc.edu/sdrluff): 2411 nodes, 2412 elements, 2467 groups. No dataset 164 (units):
readers disagree on the sense of its length factor, and without it all take the numbers, mm, as they stand.
"""
from itertools import chain

# By number of nodes: the element's code (rods and beams, plane stress triangles, solid tetrahedra; linear,
# parabolic) and its nodes from those of VTK. Parabolic elements have each middle node between its corners.
EDGES = {2: (11, [0, 1]), 3: (24, [0, 2, 1])}
TRIANGLES = {3: (41, [0, 1, 2]), 6: (42, [0, 3, 1, 4, 2, 5])}
TETRAHEDRA = {4: (111, [0, 1, 2, 3]), 10: (118, [0, 4, 1, 5, 2, 6, 7, 8, 9, 3])}
BEAMS = {code for code, _ in EDGES.values()}
NODE, ELEMENT = 7, 8  # type codes of group entries


def write_unv(mesh, fields, path):
    """Write a GroupedMesh alone: tetrahedra numbered from 1, then the triangles, then the edges; groups SolidN, FaceN
    and EdgeN of these, and SolidN_Nodes, FaceN_Nodes, EdgeN_Nodes, VertexN_Nodes (points, numbered from 1).
    """
    elements, groups, first = [], [], 1
    for codes, dimension in ((TETRAHEDRA, 3), (TRIANGLES, 2), (EDGES, 1)):
        cells = mesh.cells(dimension)
        elements.append(_elements(first, codes, cells))
        groups += [(group.name, ELEMENT, group.members + first) for group in mesh.of(dimension)]
        first += len(cells)
    groups += [(f"{group.name}_Nodes", NODE, mesh.nodes(group) + 1) for group in mesh.groups]
    with open(path, "w", encoding="ascii") as file:
        _dataset(file, 2411, _nodes(mesh.points))
        _dataset(file, 2412, chain.from_iterable(elements))
        _dataset(
            file, 2467, (line for number, group in enumerate(groups, 1) for line in _group(number, *group))
        )


def _dataset(file, number, lines):
    file.write(f"    -1\n{number:6d}\n")
    file.writelines(f"{line}\n" for line in lines)
    file.write("    -1\n")


def _nodes(points):
    for number, point in enumerate(points.tolist(), 1):
        yield f"{number:10d}{1:10d}{1:10d}{11:10d}"
        # Fortran's D exponent is the rule of this format; E is what today's readers all take.
        yield "".join(f"{coordinate:25.16E}" for coordinate in point)


def _elements(first, kinds, cells):
    kind, order = kinds[cells.shape[1]]
    for number, nodes in enumerate((cells[:, order] + 1).tolist(), first):
        yield f"{number:10d}{kind:10d}{1:10d}{1:10d}{7:10d}{len(nodes):10d}"
        if kind in BEAMS:  # orientation node and cross sections, which mean nothing here
            yield f"{0:10d}" * 3
        for i in range(0, len(nodes), 8):
            yield "".join(f"{node:10d}" for node in nodes[i : i + 8])


def _group(number, name, kind, entries):
    yield f"{number:10d}" + f"{0:10d}" * 6 + f"{len(entries):10d}"
    yield name
    fields = [f"{kind:10d}{entry:10d}{0:10d}{0:10d}" for entry in entries.tolist()]
    for i in range(0, len(fields), 2):
        yield "".join(fields[i : i + 2])
