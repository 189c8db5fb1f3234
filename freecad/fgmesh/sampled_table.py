# SPDX-License-Identifier: GPL-3.0-or-later
"""Sampled tables as text: what t1 t2 ... of a formula are the values of.

    r, z, value
    0, 0, 0.1
    0, 5, 0.3
    ...

The first line names the columns: one to three coordinates of the material's frame (x y z r theta d; mm, radians), and
`value`. Columns are separated by commas, semicolons or white space. The rows may stand in any order; together they
fill a rectilinear grid, each combination of the coordinates once. Lines that begin with # are comments.
"""
import functools
import math
import os
import re
from contextlib import contextmanager

import numpy as np

from freecad.fgmesh import input_file
from freecad.fgmesh._core import InvalidInput, SampledTable

COORDINATES = ("x", "y", "z", "r", "theta", "d")

LARGEST_TEXT = 256 * 1024**2
"""Bytes: some ten for each number of as many rows as a table may have."""

_LARGEST_NUMBER = 1e100  # as the compiled part has it

_NO_TEXT = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")
"""Characters that no document of FreeCAD's, which is XML, can hold."""

_SAME = 1e-9
"""Of the extent of a coordinate: places that differ by less are one, rounded differently."""


def read(source, name="the table", control=None):
    """The SampledTable of `source`: itself, or what `text` takes. `name` is what messages call it.

    control: RunControl, which ends the reading of a pipe that says nothing. Raises InvalidInput that names the table, the
    line where there is one, and a cure; Cancelled.
    """
    if isinstance(source, SampledTable):
        return source
    with _named(source, name):
        return _parsed(_content(source, control))


def text(source, name="the table"):
    """The text of a table: bytes are the text itself, a str of several lines likewise; any other str, or a
    path-like object, is the path of a file; of a SampledTable it is one that gives the same again.

    Raises InvalidInput where a file cannot be read, or is no text.
    """
    with _named(source, name):
        return _text(source)


def read_all(sources):
    """The tables of a material, called t1, t2, ... in messages."""
    return _each(read, sources)


def texts(sources):
    """The texts of a material's tables, likewise."""
    return _each(text, sources)


def is_text(source):
    """Whether `source` is the text of a table, and no path."""
    return isinstance(source, bytes) or isinstance(source, str) and ("\n" in source or "\r" in source)


def _each(function, sources):
    if isinstance(sources, (str, bytes, os.PathLike, SampledTable)):
        raise InvalidInput("tables are given as a list, even where there is only one: [table]")
    return [function(source, f"table t{number}") for number, source in enumerate(sources, 1)]


@contextmanager
def _named(source, name):
    """Has errors begin with the name of the table."""
    try:
        yield
    except InvalidInput as error:
        is_path = isinstance(source, (str, os.PathLike)) and not is_text(source)
        place = f" ({os.fspath(source)})" if is_path else ""
        raise InvalidInput(f"{name}{place}: {error}") from None


def _text(source):
    return _written(source) if isinstance(source, SampledTable) else _clean(_content(source))


def _clean(content):
    """A str with plain line ends of what a file or a user may have given as text."""
    if len(content) > LARGEST_TEXT:
        raise InvalidInput(f"it is larger than {LARGEST_TEXT // 1024**2} MB: take fewer samples")
    try:
        if isinstance(content, bytes):
            content = content.decode()
        content.encode()  # a str may hold what is no character
    except UnicodeError:
        raise InvalidInput("it is no text: save it as CSV, in UTF-8") from None
    # Only these breaks: str.splitlines knows some that no other program takes for one. Excel marks UTF-8.
    content = content.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    if _NO_TEXT.search(content):
        raise InvalidInput("it is no text: save it as CSV, in UTF-8")
    return content.rstrip("\n") + "\n"


def _content(source, control=None):
    """Text as it is, or that of a file."""
    if not isinstance(source, (str, bytes, os.PathLike)):
        raise InvalidInput(
            f"a table is a path, a text of several lines or a core.SampledTable, not {type(source).__name__}"
        )
    if is_text(source):
        return source
    try:
        return input_file.read(source, LARGEST_TEXT, control)
    except InvalidInput as error:
        raise InvalidInput(f"cannot read the file: {error}") from None


def _written(table):
    places, values = table.places, table.values
    grids = np.meshgrid(*places.values(), indexing="ij")
    rows = np.column_stack([*(grid.ravel() for grid in grids), values.ravel()]).tolist()
    return "\n".join([",".join([*places, "value"]), *(",".join(map(repr, row)) for row in rows), ""])


# The panel asks again with each key.
@functools.lru_cache(maxsize=16)
def _parsed(content):
    lines = _clean(content).split("\n")
    header = _header_line(lines)
    names, separator = _header(lines[header - 1].strip().lstrip("#"), header)
    numbers = [
        number
        for number, line in enumerate(lines[header:], header + 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    values = _values([lines[number - 1] for number in numbers], numbers, separator, len(names) + 1)
    return _gridded(names, values, numbers)


_HEADER_CURE = "begin with a line that names the columns, such as 'x, y, value'"


def _header_line(lines):
    """The number of the first that is no comment, or of the comment above it: numpy.savetxt makes one of the header."""
    comment = None
    for number, line in enumerate(lines, 1):
        if line.strip().startswith("#"):
            comment = number if line.strip().strip("#").strip() else comment
        elif line.strip():
            begins_with_number = _is_number(re.split("[;,\\s]", line.strip())[0])
            return comment if begins_with_number and comment else number
    raise InvalidInput(f"it is empty; {_HEADER_CURE}")


def _header(line, number):
    """The names of the coordinates, and what separates columns: None for white space."""
    separator = next((mark for mark in ";," if mark in line), None)
    names = [cell.strip().strip("'\"").lower() for cell in line.split(separator)]
    if _is_number(names[0]):
        raise InvalidInput(f"line {number}: there is no header; {_HEADER_CURE}")
    *coordinates, last = names
    if last != "value" or not 1 <= len(coordinates) <= 3:
        raise InvalidInput(
            f"line {number}: the columns must be one to three coordinates, then 'value'; {_HEADER_CURE}"
        )
    for name in coordinates:
        if name not in COORDINATES:
            raise InvalidInput(
                f"line {number}: the column {_shortened(name)} is unknown; coordinates are "
                f"{' '.join(COORDINATES)}, and 'value' is the last column"
            )
        if coordinates.count(name) > 1:
            raise InvalidInput(f"line {number}: the column {name} stands there twice; leave one out")
    return coordinates, separator


def _values(rows, numbers, separator, width):
    """The numbers of the table, (n, width), of its rows and the numbers of their lines."""
    if not rows:
        raise InvalidInput("it has no rows below its header; add one for each sample")
    if len(rows) > SampledTable.max_values:
        raise InvalidInput(f"it has more than {SampledTable.max_values} rows; take fewer samples")
    try:
        values = np.loadtxt(rows, float, comments=None, delimiter=separator, ndmin=2)
        if values.shape[1] == width and (np.abs(values) <= _LARGEST_NUMBER).all():
            return values
    except ValueError:
        pass
    for row, number in zip(rows, numbers):
        _check_row(row.split(separator), number, width)
    raise InvalidInput("it holds something that is no number")


def _check_row(cells, number, width):
    if len(cells) != width:
        raise InvalidInput(
            f"line {number} has {len(cells)} columns, the header {width}; write a number for each"
        )
    for cell in cells:
        shown = _shortened(cell.strip())
        if not _is_number(cell):
            hint = "; decimals are written with a point" if "," in cell else ""
            raise InvalidInput(f"line {number}: {shown} is no number{hint}")
        if not abs(float(cell)) <= _LARGEST_NUMBER:
            raise InvalidInput(f"line {number}: {shown} is no finite number up to {_LARGEST_NUMBER:g}")


def _gridded(names, values, numbers):
    """The SampledTable of rows in any order."""
    places, indices = zip(*(_places(column) for column in values.T[:-1]))
    shape = tuple(map(len, places))
    size = math.prod(shape)
    if size != len(values):
        _complain_of_grid(names, places, indices, numbers, size)
    flat = np.ravel_multi_index(indices, shape)
    grid = np.full(size, np.nan)
    grid[flat] = values[:, -1]
    if np.isnan(grid).any():
        _complain_of_grid(names, places, indices, numbers, size)
    return SampledTable(dict(zip(names, places)), grid.reshape(shape))


def _places(column):
    """The places of a coordinate, ascending, and which of them each row has."""
    found = np.unique(column)
    tolerance = _SAME * (found[-1] - found[0])
    places = found[np.concatenate([[True], np.diff(found) > tolerance])]
    return places, np.searchsorted(places, column, side="right") - 1


def _complain_of_grid(names, places, indices, numbers, size):
    """Names a place that stands there twice, or else one that is missing."""
    order = np.lexsort(indices[::-1])
    ordered = np.column_stack(indices)[order]

    def shown(index):
        return ", ".join(f"{name} = {axis[at]:.12g}" for name, axis, at in zip(names, places, index))

    doubled = np.flatnonzero((ordered[1:] == ordered[:-1]).all(axis=1))
    if len(doubled):
        first, second = numbers[order[doubled[0]]], numbers[order[doubled[0] + 1]]
        raise InvalidInput(
            f"line {second}: {shown(ordered[doubled[0]])} stands in line {first} already; keep one of them"
        )
    shape = [len(axis) for axis in places]
    expected = np.column_stack(_unravelled(np.arange(len(ordered) + 1), shape))
    wrong = np.flatnonzero((expected[:-1] != ordered).any(axis=1))
    missing = expected[wrong[0] if len(wrong) else len(ordered)]
    raise InvalidInput(
        f"there is no row for {shown(missing)}; {len(numbers)} rows must fill a grid of "
        f"{' x '.join(map(str, shape))} = {size} places, each combination of the coordinates once"
    )


def _unravelled(flat, shape):
    """numpy.unravel_index for grids of any size."""
    indices = []
    for length in reversed(shape):
        flat, index = np.divmod(flat, length)
        indices.insert(0, index)
    return indices


def _is_number(cell):
    try:
        float(cell)
    except ValueError:
        return False
    return cell.isascii() and "_" not in cell  # which Python alone takes for numbers


def _shortened(cell):
    return repr(cell if len(cell) <= 40 else cell[:37] + "...")
