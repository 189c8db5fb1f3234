# SPDX-License-Identifier: GPL-3.0-or-later
"""The child process, run as a file by its path; only `worker.start` knows how to call it."""
import runpy
from pathlib import Path


def main():
    runpy.run_path(str(Path(__file__).resolve().parents[1] / "own_namespace.py"))["install"]()
    from freecad.fgmesh.worker import child

    child.main()


if __name__ == "__main__":
    main()
