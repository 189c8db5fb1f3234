# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the command line: what they are called, what they take, what they mean."""
import argparse
import math
import re

DESCRIPTION = """\
Turn a CAD solid of a functionally graded material into a tetrahedral mesh that is fine where the material
changes fast. Lengths are mm. The volume fractions of all constituents but the last, which is the remainder, are
formulas over x y z r theta d (position, cylinder coordinates and distance from the origin of the material's frame),
d1 d2 ... s1 s2 ... (distances to references, s with a sign), t1 t2 ... (values of sampled tables) and named
parameters.
"""

EPILOG = """\
example:
  fgmesh part.step --fraction "exp(-alpha*d)" --param alpha=0.08 --threshold 0.1 -o part.vtu

material file:
  {"fractions": ["exp(-alpha*d)"], "parameters": {"alpha": 0.08}, "origin": [0, 0, 0], "axis": [0, 0, 1]}
  All but "fractions" may be left out, also "references": ["Face1", "Edge2"] and "tables": ["FILE.csv"], seen from
  the folder of the material file. --param, --origin, --axis, --reference and --table overrule the file.

table:
  A header line "r,z,value" (one to three of x y z r theta d, then value), then a row for each sample. The rows fill a
  rectilinear grid, in any order; the value is linear between samples and constant outside. Columns are separated
  by commas, semicolons or white space.

exit status:
  0 mesh written, every criterion met       3 shape refused or not meshable
  1 a fault of the program's own            4 mesh written, threshold or deviation not met
  2 wrong usage, formula or file            5 stopped: time, memory or interrupt
Unless the status is 0 or 4, nothing is written and existing files stay as they are.
"""


def build_parser(defaults, version):
    """The parser; `defaults` is a MeshingOptions whose values the help shows."""
    parser = argparse.ArgumentParser(
        prog="fgmesh",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"fgmesh {version}")
    parser.add_argument("part", metavar="PART", help="STEP or BREP file of one solid")
    _add_material(parser.add_argument_group("material"))
    _add_mesh(parser.add_argument_group("mesh"), defaults)
    _add_run(parser.add_argument_group("run"), defaults)
    return parser


def _add_material(group):
    add = group.add_argument
    add(
        "--fraction",
        metavar="FORMULA",
        action="append",
        default=[],
        help="volume fraction of constituent 1; given again that of 2, ...",
    )
    add(
        "--param",
        metavar="NAME=VALUE",
        type=parameter,
        action="append",
        default=[],
        help="value of a parameter",
    )
    add("--origin", metavar="X,Y,Z", type=triple, help="origin of the material's frame (default 0,0,0)")
    add("--axis", metavar="X,Y,Z", type=triple, help="direction of the frame's z axis (default 0,0,1)")
    add(
        "--material",
        metavar="FILE.json",
        action="append",
        default=[],
        help="material file, in place of --fraction; see below. Given again and again: that of Solid1, Solid2, ...",
    )
    add(
        "--reference",
        metavar="FaceN",
        action="append",
        default=[],
        help="face, edge, vertex or solid of the part; the first is d1 (or s1) in the formula, and so on",
    )
    add(
        "--table",
        metavar="FILE",
        action="append",
        default=[],
        help="CSV file of a sampled table; the first is t1 in the formula, and so on; see below",
    )


def _add_mesh(group, defaults):
    add, part = group.add_argument, "from the part's size"
    threshold = (
        f"largest difference of composition in a tetrahedron (default {defaults.material_threshold:g})"
    )
    add("--threshold", metavar="D", type=number, dest="material_threshold", help=threshold)
    add(
        "--deviation",
        metavar="MM",
        type=number,
        dest="surface_deviation",
        help=f"largest distance of the mesh to the true boundary (default: {part})",
    )
    add(
        "--min-size", metavar="MM", type=number, help=f"shortest edge that refinement makes (default: {part})"
    )
    add("--max-size", metavar="MM", type=number, help=f"longest edge, about (default: {part})")
    add(
        "--anisotropy",
        metavar="A",
        type=number,
        help="elements may be A times longer across the gradient than along it, 1 to 10 (default 1)",
    )
    add(
        "--order",
        type=int,
        choices=(1, 2),
        help=f"1: 4-node tetrahedra; 2: 10-node (default {defaults.order})",
    )
    add(
        "--paper",
        action="store_true",
        help="keep to the paper's own loop, which takes more elements and leaves flat ones; for comparisons",
    )
    add(
        "--no-certificate",
        dest="certify",
        action="store_false",
        default=None,
        help="do not prove the threshold between the corners of each tetrahedron, which takes up to a third of the time",
    )
    stages = ("initial", "material", "geometry")
    add("--stop-after", choices=stages, help=f"last stage to run (default {defaults.stop_after})")


def _add_run(group, defaults):
    add = group.add_argument
    add(
        "--threads",
        metavar="N",
        type=whole(0, 2**31 - 1),
        help="number of threads at most (default: all processors); the mesh does not depend on it",
    )
    add("--seed", metavar="N", type=whole(0, 2**32 - 1), help=f"random seed (default {defaults.seed})")
    add("--time-limit", metavar="S", type=limit, default=0.0, help="stop after so many seconds")
    add(
        "--memory-limit",
        metavar="MB",
        type=limit,
        default=0.0,
        help="stop where more memory is in use (default: 90 %% of what is available)",
    )
    add("-o", "--output", metavar="OUT", required=True, help="mesh file: .vtu, .inp, .unv or .msh")
    add("--report", metavar="OUT.json", help="all figures of the run as JSON")
    add("--quiet", action="store_true", help="show neither progress nor results")


OPTION_FIELDS = (
    "material_threshold",
    "surface_deviation",
    "min_size",
    "max_size",
    "anisotropy",
    "order",
    "paper",
    "certify",
    "stop_after",
    "threads",
    "seed",
)
"""Fields of MeshingOptions that the command line may set."""


def joined_values(argv):
    """`argv` with "--origin", "-1,0,0" joined to "--origin=-1,0,0": argparse would see an option."""
    joined = []
    rest = iter(argv)
    for word in rest:
        if word == "--":
            return [*joined, word, *rest]
        value = next(rest, None) if word in SIGNED_VALUES else None
        joined.append(word if value is None else f"{word}={value}")
    return joined


SIGNED_VALUES = {
    *(
        "--fraction",
        "--param",
        "--origin",
        "--axis",
        "--threshold",
        "--deviation",
        "--min-size",
        "--max-size",
    ),
    *("--anisotropy", "--threads", "--seed", "--time-limit", "--memory-limit"),
}


def number(text):
    """A finite number as C would read it."""
    if not re.fullmatch(r"\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*", text, re.ASCII):
        raise argparse.ArgumentTypeError(f"{shortened(text)} is no number")
    value = float(text)
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{shortened(text)} is too large")
    return value


def limit(text):
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{shortened(text)}: a limit must be above 0")
    return value


def whole(low, high):
    """A type for whole numbers of [low, high]."""

    def convert(text):
        if not re.fullmatch(r"[-+]?\d{1,20}", text, re.ASCII) or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"{shortened(text)} is no whole number from {low} to {high}")
        return int(text)

    return convert


def triple(text):
    parts = text.split(",")
    if len(parts) != 3:
        raise argparse.ArgumentTypeError(f"{shortened(text)} is not of the form X,Y,Z")
    return tuple(number(part) for part in parts)


def parameter(text):
    name, equals, value = text.partition("=")
    if not equals or not name.strip():
        raise argparse.ArgumentTypeError(f"{shortened(text)} is not of the form NAME=VALUE")
    return name.strip(), number(value)


def shortened(text):
    """`text` for a message: quoted, without control characters, not longer than a line."""
    return repr(text if len(text) <= 60 else text[:57] + "...")
