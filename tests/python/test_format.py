# SPDX-License-Identifier: GPL-3.0-or-later
"""The formatters leave every tracked file as it is.

Releases of the formatters disagree with each other. Debian 12's are the rule; others are not asked.
"""
import re
import shutil
import subprocess

import pytest

RULE = {"black": "23.1.", "clang-format": "14."}


def tracked_files(source_dir, *patterns):
    command = ["git", "-C", str(source_dir), "ls-files", "-z", "--", *patterns]
    answer = subprocess.run(command, capture_output=True, text=True)
    if answer.returncode:
        pytest.skip("no git repository: which files are the project's is not known")
    # A file that is deleted but not yet committed as such is no longer there to be looked at.
    return [name for name in answer.stdout.split("\0") if name and (source_dir / name).exists()]


def formatter(name):
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    version = subprocess.run([name, "--version"], capture_output=True, text=True, check=True).stdout
    found = re.search(r"\d+(\.\d+)+", version).group()
    if not found.startswith(RULE[name]):
        pytest.skip(f"{name} {found} is not the release that rules here ({RULE[name]}*)")
    return name


def test_black(source_dir):
    files = tracked_files(source_dir, "*.py")
    assert files
    command = [formatter("black"), "--check", "--quiet", "--diff", *files]
    answer = subprocess.run(command, cwd=source_dir, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stdout[:5000]


def test_clang_format(source_dir):
    files = tracked_files(source_dir, "*.cpp", "*.hpp")
    assert files
    command = [formatter("clang-format"), "--dry-run", "-Werror", *files]
    answer = subprocess.run(command, cwd=source_dir, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stderr[:5000]


def test_every_source_names_its_licence(source_dir):
    for name in tracked_files(source_dir, "*.py", "*.cpp", "*.hpp"):
        lines = (source_dir / name).read_text(encoding="utf-8").splitlines()
        assert "SPDX-License-Identifier: GPL-3.0-or-later" in lines[0], name
