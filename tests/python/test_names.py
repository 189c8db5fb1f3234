# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of groups in files, whoever has given them."""
import re

import numpy as np
import pytest

HOSTILE = [
    "B, UNSORTED, GENERATE",
    "A\n*INCLUDE, INPUT=/etc/passwd",
    "A\r\n*STEP",
    "\"quoted\" 'name'",
    "",
    "   ",
    "*END STEP",
    "** comment",
    "x" * 300,
    "x" * 299 + "y",
    "Größe der Fläche",
    "面",
    "1st",
    "-0.5",
    "face1",
    "load",
    "LOAD",
    "$EndPhysicalNames",
    "a\0b",
    "a\u2028b",
    "<b>&amp;",
    "../../name",
    "%s{}\\",
    "\U0001f600",
]


@pytest.fixture
def clean_names(build_dir):
    from freecad.fgmesh.io.names import clean_names

    return clean_names


def test_hostile_names_become_harmless_and_stay_apart(clean_names):
    found = clean_names(HOSTILE, taken=["Face1"])
    assert len(found) == len({name.lower() for name in [*found, "Face1"]}) - 1 == len(HOSTILE)
    assert all(re.fullmatch("[A-Za-z][A-Za-z0-9_-]{0,79}", name) for name in found)
    assert found[0] == "B_UNSORTED_GENERATE"


def test_good_names_stay_as_they_are(clean_names):
    good = ["Solid1", "Face12", "My_Load-2", "a" * 80]
    assert clean_names(good) == good
    assert clean_names(["Größe"]) == ["Groe"] or clean_names(["Größe"]) == ["Gro_e"]


def test_many_equal_names(clean_names):
    found = clean_names(["n" * 80] * 1200)
    assert len(set(found)) == 1200 and max(map(len, found)) == 80


def test_numbers_of_parts(build_dir):
    """Only the name of a part of the right kind has one."""
    from freecad.fgmesh.io.groups import Group

    names = {
        ("Face3", 2): 3,
        ("Face3", 3): 0,
        ("Face03", 2): 0,
        ("Face", 2): 0,
        ("Solid2", 3): 2,
        ("Edge0", 1): 0,
    }
    for (name, dimension), number in names.items():
        assert Group(name, dimension, np.arange(1)).number == number
