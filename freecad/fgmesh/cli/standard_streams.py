# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard input, output and error: closed, full or without a reader, they are no reason to lose a mesh."""
import contextlib
import errno
import os
import sys

_STREAMS = (("stdin", "r"), ("stdout", "w"), ("stderr", "w"))


def open_missing():
    """Put the null device in the place of those that are closed.

    Otherwise the next files that are opened would get their numbers, and be written over by messages.
    """
    for number, (name, mode) in enumerate(_STREAMS):
        try:
            os.fstat(number)
        except OSError:
            _connect_to_null(number)
        if getattr(sys, name) is None:
            setattr(sys, name, open(number, mode, encoding="utf-8", closefd=False))
    for stream in (sys.stdout, sys.stderr):
        # A file's name may hold bytes that are no text.
        stream.reconfigure(errors="backslashreplace")


def write_results(text):
    """Print `text` to standard output. Gives the reason where that cannot be done, else None.

    A reader that has left, as `head` does, has what it wanted.
    """
    try:
        print(text, flush=True)
    except OSError as error:
        # What is still in the buffer would make Python complain at its exit.
        _connect_to_null(sys.stdout.fileno())
        return None if error.errno == errno.EPIPE else error.strerror
    return None


def write_message(text):
    """Print `text`, unless it is empty, to standard error, where anybody listens."""
    if not text:
        return
    with contextlib.suppress(OSError):
        print(text, file=sys.stderr, flush=True)


def drop_unwritten():
    """Forget what could not be written: Python 3.14 would end with a status of its own because of it."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            _connect_to_null(stream.fileno())


def _connect_to_null(number):
    null = os.open(os.devnull, os.O_RDWR)
    if null != number:
        os.dup2(null, number)
        os.close(null)
