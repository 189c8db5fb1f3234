# SPDX-License-Identifier: GPL-3.0-or-later
"""translations/*.ts follow the sources, and say what the sources say."""
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

import pytest


@pytest.fixture
def copy(source_dir, tmp_path):
    """A copy of all that scripts/update-translations looks at."""
    for folder in ("freecad", "translations"):
        shutil.copytree(source_dir / folder, tmp_path / folder)
    (tmp_path / "scripts").mkdir()
    shutil.copy(source_dir / "scripts" / "update-translations", tmp_path / "scripts")
    return tmp_path


def update(root, *arguments):
    command = [sys.executable, root / "scripts" / "update-translations", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def messages(path):
    """[(source, translation)] of a .ts file."""
    return [
        (message.find("source").text, message.find("translation").text)
        for message in xml.parse(path).getroot().iter("message")
    ]


def test_all_is_translated(source_dir):
    done = update(source_dir, "--check")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_new_text_is_noticed_and_added(copy):
    ts = copy / "translations" / "FGMesh_de.ts"
    page = copy / "freecad" / "fgmesh" / "panels" / "quiet.py"
    page.write_text(page.read_text() + '\ntranslate("A text that nobody knows")\n')
    before = ts.read_text()
    done = update(copy, "--check")
    assert done.returncode == 1 and "A text that nobody knows" in done.stdout
    assert ts.read_text() == before
    assert update(copy).returncode == 0
    assert ("A text that nobody knows", None) in messages(ts)
    assert update(copy, "--check").returncode == 1  # not translated yet


def test_a_text_that_went_away_is_noticed_and_removed(copy):
    ts = copy / "translations" / "FGMesh_de.ts"
    page = copy / "freecad" / "fgmesh" / "panels" / "preferences.ui"
    page.write_text(page.read_text().replace("<string>Meshing runs</string>", "<string>5</string>"))
    done = update(copy, "--check")
    assert done.returncode == 1 and "out of date" in done.stdout
    kept = dict(messages(ts))
    del kept["Meshing runs"]
    update(copy)
    assert dict(messages(ts)) == kept
    assert update(copy, "--check").returncode == 0


def test_placeholders_and_edges_agree(source_dir):
    """What is filled in, in its order; blanks, dots and separators where texts are put together."""
    (path,) = (source_dir / "translations").glob("*.ts")
    assert len(messages(path)) > 100
    for source, translation in messages(path):
        assert re.findall(r"{.*?}|\*\.\w+", source) == re.findall(r"{.*?}|\*\.\w+", translation), source
        for edge in (r"^\s*[;,]?\s*", r"\s*(?:\.\.\.)?$"):
            assert re.search(edge, source).group() == re.search(edge, translation).group(), source


def test_figures_of_the_report_have_texts(source_dir):
    """The table of stages gets its titles from io, which knows no languages; the panel translates each."""
    from freecad.fgmesh.io.report_table import ROWS

    source = (source_dir / "freecad" / "fgmesh" / "panels" / "report_panel.py").read_text()
    for title, _, _ in ROWS:
        assert f'"{title}": TRANSLATE_LATER("FGMesh", "{title}")' in source
