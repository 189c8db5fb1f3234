# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a run goes on, guessed from how far it is."""

_LEAST_SECONDS, _LEAST_FRACTION = 2.0, 0.05
"""Before which a guess would be worth nothing."""

SECONDS_PER_TET = 2e-4
"""Of a whole run, as measured with graded balls of a tenth of a million to two million tetrahedra on two cores; larger
ones take as long a tetrahedron."""


class RemainingTime:
    """Told of a run's progress again and again; each stage is one for itself."""

    def __init__(self):
        self._stage, self._began = None, 0.0

    def seconds(self, stage, fraction, now):
        """Seconds that the stage still takes if it goes on as so far; None where that cannot be told yet.

        fraction: of the stage, 0 to 1. now: time in seconds, from any start.
        """
        if stage != self._stage:
            self._stage, self._began = stage, now
        passed = now - self._began
        if passed < _LEAST_SECONDS or not _LEAST_FRACTION <= fraction <= 1:
            return None
        return passed * (1 - fraction) / fraction


def rough_time(seconds):
    """As few digits as a guess deserves: "8 s", "50 s", "3 min", "2 h"."""
    if seconds < 10:
        return f"{max(seconds, 0):.0f} s"
    if seconds < 90:
        return f"{10 * round(seconds / 10)} s"
    if seconds < 90 * 60:
        return f"{round(seconds / 60)} min"
    return f"{round(seconds / 3600)} h"
