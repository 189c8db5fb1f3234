# SPDX-License-Identifier: GPL-3.0-or-later
"""clang accepts every C++ source without a warning; the build itself is made with g++.

The headers of libraries are read once, as a precompiled header, since reading them takes most of the time.
"""
import json
import os
import re
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

WITH_VALUE = {"-o", "-MF", "-MT", "-c"}
WARNINGS = ["-Wall", "-Wextra", "-Werror"]


def sources(source_dir):
    return [file for folder in ("cpp", "tests/cpp") for file in (source_dir / folder).rglob("*.cpp")]


def compile_flags(build_dir):
    """Of each source that is compiled: what the build gives the compiler, but for names of outputs."""
    commands = json.loads((build_dir / "compile_commands.json").read_text())
    flags = {}
    for command in commands:
        words = shlex.split(command["command"])
        start = next(i for i, word in enumerate(words) if word.startswith("-"))
        found, words = [], iter(words[start:])
        for word in words:
            if word in WITH_VALUE:
                next(words)
            elif word == "-isystem":
                found.append((word, next(words)))
            elif word.startswith(("-I", "-D", "-std", "-f")) and "lto" not in word:
                found.append((word,))
        flags[Path(command["file"])] = found
    return flags


def library_headers(files, folders):
    """Names of the headers of libraries that `files` include, also by way of headers of ours."""
    names, seen, waiting = {}, set(), list(files)
    while waiting:
        file = waiting.pop()
        for kind, name in re.findall(r'^#include ([<"])([^>"]+)', file.read_text(), re.MULTILINE):
            if kind == "<":
                names[name] = True
                continue
            header = next(h for h in (folder / name for folder in (file.parent, *folders)) if h.exists())
            if header not in seen:
                seen.add(header)
                waiting.append(header)
    return list(names)


def clang(*arguments):
    try:
        done = subprocess.run(["clang++", *arguments], capture_output=True, text=True)
    except FileNotFoundError:
        pytest.fail("clang++ is not installed: run ./scripts/install-dependencies")
    return done.stderr


@pytest.mark.parametrize("with_occt", (True, False), ids=("OpenCASCADE", "CGAL"))
def test_clang_has_no_complaint(source_dir, build_dir, tmp_path, with_occt):
    """OpenCASCADE's macro Handle breaks headers of CGAL, so each has a precompiled header of its own."""
    of_file = {
        file: flags
        for file, flags in compile_flags(build_dir).items()
        if any("opencascade" in flag[-1].lower() for flag in flags if flag[0] == "-isystem") == with_occt
    }
    files = sorted(file for file in sources(source_dir) if file in of_file)
    assert files
    shared = list(dict.fromkeys(flag for file in files for flag in of_file[file]))
    options = [*WARNINGS, *(word for flag in shared for word in flag)]
    header = tmp_path / "all.hpp"
    folders = [Path(flag[0][2:]) for flag in shared if flag[0].startswith("-I")]
    header.write_text("".join(f"#include <{name}>\n" for name in library_headers(files, folders)))
    precompiled = f"{header}.pch"
    faults = [clang(*options, "-fpch-instantiate-templates", "-x", "c++-header", header, "-o", precompiled)]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        check = ("-fsyntax-only", *options, "-include-pch", precompiled)
        faults += pool.map(lambda file: clang(*check, file), files if not faults[0] else [])
    assert not any(faults), "\n".join(faults)[:5000]


def test_the_build_compiles_every_source(source_dir, build_dir):
    assert set(sources(source_dir)) <= set(compile_flags(build_dir))
