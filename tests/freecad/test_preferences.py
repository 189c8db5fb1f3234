# SPDX-License-Identifier: GPL-3.0-or-later
"""The preference page, the code that reads what it stores, and the options of a mesh have the same defaults."""
import xml.etree.ElementTree as xml

import pytest

from freecad.fgmesh import core
from freecad.fgmesh.model import preferences


@pytest.fixture
def group(monkeypatch):
    """An empty group of parameters in place of the user's."""
    import FreeCAD

    path = "User parameter:BaseApp/Preferences/Mod/FGMeshTest"
    monkeypatch.setattr(preferences, "_GROUP", path)
    FreeCAD.ParamGet(path).Clear()
    yield FreeCAD.ParamGet(path)
    FreeCAD.ParamGet(path).Clear()


@pytest.fixture
def page(source_dir):
    """{entry: {property: text}} of the widgets that store something."""
    root = xml.parse(source_dir / "freecad" / "fgmesh" / "panels" / "preferences.ui").getroot()
    found = {}
    for widget in root.iter("widget"):
        properties = {one.get("name"): "".join(one.itertext()).strip() for one in widget.findall("property")}
        if "prefEntry" in properties:
            assert properties["prefPath"] == "Mod/FGMesh"
            found[properties["prefEntry"]] = properties
    return found


def test_page_shows_what_holds_where_nothing_is_stored(page, group):
    options = core.MeshingOptions()
    assert set(page) == {"MaterialThreshold", "SecondOrder", "TimeLimit", "MemoryLimit", "PreviewAtStart"}
    assert float(page["MaterialThreshold"]["value"]) == options.material_threshold
    assert (page["SecondOrder"].get("checked") == "true") == (options.order == 2)
    assert preferences.mesh_values() == {
        "MaterialThreshold": options.material_threshold,
        "SecondOrder": options.order == 2,
    }
    assert [page[name].get("value", "0") for name in ("TimeLimit", "MemoryLimit")] == ["0", "0"]
    assert preferences.limits() == (0, 0)
    assert (page["PreviewAtStart"].get("checked") == "true") == preferences.preview_at_start()


def test_page_refuses_what_meshing_refuses(page):
    for entry in ("minimum", "maximum"):
        core.MeshingOptions(material_threshold=float(page["MaterialThreshold"][entry])).validate()


def test_what_is_stored_holds(group):
    group.SetFloat("MaterialThreshold", 0.25)
    group.SetBool("SecondOrder", True)
    group.SetInt("TimeLimit", 60)
    group.SetInt("MemoryLimit", 500)
    group.SetBool("PreviewAtStart", False)
    assert preferences.mesh_values() == {"MaterialThreshold": 0.25, "SecondOrder": True}
    assert preferences.limits() == (60, 500)
    assert preferences.preview_at_start() is False
