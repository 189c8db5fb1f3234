# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a GUI says how it shows new objects and the progress of a run: others need not know it."""
import contextlib


def no_view(thing):
    """Headless: objects have no view provider."""


@contextlib.contextmanager
def no_progress(doing="Meshing"):
    """Gives a function to be called now and then with the core.RunControl of a run."""
    yield lambda control: None


show = show_graded_material = show_graded_solver = no_view
progress = no_progress
