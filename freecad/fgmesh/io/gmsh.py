# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh's files of version 4.1, binary (https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format).

meshio writes no entity that has no point of its own, as an edge of the shape under a single mesh edge.
"""
import numpy as np

from freecad.fgmesh.io.fields import cell_data, point_data
from freecad.fgmesh.io.groups import members

# By dimension and number of nodes: the element's code, and its nodes from those of VTK.
_CODES = {(0, 1): 15, (1, 2): 1, (1, 3): 8, (2, 3): 2, (2, 6): 9, (3, 4): 4, (3, 10): 11}
_TEN_NODES = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]
_DATUM = np.dtype([("number", np.int32), ("value", np.float64)])


def write_gmsh(result, path):
    """Write tetrahedra, triangles, edges and points, each kind sorted by the part of the shape, which is an entity
    and a physical group: SolidN, FaceN, EdgeN, VertexN. Edges and points carry the variation and the angle of a
    tetrahedron at them.
    """
    carriers = _carriers(result)
    # Some readers, meshio among them, number points as they stand in the file, which is entity by entity.
    order = np.lexsort((carriers[:, 1], carriers[:, 0]))
    place = np.argsort(order)
    blocks = list(_blocks(result))
    with open(path, "wb") as file:
        _section(file, "MeshFormat", b"4.1 1 8\n" + _ints(1) + b"\n")
        names = [f'{dimension} {number} "{name}"\n' for dimension, number, name, *_ in blocks]
        _section(file, "PhysicalNames", f"{len(names)}\n{''.join(names)}".encode())
        _section(file, "Entities", _entities(blocks, np.asarray(result.points)))
        _section(file, "Nodes", _nodes(carriers[order], np.asarray(result.points)[order]))
        _section(file, "Elements", _elements(blocks, place))
        for name, values in point_data(result).items():
            _section(file, "NodeData", _data(name, values[order]))
        for name, values in _fields_of_blocks(result, blocks).items():
            _section(file, "ElementData", _data(name, values))


def _carriers(result):
    """Those of the result; a solid at it carries a point on an edge or a vertex that is no entity of the file."""
    carriers = np.array(result.carriers)
    nameless = carriers[:, 1] == 0
    solids = np.asarray(result.tet_solids)[_tets_at_points(result)]
    carriers[nameless] = np.column_stack([np.full(len(solids), 3), solids])[nameless]
    return carriers


def _tets_at_points(result):
    """(n,): index of a tetrahedron at each point."""
    found = np.empty(len(result.points), np.int64)
    found[np.asarray(result.tets)] = np.arange(len(result.tets))[:, None]
    return found


def _blocks(result):
    """Yield (dimension, number, name, rows of the cells, cells) for each part of the shape."""
    dimension, number = np.asarray(result.carriers).T
    vertices = np.flatnonzero(dimension == 0)
    kinds = [
        (3, "Solid", result.tets, result.tet_solids),
        (2, "Face", result.triangles, result.triangle_faces),
        (1, "Edge", result.edges, result.edge_edges),
        (0, "Vertex", vertices[:, None], number[vertices]),
    ]
    for dimension, word, cells, numbers in kinds:
        for name, rows in members(word, numbers):
            yield dimension, int(name[len(word) :]), name, rows, np.asarray(cells)[rows]


def _section(file, name, content):
    file.write(f"${name}\n".encode() + content + f"$End{name}\n".encode())


def _ints(*values):
    return np.array(values, np.int32).tobytes()


def _sizes(*values):
    return np.array(values, np.uint64).tobytes()


def _entities(blocks, points):
    """Boxes and physical groups; what bounds what is left out."""
    parts = [_sizes(*(sum(block[0] == dimension for block in blocks) for dimension in range(4)))]
    for dimension, number, _, _, cells in sorted(blocks, key=lambda block: block[:2]):
        nodes = points[cells.reshape(-1)]
        box = nodes[0] if dimension == 0 else np.concatenate([nodes.min(axis=0), nodes.max(axis=0)])
        parts += [_ints(number), box.tobytes(), _sizes(1), _ints(number)]
        if dimension > 0:
            parts.append(_sizes(0))
    return b"".join(parts) + b"\n"


def _nodes(carriers, points):
    """Points sorted by what carries them, numbered from 1."""
    starts = np.flatnonzero(np.any(np.diff(carriers, axis=0, prepend=-1), axis=1))
    parts = [_sizes(len(starts), len(points), 1, len(points))]
    for start, end in zip(starts, [*starts[1:], len(points)]):
        numbers = np.arange(start + 1, end + 1, dtype=np.uint64)
        parts += [_ints(*carriers[start], 0), _sizes(end - start), numbers.tobytes()]
        parts.append(points[start:end].tobytes())
    return b"".join(parts) + b"\n"


def _elements(blocks, place):
    total = sum(len(block[3]) for block in blocks)
    parts, first = [_sizes(len(blocks), total, 1, total)], 1
    for dimension, number, _, rows, cells in blocks:
        nodes = place[cells] + 1
        if cells.shape[1] == 10:
            nodes = nodes[:, _TEN_NODES]
        numbered = np.column_stack([np.arange(first, first + len(rows)), nodes])
        parts += [_ints(dimension, number, _CODES[dimension, cells.shape[1]]), _sizes(len(rows))]
        parts.append(numbered.astype(np.uint64).tobytes())
        first += len(rows)
    return b"".join(parts) + b"\n"


def _fields_of_blocks(result, blocks):
    """The fields of all elements, in the order of the file."""
    tet_at = _tets_at_points(result)
    fields = {}
    for name, (of_tets, of_triangles) in cell_data(result).items():
        in_blocks = []
        for dimension, _, _, rows, cells in blocks:
            if dimension >= 2:
                in_blocks.append((of_tets if dimension == 3 else of_triangles)[rows])
            elif name in ("solid", "face"):
                in_blocks.append(np.zeros(len(rows)))
            else:
                in_blocks.append(of_tets[tet_at[cells[:, 0]]])
        fields[name] = np.concatenate(in_blocks)
    return fields


def _data(name, values):
    """One number for each node or element."""
    data = np.empty(len(values), _DATUM)
    data["number"], data["value"] = np.arange(1, len(values) + 1), values
    return f'1\n"{name}"\n1\n0.0\n3\n0\n1\n{len(values)}\n'.encode() + data.tobytes() + b"\n"
