# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that a user names, read within limits from the first byte: of their size, and of the time of a run."""
import os
import select
import stat

from freecad.fgmesh._core import Cancelled, InvalidInput

_CHUNK = 1 << 20
_WATCH_MILLISECONDS = 100


def read(path, largest, control=None):
    """The content (bytes) of a file or a pipe.

    `largest` is the number of bytes that it may have at most. `control` (RunControl) is looked at meanwhile: a pipe may
    say nothing for ever. Raises InvalidInput, whose text gives the reason alone, so that the caller names the file, or
    Cancelled, whose text names it.
    """
    try:
        # Opening a pipe would wait for its writer otherwise.
        handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        try:
            _check_kind(os.fstat(handle), largest)
            return _content(handle, path, largest, control)
        finally:
            os.close(handle)
    except InvalidInput:
        raise
    except (OSError, ValueError) as error:
        raise InvalidInput(getattr(error, "strerror", None) or str(error)) from None


def _check_kind(status, largest):
    if stat.S_ISDIR(status.st_mode):
        raise InvalidInput("it is a folder: name a file in it")
    if stat.S_ISCHR(status.st_mode) or stat.S_ISBLK(status.st_mode):
        raise InvalidInput("it is a device: name a file or a pipe")
    if stat.S_ISREG(status.st_mode) and status.st_size > largest:
        raise _too_large(largest)


def _content(handle, path, largest, control):
    # A pipe that nobody has opened for writing yet reads as empty, and is told from one that has ended by polling only.
    poll = select.poll()
    poll.register(handle, select.POLLIN)
    parts, size = [], 0
    while True:
        _check(control, path)
        if not poll.poll(_WATCH_MILLISECONDS):
            continue
        try:
            part = os.read(handle, min(_CHUNK, largest + 1 - size))
        except BlockingIOError:
            continue
        if not part:
            return b"".join(parts)
        parts.append(part)
        size += len(part)
        if size > largest:
            raise _too_large(largest)


def _check(control, path):
    if control is None:
        return
    if control.cancelled():
        raise Cancelled(f"the run was cancelled while {os.fspath(path)!r} was read")
    if control.seconds_left() < 0:
        raise Cancelled(f"the time limit was reached while {os.fspath(path)!r} was read")


def _too_large(largest):
    megabytes = largest / 1024**2
    shown = f"{megabytes:.0f} MB" if megabytes >= 1 else f"{largest} bytes"
    return InvalidInput(f"it is larger than {shown}")
