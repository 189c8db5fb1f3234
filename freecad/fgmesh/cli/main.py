# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow of the command line, and its exit statuses."""
import contextlib
import os
import sys
from pathlib import Path

from freecad.fgmesh.cli import interrupts

OK, FAULT, USAGE, GEOMETRY, UNMET, STOPPED = *range(5), interrupts.STOPPED


def main(argv=None):
    """Run `fgmesh` with `argv` (default: the process's arguments) and give its exit status."""
    try:
        interrupts.install()
        return _main(sys.argv[1:] if argv is None else argv)
    except MemoryError:
        return _fail(STOPPED, "stopped: out of memory; a larger threshold or deviation needs less")
    except ImportError as error:
        return _fail(FAULT, str(error))
    except Exception as error:
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

    sys.stdout.reconfigure(errors="backslashreplace")
    parsed = arguments.build_parser(core.MeshingOptions(), core.versions()["fgmesh"]).parse_args(
        arguments.joined_values(argv)
    )
    try:
        return _mesh(parsed)
    except (core.InvalidInput, OutputError) as error:
        return _fail(USAGE, str(error))
    except core.GeometryError as error:
        return _fail(GEOMETRY, str(error))
    except core.Cancelled as error:
        return _fail(STOPPED, f"stopped: {error}")


def _mesh(parsed):
    from freecad.fgmesh.cli import material_input, outputs, progress, run, summary

    outputs.check(parsed)
    options = _options(parsed)
    display = progress.make_progress(parsed.quiet)
    # As a str, a path with a line break in it would be taken for the file's content.
    part = Path(parsed.part)

    materials = material_input.read_materials(parsed, part)
    result = run.watched_run(part, materials, options, display, parsed.time_limit, parsed.memory_limit)
    outputs.write(result, parsed)
    if not parsed.quiet:
        _print(f"{summary.summary(result)}\n\nwritten to {parsed.output}")
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


def _print(text):
    try:
        print(text, flush=True)
    except OSError:
        # The reader (head, say) has left, but the mesh is written. Python would complain again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _say(text):
    with contextlib.suppress(OSError):
        print(f"fgmesh: {text}", file=sys.stderr, flush=True)


def _fail(status, text):
    _say(text)
    return status
