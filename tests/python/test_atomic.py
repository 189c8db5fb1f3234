# SPDX-License-Identifier: GPL-3.0-or-later
"""Outputs are replaced as a whole or not at all."""
import json
import math
import os
import stat
import tempfile
import traceback
from pathlib import Path

import pytest

from freecad.fgmesh import io
from freecad.fgmesh.io.atomic import check_writable


def put(path, text):
    with open(path, "w") as file:
        file.write(text)


def test_replaces_all_at_the_end(tmp_path):
    first, second = tmp_path / "a.vtu", tmp_path / "b.json"
    first.write_text("old")
    with io.replaced_together(first, second) as (one, two):
        put(one, "new")
        put(two, "new too")
        assert first.read_text() == "old" and not second.exists()
    assert (first.read_text(), second.read_text()) == ("new", "new too")
    assert sorted(tmp_path.iterdir()) == [first, second]


@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt, OSError(28, "No space left on device")])
def test_failure_leaves_everything_as_it_was(tmp_path, error):
    first, second = tmp_path / "a.vtu", tmp_path / "b.json"
    first.write_text("old")
    with pytest.raises(BaseException) as caught:
        with io.replaced_together(first, second) as (one, _):
            put(one, "half")
            raise error
    assert first.read_text() == "old" and list(tmp_path.iterdir()) == [first]
    if isinstance(error, OSError):
        assert caught.type is io.OutputError and "No space left" in str(caught.value)


def test_permissions(tmp_path):
    kept, fresh = tmp_path / "kept.vtu", tmp_path / "fresh.vtu"
    kept.touch()
    kept.chmod(0o604)
    before = os.umask(0o027)
    try:
        with io.replaced_together(kept, fresh):
            pass
    finally:
        os.umask(before)
    assert stat.S_IMODE(kept.stat().st_mode) == 0o604
    assert stat.S_IMODE(fresh.stat().st_mode) == 0o640


def test_permissions_that_forbid_the_owner_to_write(tmp_path):
    before = os.umask(0o777)
    try:
        as_nobody(lambda folder: replace(folder / "fresh.vtu"))
    finally:
        os.umask(before)


def test_protected_file_is_refused_beforehand():
    def check(folder):
        (folder / "a.vtu").touch(0o444)
        with pytest.raises(io.OutputError, match="write-protected: name another file"):
            check_writable(folder / "a.vtu")

    as_nobody(check)


def test_file_of_somebody_else_in_a_shared_folder(tmp_path):
    if os.getuid():
        pytest.skip("only root can make a file of another user's")

    def check(folder):
        with pytest.raises(io.OutputError, match="belongs to another user"):
            check_writable(folder / "a.vtu")

    def make(folder):
        (folder / "a.vtu").touch()
        (folder / "a.vtu").chmod(0o666)
        folder.chmod(0o1777)

    as_nobody(check, before=make)


def replace(path):
    with io.replaced_together(path) as (temporary,):
        put(temporary, "new")
    assert path.exists() and stat.S_IMODE(os.stat(path).st_mode) == 0


def as_nobody(action, before=None):
    """Do `action(folder)` in a process without the rights of root, who may write everywhere."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o777)
        if before:
            before(folder)
        child = os.fork()
        if not child:
            try:
                if not os.getuid():
                    os.setgid(65534)
                    os.setuid(65534)
                action(folder)
                os._exit(0)
            finally:
                traceback.print_exc()
                os._exit(1)
        assert os.waitpid(child, 0)[1] == 0


def test_symbolic_link_is_followed(tmp_path):
    target, link = tmp_path / "target.vtu", tmp_path / "link.vtu"
    target.write_text("old")
    link.symlink_to(target)
    with io.replaced_together(link) as (temporary,):
        put(temporary, "new")
    assert link.is_symlink() and target.read_text() == "new"


def test_longest_file_name(tmp_path):
    path = tmp_path / ("x" * 251 + ".vtu")
    with io.replaced_together(path):
        pass
    assert path.exists()


@pytest.mark.parametrize("name", ["nowhere/a.vtu", "folder", "pipe", "a\0b.vtu"])
def test_what_cannot_be_a_file(tmp_path, name):
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(io.OutputError):
        with io.replaced_together(f"{tmp_path}/{name}"):
            pytest.fail("work must not begin")
    assert sorted(os.listdir(tmp_path)) == ["folder", "pipe"]


def test_report_is_strict_json(tmp_path):
    io.write_report({"a": [1.5, math.nan, {"b": math.inf}], "c": "ok"}, tmp_path / "report.json")
    text = (tmp_path / "report.json").read_text()
    assert json.loads(text, parse_constant=pytest.fail) == {"a": [1.5, None, {"b": None}], "c": "ok"}
