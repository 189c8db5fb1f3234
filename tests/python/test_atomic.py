# SPDX-License-Identifier: GPL-3.0-or-later
"""Outputs are replaced as a whole or not at all."""
import json
import math
import os
import stat

import pytest

from freecad.fgmesh import io


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
