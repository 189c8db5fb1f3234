# SPDX-License-Identifier: GPL-3.0-or-later
"""What the proxies of this workbench have in common."""


class Stateless:
    """A proxy with no state that is saved: everything is in its object's properties."""

    # FreeCAD 0.20 calls the first pair, 1.x the second.
    def __getstate__(self):
        return None

    def __setstate__(self, state):
        pass

    dumps = __getstate__
    loads = __setstate__
