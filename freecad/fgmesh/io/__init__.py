# SPDX-License-Identifier: GPL-3.0-or-later
"""Files: meshes in the formats of other programs, reports, all replaced as a whole or not at all."""

from freecad.fgmesh.io.atomic import OutputError, replaced_together
from freecad.fgmesh.io.mesh_file import EXTENSIONS, mesh_format, write_mesh
from freecad.fgmesh.io.report_file import write_report
from freecad.fgmesh.io.report_table import stage_rows, write_report_table

__all__ = [
    "EXTENSIONS",
    "OutputError",
    "mesh_format",
    "replaced_together",
    "stage_rows",
    "write_mesh",
    "write_report",
    "write_report_table",
]
