# SPDX-License-Identifier: GPL-3.0-or-later
"""Undo steps that also roll back in a document that keeps no undo, as every headless one."""
from contextlib import contextmanager

import FreeCAD


@contextmanager
def transaction(document, name):
    """One undo step called `name`; a failure inside leaves the document as it was before.

    Where the caller has a transaction open already the changes join it, and committing or aborting stays
    the caller's business.
    """
    # Not document.HasPendingTransaction: a transaction waits for its first change before the document has it.
    if FreeCAD.getActiveTransaction():
        yield
        return
    undo_mode = document.UndoMode
    document.UndoMode = 1
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    else:
        document.commitTransaction()
    finally:
        document.UndoMode = undo_mode
