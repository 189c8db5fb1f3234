# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages for users: there is one for each command, their links are alive, and what they name exists."""
import ast
import re

import pytest

LARGEST = 150 * 1024
"""Bytes of a picture."""


@pytest.fixture
def pages(source_dir):
    """{path: text} of all pages."""
    paths = [*source_dir.glob("*.md"), *(source_dir / "docs").rglob("*.md")]
    return {path: path.read_text(encoding="utf-8") for path in paths}


@pytest.fixture
def commands(source_dir):
    """{name: text in the menu} of the workbench's commands."""
    found = {}
    for path in (source_dir / "freecad" / "fgmesh" / "commands").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "TRANSLATE_LATER":
                name, text = (argument.value for argument in node.args)
                found.setdefault(name, text)  # the tip comes after it
    return found


def links(text):
    """[(target, fragment)] of a page's links and pictures, but for those into the web."""
    targets = re.findall(r"\]\(([^)\s]+)\)", re.sub(r"```.*?```", "", text, flags=re.DOTALL))
    return [target.partition("#")[::2] for target in targets if not target.startswith(("http:", "https:"))]


def anchors(text):
    """What GitHub makes of the headings."""
    heads = re.findall(r"^#+ +(.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).strip().replace(" ", "-") for head in heads}


def test_every_command_has_a_page(source_dir, commands, pages):
    assert len(commands) >= 5
    folder = source_dir / "docs" / "commands"
    assert {path.stem for path in folder.glob("*.md")} == set(commands)
    for name, text in commands.items():
        page = pages[folder / f"{name}.md"]
        assert page.startswith(f"# {text}\n") and f"`{name}`" in page
        for part in (
            "**Active**",
            "## Into the document",
            "## Messages and cures",
            "In Python:",
            "../pictures/",
        ):
            assert part in page or (part, name) == ("In Python:", "FGMesh_Preview"), (name, part)
        assert f"commands/{name}.md" in pages[source_dir / "README.md"].replace("docs/", "")
        assert f"commands/{name}.md" in pages[source_dir / "docs" / "workbench.md"]


def test_links_are_alive(pages):
    count = 0
    for path, text in pages.items():
        for target, fragment in links(text):
            found = (path.parent / target).resolve() if target else path
            assert found.exists(), f"{path.name}: {target}"
            assert not fragment or fragment in anchors(found.read_text()), f"{path.name}: {target}#{fragment}"
            count += 1
    assert count > 30


def test_every_picture_is_shown_and_small(source_dir, pages):
    shown = {
        (path.parent / target).resolve()
        for path, text in pages.items()
        for target in re.findall(r"!\[[^\]]+\]\(([^)\s]+)\)", text)
    }
    pictures = set((source_dir / "docs" / "pictures").iterdir())
    assert pictures and pictures <= shown
    for picture in pictures:
        assert picture.suffix == ".png" and picture.stat().st_size <= LARGEST, picture.name


def test_every_picture_is_taken_by_a_test(source_dir):
    tests = (source_dir / "tests" / "gui" / "test_pictures.py").read_text()
    for picture in (source_dir / "docs" / "pictures").iterdir():
        assert f'"{picture.stem}"' in tests or f"/{picture.stem}.png" in tests, picture.name


def test_pages_name_the_fields_of_the_panels(source_dir, pages):
    """Every label of a field in a panel, as it stands there, is in italics on the page of the command."""
    panels = {
        "FGMesh_Material": ("material_panel", "parameter_table", "frame_box", "reference_list"),
        "FGMesh_Preview": ("preview_box",),
        "FGMesh_Mesh": ("mesh_panel", "mesh_options_box"),
        "FGMesh_Report": ("report_panel",),
        "FGMesh_Analysis": ("analysis_panel",),
    }
    label = re.compile(r'(?:QLabel|QPushButton|QCheckBox|addRow|super\(\).__init__)\(translate\("([^"{]+)"\)')
    seen = 0
    for command, modules in panels.items():
        page = pages[source_dir / "docs" / "commands" / f"{command}.md"]
        for module in modules:
            source = (source_dir / "freecad" / "fgmesh" / "panels" / f"{module}.py").read_text()
            for text in label.findall(source):
                shown = text.replace("Frame of x y z r theta d", "Origin")
                assert f"*{shown}*" in page, f"{command}: {text}"
                seen += 1
    assert seen >= 15


def test_macros_on_the_pages_can_be_parsed(pages):
    blocks = [
        block
        for text in pages.values()
        for block in re.findall(r"```python\n(.*?)```", text, flags=re.DOTALL)
    ]
    assert len(blocks) > 4
    for block in blocks:
        ast.parse(block)
