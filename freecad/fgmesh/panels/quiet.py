# SPDX-License-Identifier: GPL-3.0-or-later
"""Setting widgets without telling anybody."""
from contextlib import contextmanager


@contextmanager
def quiet(widget):
    """No signals of `widget` meanwhile. (PySide2 cannot use QSignalBlocker in a `with`.)"""
    before = widget.blockSignals(True)
    try:
        yield
    finally:
        widget.blockSignals(before)
