# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m freecad.fgmesh` is the command line `fgmesh`."""
import sys

from freecad.fgmesh.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
