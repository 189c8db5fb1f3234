# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a GUI says how it shows a new mesh object, so that the model need not know the GUI."""


def no_view(mesh):
    """Headless: objects have no view provider."""


show = no_view
