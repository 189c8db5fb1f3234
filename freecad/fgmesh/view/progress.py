# SPDX-License-Identifier: GPL-3.0-or-later
"""A run in FreeCAD's progress bar, where Esc cancels it."""
import contextlib
import threading

import FreeCAD


@contextlib.contextmanager
def progress(doing="Meshing"):
    """As presentation.no_progress; the function keeps FreeCAD's windows drawn, too."""
    if threading.current_thread() is not threading.main_thread():
        yield lambda control: None
        return
    indicator = FreeCAD.Base.ProgressIndicator()
    indicator.start(f"{doing} (Esc cancels)", 0)

    def show(control):
        try:
            indicator.next(True)
        except RuntimeError:  # FreeCAD's word for Esc
            control.cancel()

    try:
        yield show
    finally:
        indicator.stop()
