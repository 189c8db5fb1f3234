# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell scripts: harmless where nothing is to do, usable from any folder."""
import os
import subprocess

import pytest

SCRIPTS = ("install-dependencies", "build", "test", "demo")


@pytest.mark.parametrize("name", [*SCRIPTS, "../.ci/run", "lib.sh"])
def test_syntax(source_dir, name):
    path = source_dir / "scripts" / name
    subprocess.run(["bash", "-n", str(path)], check=True)
    assert name == "lib.sh" or os.access(path, os.X_OK)


def test_nothing_is_installed_twice(source_dir, tmp_path):
    """Every package is present when tests run: neither apt-get nor sudo may be called."""
    for name in ("apt-get", "sudo"):
        (tmp_path / name).write_text("#!/bin/sh\nexit 77\n")
        (tmp_path / name).chmod(0o755)
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    done = subprocess.run(
        [source_dir / "scripts" / "install-dependencies"], cwd=tmp_path, env=environment, capture_output=True
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")


def test_what_is_missing_is_installed_and_nothing_else(source_dir, tmp_path):
    stubs = {
        "dpkg-query": "printf '%s\\n' \"$@\" | grep '^[a-z]' | grep -vx gmsh | sed 's/$/ installed/'",
        "apt-get": 'echo "$DEBIAN_FRONTEND $*" >&2',
        "sudo": 'exec "$@"',
    }
    for name, body in stubs.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{body}\n")
        (tmp_path / name).chmod(0o755)
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    command = [source_dir / "scripts" / "install-dependencies"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    calls = [line for line in done.stderr.splitlines() if line.startswith("noninteractive")]
    assert len(calls) == 2 and calls[0].endswith(" update")
    assert "--no-install-recommends" in calls[1] and calls[1].endswith(" gmsh")


def test_demo_wants_a_part_and_a_formula(source_dir, tmp_path):
    done = subprocess.run(
        [source_dir / "scripts" / "demo", "part.step"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 2 and "usage" in done.stderr
