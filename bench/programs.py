# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of others, run from the benchmark."""
import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OWN = Path(os.environ.get("FGMESH_BUILD", ROOT / "build")) / "bench"
"""Where the target `rivals` puts what is compiled for the benchmark."""


class RivalFailed(RuntimeError):
    """A program ended without the mesh that it was asked for."""


class TooSlow(RivalFailed):
    """A program was stopped; a finer mesh would have taken longer."""


def run(command, limit):
    """What a command writes to standard output. Raises RivalFailed where it fails, TooSlow where it
    needs more than `limit` s."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=limit)
    except FileNotFoundError:
        raise RivalFailed(f"{words[0]} is not installed") from None
    except subprocess.TimeoutExpired:
        raise TooSlow(f"one run takes more than {limit:.0f} s") from None
    if done.returncode:
        told = (done.stderr or done.stdout)[-300:].strip()
        raise RivalFailed(f"{Path(words[0]).name} ended with status {done.returncode}: {told}")
    return done.stdout


def told_seconds(output):
    """The seconds that a program of ours tells in its last line."""
    return json.loads(output.strip().splitlines()[-1])["seconds"]
