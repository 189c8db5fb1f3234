# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress display, and the text of results, without a run."""
import io
import itertools
from types import SimpleNamespace

import pytest

from freecad.fgmesh.cli import progress, summary
from freecad.fgmesh.worker.remaining import RemainingTime


class Terminal(io.StringIO):
    def isatty(self):
        return True


def state(stage, fraction=0.0, tets=0, expected_tets=0):
    return SimpleNamespace(stage=stage, fraction=fraction, tets=tets, expected_tets=expected_tets)


@pytest.mark.parametrize("fraction", [-0.5, 0.0, 0.5, 1.0, 7.0])
@pytest.mark.parametrize("columns", [10, 40, 79, 300])
def test_bar_fits_its_line(fraction, columns):
    line = progress.bar_line(state("material", fraction, 123_456_789), 1234.5, columns)
    assert len(line) <= columns and "\n" not in line


@pytest.mark.parametrize(
    "states, expected",
    [
        ([("material", 0.0, 0), ("material", 0.25, 10)], "stage about 30 s more"),  # three quarters are left
        ([("initial", 0.5, 0), ("material", 0.0, 40), ("material", 0.5, 43)], "stage about 3 s more"),
        ([("material", 0.0, 0), ("material", 0.2, 600)], "stage about 40 min more"),
        ([("material", 0.0, 0), ("material", 0.01, 10)], None),  # too early
        ([("material", 0.0, 0), ("material", 0.5, 1)], None),
    ],
)
def test_time_to_come_follows_from_time_gone(states, expected):
    remaining = RemainingTime()
    for stage, fraction, now in states:
        left = remaining.seconds(stage, fraction, now)
    line = progress.bar_line(state(stage, fraction), now, 120, left)
    assert (expected is None and "more" not in line) or (expected or "none") in line


def test_bar_grows():
    filled = [progress.bar_line(state("material", f / 10), 0, 79).count("#") for f in range(11)]
    assert filled[0] == 0 and filled == sorted(set(filled))
    assert "." not in progress.bar_line(state("material", 1.0), 0, 79)


def test_many_more_tetrahedra_to_come_are_told():
    assert progress.tets_of(state("material", 0.1, 500, 12_843_210)) == "500 of about 13000000 tets"
    assert progress.tets_of(state("material", 0.1, 500, 700)) == "500 tets"
    assert progress.tets_of(state("initial", 0.1, 500)) == "500 tets"
    assert progress.tets_of(state("reading")) == "0 tets"


def test_terminal_is_left_clean():
    terminal = Terminal()
    display = progress.make_progress(quiet=False, stream=terminal)
    display.show(state("material", 0.5, 10))
    display.close(state("material", 1.0, 10))
    assert "\n" not in terminal.getvalue() and terminal.getvalue().endswith("\r\x1b[K")


def test_log_has_each_stage_once():
    log = io.StringIO()
    display = progress.make_progress(quiet=False, stream=log)
    for stage, fraction in itertools.product(("", "initial", "material"), (0.1, 0.2, 0.9)):
        display.show(state(stage, fraction))
    display.close(state("geometry"))
    assert [line.split(", ")[1].split()[0] for line in log.getvalue().splitlines()] == [
        "initial",
        "material",
        "geometry",
    ]


def test_quiet_display_says_nothing():
    log = Terminal()
    display = progress.make_progress(quiet=True, stream=log)
    display.show(state("material", 0.5))
    display.close()
    assert log.getvalue() == ""


def test_table_is_aligned():
    lines = summary.table([("a", "bb", "c"), ("long", "1", "22")])
    assert lines == ["a     bb   c", "long   1  22"]
