# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow of the command line, and its exit statuses."""
import contextlib
import os
import sys
from io import StringIO
from pathlib import Path

from freecad.fgmesh import system_limits
from freecad.fgmesh.cli import interrupts, standard_streams

OK, FAULT, USAGE, GEOMETRY, UNMET, STOPPED = *range(5), interrupts.STOPPED


def main(argv=None):
    """Run `fgmesh` with `argv` (default: the process's arguments) and give its exit status."""
    standard_streams.open_missing()
    try:
        return _guarded_main(sys.argv[1:] if argv is None else argv)
    finally:
        standard_streams.drop_unwritten()


def _guarded_main(argv):
    try:
        interrupts.install()
        return _main(argv)
    except MemoryError:
        return _fail(STOPPED, "stopped: out of memory; a larger threshold or deviation needs less")
    except Exception as error:
        limit = system_limits.reached(error)
        if limit:
            return _fail(STOPPED, f"stopped: {limit}")
        if isinstance(error, ImportError):
            return _fail(FAULT, str(error))
        if "FGMESH_DEBUG" in os.environ:
            raise
        text = f"{type(error).__name__}: {error}".splitlines()[0]
        return _fail(
            FAULT, f"internal error: {text} (set FGMESH_DEBUG=1 for the place, and please report it)"
        )


def _main(argv):
    # Signals are caught before these are loaded, which takes a good part of a second.
    from freecad.fgmesh import core
    from freecad.fgmesh.cli import arguments
    from freecad.fgmesh.io import OutputError

    parser = arguments.build_parser(core.MeshingOptions(), core.versions()["fgmesh"])
    parsed, status = _parsed(parser, arguments.joined_values(argv))
    if parsed is None:
        return status
    try:
        return _mesh(parsed)
    except (core.InvalidInput, OutputError) as error:
        return _fail(USAGE, str(error))
    except core.GeometryError as error:
        return _fail(GEOMETRY, str(error))
    except core.Cancelled as error:
        return _fail(STOPPED, f"stopped: {error}")


def _parsed(parser, argv):
    """The parsed arguments, or None and the exit status where help or usage is all that is to be told."""
    results, messages = StringIO(), StringIO()
    try:
        with contextlib.redirect_stdout(results), contextlib.redirect_stderr(messages):
            return parser.parse_args(argv), OK
    except SystemExit as end:
        standard_streams.write_message(messages.getvalue().rstrip())
        return None, _tell(results.getvalue().rstrip()) or end.code


def _mesh(parsed):
    from freecad.fgmesh import core
    from freecad.fgmesh.cli import material_input, outputs, progress, run, summary

    # From here on time counts: a pipe or a slow disk may take all of it.
    control = core.RunControl()
    control.set_limits(parsed.time_limit, parsed.memory_limit)
    outputs.check(parsed)
    options = _options(parsed)
    display = progress.make_progress(parsed.quiet)

    # As a str, a path with a line break in it would be taken for the file's content.
    shape = core.read_shape(Path(parsed.part), control)
    materials = material_input.read_materials(parsed, shape, control)
    result = run.watched_run(shape, materials, options, display, control)
    outputs.write(result, parsed)
    if not parsed.quiet:
        _tell(f"{summary.summary(result)}\n\nwritten to {parsed.output}")
    met = result.status == "ok"
    if not (met and parsed.quiet):
        for message in result.messages:
            _say(message)
    return OK if met else UNMET


def _options(parsed):
    from freecad.fgmesh.cli.arguments import OPTION_FIELDS
    from freecad.fgmesh.core import MeshingOptions

    given = {name: getattr(parsed, name) for name in OPTION_FIELDS if getattr(parsed, name) is not None}
    options = MeshingOptions(**given)
    options.validate()
    return options


def _tell(text):
    """Print results; gives USAGE where they cannot be written, which costs no mesh."""
    reason = standard_streams.write_results(text) if text else None
    if reason is None:
        return OK
    return _fail(USAGE, f"cannot write to standard output: {reason}")


def _say(text):
    standard_streams.write_message(f"fgmesh: {text}")


def _fail(status, text):
    _say(text)
    return status
