# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a run as a JSON file."""
import json
import math

from freecad.fgmesh.io.atomic import replaced_together


def write_report(report, path):
    """Write the dict of `core.report` to `path`, as a whole or not at all. Raises OutputError."""
    with replaced_together(path) as (temporary,):
        write_report_text(report, temporary)


def write_report_text(report, path):
    """Write to a path that needs no protection."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(_without_nan(report), file, indent=1, allow_nan=False)
        file.write("\n")


def _without_nan(value):
    """JSON has no NaN and no infinity: null stands for a figure that does not exist."""
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_nan(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
