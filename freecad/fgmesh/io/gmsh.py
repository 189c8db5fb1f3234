# SPDX-License-Identifier: GPL-3.0-or-later
"""Gmsh's files of version 4.1, binary (https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format).

meshio writes no entity that has no point of its own, as an edge of the shape under a single mesh edge.
"""
from typing import NamedTuple

import numpy as np

# By dimension and number of nodes: the element's code, and its nodes from those of VTK.
_CODES = {(0, 1): 15, (1, 2): 1, (1, 3): 8, (2, 3): 2, (2, 6): 9, (3, 4): 4, (3, 10): 11}
_TEN_NODES = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]
_DATUM = np.dtype([("number", np.int32), ("value", np.float64)])


class _Entity(NamedTuple):
    """Cells that are in the same groups."""

    dimension: int
    number: int
    physical: tuple  # numbers of its groups
    rows: np.ndarray  # of its cells
    cells: np.ndarray  # their points


def write_gmsh(mesh, fields, path):
    """Write a GroupedMesh with its Fields: tetrahedra, triangles, edges and points, each kind sorted by entities, which
    are the parts of the shape, with the number that these have. All groups are physical ones, but those of points that
    are no vertex of the shape, which gmsh has not. Cells in no group are left out. Edges and points carry the values of a
    tetrahedron at them.
    """
    physical = _physical_numbers(mesh)
    entities = [entity for dimension in (3, 2, 1, 0) for entity in _entities(mesh, dimension, physical)]
    carriers = _carriers(mesh, entities)
    # Some readers, meshio among them, number points as they stand in the file, which is entity by entity.
    order = np.lexsort((carriers[:, 1], carriers[:, 0]))
    place = np.argsort(order)
    with open(path, "wb") as file:
        _section(file, "MeshFormat", b"4.1 1 8\n" + _ints(1) + b"\n")
        names = [f'{dimension} {number} "{name}"\n' for (dimension, name), number in physical.items()]
        _section(file, "PhysicalNames", f"{len(names)}\n{''.join(names)}".encode())
        _section(file, "Entities", _entity_table(entities, mesh.points))
        _section(file, "Nodes", _nodes(carriers[order], mesh.points[order]))
        _section(file, "Elements", _elements(entities, place))
        for name, values in fields.at_points.items():
            _section(file, "NodeData", _data(name, values[order]))
        for name, values in _fields_of_entities(mesh, fields, entities).items():
            _section(file, "ElementData", _data(name, values))


def _physical_numbers(mesh):
    """{(dimension, name): number} of all groups that become physical ones: N of SolidN; more for others."""
    numbers = {}
    for dimension in (3, 2, 1, 0):
        groups = [group for group in mesh.of(dimension) if group.number or dimension > 0]
        free = max([group.number for group in groups], default=0)
        for group in groups:
            free += not group.number
            numbers[dimension, group.name] = group.number or free
    return numbers


def _entities(mesh, dimension, physical):
    """Yield the entities of a dimension. A part of the shape is the one with its number, but for cells of its that are
    in other groups, too: these make entities with free numbers."""
    groups = [group for group in mesh.of(dimension) if (dimension, group.name) in physical]
    all_cells = mesh.cells(dimension)
    free = max([physical[dimension, group.name] for group in groups], default=0)
    for numbers, rows in _cells_by_groups(groups, [physical[dimension, group.name] for group in groups]):
        free += len(numbers) > 1
        yield _Entity(dimension, numbers[0] if len(numbers) == 1 else free, numbers, rows, all_cells[rows])


def _cells_by_groups(groups, numbers):
    """[(numbers of groups, the rows of the cells that are in these and in no others)]; those of one group come first."""
    if not groups:
        return []
    cells = np.concatenate([group.members for group in groups])
    of_cells = np.repeat(numbers, [len(group.members) for group in groups])
    order = np.lexsort((of_cells, cells))
    cells, of_cells = cells[order], of_cells[order]
    rows, starts, counts = np.unique(cells, return_index=True, return_counts=True)
    alone, kinds = of_cells[starts[counts == 1]], {}
    order = np.argsort(alone, kind="stable")
    found, firsts = np.unique(alone[order], return_index=True)
    for number, chosen in zip(found.tolist(), np.split(rows[counts == 1][order], firsts[1:])):
        kinds[(number,)] = chosen
    for row, start, count in zip(*(column[counts > 1].tolist() for column in (rows, starts, counts))):
        kinds.setdefault(tuple(of_cells[start : start + count].tolist()), []).append(row)
    return [(key, np.array(kinds[key])) for key in sorted(kinds, key=lambda key: (len(key) > 1, key))]


def _carriers(mesh, entities):
    """(n, 2): dimension and number of the entity of the lowest dimension that a point is in."""
    carriers = np.empty((len(mesh.points), 2), np.int32)
    for entity in sorted(entities, key=lambda entity: (-entity.dimension, -entity.number)):
        carriers[entity.cells] = entity.dimension, entity.number
    return carriers


def _tets_at_points(mesh):
    """(n,): index of a tetrahedron at each point."""
    found = np.empty(len(mesh.points), np.int64)
    found[mesh.tets] = np.arange(len(mesh.tets))[:, None]
    return found


def _section(file, name, content):
    file.write(f"${name}\n".encode() + content + f"$End{name}\n".encode())


def _ints(*values):
    return np.array(values, np.int32).tobytes()


def _sizes(*values):
    return np.array(values, np.uint64).tobytes()


def _entity_table(entities, points):
    """Boxes and physical groups; what bounds what is left out."""
    parts = [_sizes(*(sum(one.dimension == dimension for one in entities) for dimension in range(4)))]
    for entity in sorted(entities, key=lambda one: one[:2]):
        nodes = points[entity.cells.reshape(-1)]
        box = nodes[0] if entity.dimension == 0 else np.concatenate([nodes.min(axis=0), nodes.max(axis=0)])
        parts += [_ints(entity.number), box.tobytes(), _sizes(len(entity.physical)), _ints(*entity.physical)]
        if entity.dimension > 0:
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


def _elements(entities, place):
    total = sum(len(one.rows) for one in entities)
    parts, first = [_sizes(len(entities), total, 1, total)], 1
    for dimension, number, _, rows, cells in entities:
        nodes = place[cells] + 1
        if cells.shape[1] == 10:
            nodes = nodes[:, _TEN_NODES]
        numbered = np.column_stack([np.arange(first, first + len(rows)), nodes])
        parts += [_ints(dimension, number, _CODES[dimension, cells.shape[1]]), _sizes(len(rows))]
        parts.append(numbered.astype(np.uint64).tobytes())
        first += len(rows)
    return b"".join(parts) + b"\n"


def _fields_of_entities(mesh, fields, entities):
    """The fields of all elements, in the order of the file."""
    tet_at = _tets_at_points(mesh)
    found = {}
    for name, (of_tets, of_triangles) in fields.in_cells.items():
        parts = []
        for entity in entities:
            if entity.dimension >= 2:
                parts.append((of_tets if entity.dimension == 3 else of_triangles)[entity.rows])
            elif name in ("solid", "face"):
                parts.append(np.zeros(len(entity.rows)))
            else:
                parts.append(of_tets[tet_at[entity.cells[:, 0]]])
        found[name] = np.concatenate(parts)
    return found


def _data(name, values):
    """One number for each node or element."""
    data = np.empty(len(values), _DATUM)
    data["number"], data["value"] = np.arange(1, len(values) + 1), values
    return f'1\n"{name}"\n1\n0.0\n3\n0\n1\n{len(values)}\n'.encode() + data.tobytes() + b"\n"
