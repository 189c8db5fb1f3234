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
import os

import numpy as np

from freecad.fgmesh._core import InvalidInput, SampledTable

COORDINATES = ("x", "y", "z", "r", "theta", "d")

LARGEST_TEXT = 256 * 1024**2
"""Bytes: some ten for each number of as many rows as a table may have."""

_SAME = 1e-9
"""Of the extent of a coordinate: places that differ by less are one, rounded differently."""


def read(source, name="the table"):
    """The SampledTable of `source`: itself, or what `text` takes. `name` is what messages call it.

    Raises InvalidInput that names the table, the line where there is one, and a cure.
    """
    if isinstance(source, SampledTable):
        return source
    try:
        return _read(text(source, name))
    except InvalidInput as error:
        raise InvalidInput(f"{_full_name(source, name)}{error}") from None


def read_all(sources):
    """The tables of a material, called t1, t2, ... in messages."""
    if isinstance(sources, (str, bytes, os.PathLike, SampledTable)):
        raise InvalidInput("tables are given as a list, also where there is one alone: [table]")
    return [read(source, f"the table t{number}") for number, source in enumerate(sources, 1)]


def text(source, name="the table"):
    """The text of a table: bytes are the text itself, a str of several lines likewise; any other str, or a
    path-like object, is the path of a file; of a SampledTable it is one that gives the same again.

    Raises InvalidInput where a file cannot be read, or is no text.
    """
    if isinstance(source, SampledTable):
        return _written(source)
    if not isinstance(source, (str, bytes, os.PathLike)):
        raise InvalidInput(
            f"{name} must be the path of a file, its text or a core.SampledTable, not {type(source).__name__}"
        )
    content = source.encode("utf-8", "surrogateescape") if is_text(source) else source
    if not isinstance(content, bytes):
        content = _content(content, name)
    if len(content) > LARGEST_TEXT:
        raise InvalidInput(f"{name} is larger than {LARGEST_TEXT // 1024**2} MB: take fewer samples")
    try:
        return "\n".join(content.decode("utf-8-sig").splitlines()) + "\n"
    except UnicodeDecodeError:
        raise InvalidInput(f"{name} is no text: save it as CSV, in UTF-8") from None


def is_text(source):
    """Whether a str, as one of `tables`, is a text and no path."""
    return isinstance(source, str) and ("\n" in source or "\r" in source)


def _full_name(source, name):
    named = isinstance(source, (str, os.PathLike)) and not is_text(source)
    return f"{name} ({os.fspath(source)})" if named else name


def _content(path, name):
    try:
        with open(path, "rb") as file:
            return file.read(LARGEST_TEXT + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InvalidInput(f"cannot be read: {reason}") from None


def _written(table):
    places, values = table.places, table.values
    grids = np.meshgrid(*places.values(), indexing="ij")
    rows = np.column_stack([*(grid.ravel() for grid in grids), values.ravel()]).tolist()
    lines = [",".join([*places, "value"]), *(",".join(map(repr, row)) for row in rows)]
    return "\n".join(lines) + "\n"
