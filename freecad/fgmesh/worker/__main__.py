# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m freecad.fgmesh.worker` is the child process; only `worker.start` knows how to call it."""
from freecad.fgmesh.worker.child import main

if __name__ == "__main__":
    main()
