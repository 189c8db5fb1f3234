# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell scripts: harmless where nothing is to do, usable from any folder."""
import os
import subprocess

import pytest

SCRIPTS = ("install-dependencies", "build", "test", "demo", "in-debian", "test-on")


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


@pytest.fixture
def install(source_dir, tmp_path):
    """A function: what install-dependencies tells apt-get where these packages are not installed and those unknown."""

    def run(missing, unknown="none"):
        stubs = {
            "dpkg-query": f"printf '%s\\n' \"$@\" | grep '^[a-z]' | grep -vx '{missing}' | sed 's/$/ installed/'",
            "apt-cache": f"echo \"$2\" | grep -vxq '{unknown}' && echo Filename: a.deb",
            "apt-get": 'echo "$DEBIAN_FRONTEND $*" >&2',
            "sudo": 'exec "$@"',
        }
        for name, body in stubs.items():
            (tmp_path / name).write_text(f"#!/bin/sh\n{body}\n")
            (tmp_path / name).chmod(0o755)
        environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
        command = [source_dir / "scripts" / "install-dependencies"]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return [line for line in done.stderr.splitlines() if line.startswith("noninteractive")]

    return run


@pytest.mark.parametrize("package", ["gmsh", "calculix-ccx"])
def test_what_is_missing_is_installed_and_nothing_else(install, package):
    calls = install(package)
    assert len(calls) == 2 and calls[0].endswith(" update")
    assert "--no-install-recommends" in calls[1] and calls[1].endswith(f" {package}")


def test_what_a_release_does_not_have_is_not_asked_for(install):
    """Debian 13 has no calculix-ccx; a release without Qt 5 has the tools of Qt 6."""
    assert install("calculix-ccx", unknown="calculix-ccx") == []
    calls = install("qt.*tools", unknown="qttools5-dev-tools")
    assert len(calls) == 2 and calls[1].endswith(" qt6-l10n-tools")


@pytest.mark.parametrize(
    "name, arguments", [("in-debian", ["trixie"]), ("test-on", []), ("test-on", ["-k", "a"])]
)
def test_a_release_has_to_be_named(source_dir, name, arguments):
    done = subprocess.run([source_dir / "scripts" / name, *arguments], capture_output=True, text=True)
    assert done.returncode == 2 and "usage" in done.stderr


def test_demo_wants_a_part_and_a_formula(source_dir, tmp_path):
    done = subprocess.run(
        [source_dir / "scripts" / "demo", "part.step"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 2 and "usage" in done.stderr
