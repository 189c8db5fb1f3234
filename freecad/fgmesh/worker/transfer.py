# SPDX-License-Identifier: GPL-3.0-or-later
"""Values on their way between processes: arrays through a file in memory, all else as JSON."""
import mmap
import os
from types import SimpleNamespace

import numpy as np

ALIGNMENT = 64
"""Bytes: where arrays begin, so that reading them in place is as quick as from memory of their own."""


def mapped(file):
    """A buffer with the content of an open file, by its number, for `unpack`."""
    return mmap.mmap(file, 0, access=mmap.ACCESS_READ) if os.fstat(file).st_size else b""


def pack(value, file):
    """`value` as JSON can hold it: numbers, texts and lists as they are, of other objects the public fields.

    Arrays go into `file`, opened for writing in binary.
    """
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.ndarray):
        file.write(bytes(-file.tell() % ALIGNMENT))
        offset = file.tell()
        file.write(np.ascontiguousarray(value))
        return {"array": [value.dtype.str, value.shape, offset]}
    if isinstance(value, (list, tuple)):
        return [pack(item, file) for item in value]
    names = [name for name in dir(value) if not name.startswith("_")]
    fields = {name: getattr(value, name) for name in names}
    return {"fields": {name: pack(field, file) for name, field in fields.items() if not callable(field)}}


def unpack(value, memory):
    """What `pack` was given; arrays are views of `memory`, a buffer with the content of its file."""
    if isinstance(value, list):
        return [unpack(item, memory) for item in value]
    if not isinstance(value, dict):
        return value
    if "array" in value:
        dtype, shape, offset = value["array"]
        return np.ndarray(shape, dtype, memory, offset)
    return SimpleNamespace(**{name: unpack(field, memory) for name, field in value["fields"].items()})
