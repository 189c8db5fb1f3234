# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that a command line asks for: checked before the work, written together after it."""
import os

from freecad.fgmesh import io
from freecad.fgmesh.cli import interrupts
from freecad.fgmesh.io.atomic import check_writable, remove_unfinished
from freecad.fgmesh.io.mesh_file import write_result
from freecad.fgmesh.io.report_file import write_report_text


def check(arguments):
    """Raise io.OutputError where an output cannot be written or would overwrite an input."""
    io.mesh_format(arguments.output)
    outputs = _outputs(arguments)
    for path in outputs:
        check_writable(path)
        for other in (arguments.part, *arguments.material):
            if other and os.path.realpath(path) == os.path.realpath(other):
                raise io.OutputError(f"{path!r} is an input of this run: name another output")
    if len({os.path.realpath(path) for path in outputs}) < len(outputs):
        raise io.OutputError("--output and --report name the same file")


def write(result, arguments):
    """Write mesh and report; they replace their predecessors only when both are complete.

    An interrupt before that leaves nothing behind; after that signals are ignored, since their exit status
    would tell that nothing is written.
    """
    outputs = _outputs(arguments)
    interrupts.before_leaving(remove_unfinished)
    with io.replaced_together(*outputs, before_replacing=interrupts.ignore) as temporary:
        write_result(result, temporary[0], io.mesh_format(arguments.output))
        if arguments.report:
            write_report_text(result.report(), temporary[1])


def _outputs(arguments):
    return [arguments.output, *([arguments.report] if arguments.report else [])]
