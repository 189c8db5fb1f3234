# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups, constraints and materials with names that would break a deck or a file, or get something into it."""
import re
import subprocess

import meshio
import numpy as np
import pytest

KINDS = ("Volume", "Face", "Edge", "Node")
HOSTILE = [
    "B, UNSORTED, GENERATE",
    "A\n*INCLUDE, INPUT=secret.inp",
    'say "a"\n$EndPhysicalNames',
    "*END STEP",
    "x" * 300,
    "x" * 299 + "y",
    "Größe",
    "face1",
    "FACE1",
    "AllNodes",
    "Bin0001",
    "Solid1_Nodes",
    "",
]


def add_hostile_groups(mesh):
    """For each name one of a kind, with three members. Returns {name: (kind, members)}."""
    fem, added = mesh.FemMesh.copy(), {}
    ids = {"Volume": fem.Volumes, "Face": fem.Faces, "Edge": fem.Edges, "Node": sorted(fem.Nodes)}
    for place, name in enumerate(HOSTILE):
        kind = KINDS[place % len(KINDS)]
        members = ids[kind][place : place + 3]
        fem.addGroupElements(fem.addGroup(name, kind), list(members))
        added[name] = kind, members
    mesh.FemMesh = fem
    return added


@pytest.mark.usefixtures("ccx")
def test_exported_files_with_hostile_groups(bar, tmp_path, build_dir):
    from freecad.fgmesh.fem.export import export_properties

    added = add_hostile_groups(bar.mesh)
    names = {bar.mesh.FemMesh.getGroupName(group) for group in bar.mesh.FemMesh.Groups}
    assert {name for name in HOSTILE if name} <= names  # FreeCAD has taken them
    (tmp_path / "secret.inp").write_text("*RESTART, READ\n")
    for extension in ("inp", "msh", "vtu", "xdmf"):
        export_properties(bar.mesh, tmp_path / f"bar.{extension}", most_bins=3)

    deck = (tmp_path / "bar.inp").read_text()
    keywords = set(re.findall(r"^\*[A-Z ]+", deck, re.MULTILINE))
    assert keywords <= {
        *("*NODE", "*ELEMENT", "*ELSET", "*NSET", "*SURFACE", "*MATERIAL", "*ELASTIC", "*DENSITY"),
        *("*CONDUCTIVITY", "*EXPANSION", "*SPECIFIC HEAT", "*SOLID SECTION"),
    }
    sets = re.findall(r"^\*(?:NSET|ELSET), (?:N|EL)SET=(\S+)$", deck, re.MULTILINE)
    assert len(re.findall(r"^\*(?:NSET|ELSET)", deck, re.MULTILINE)) == len(sets)
    assert sets.count("Bin0001") == 1 and sets.count("AllNodes") == 0
    step = "*STEP\n*STATIC\n*BOUNDARY\nB_UNSORTED_GENERATE, 1, 3\nFace1, 1, 3, 0.\n*EL PRINT, ELSET=B_UNSORTED_GENERATE\nEVOL\n"
    (tmp_path / "deck.inp").write_text(f"*INCLUDE, INPUT=bar.inp\n{step}*END STEP\n")
    run = subprocess.run(["ccx", "-i", "deck"], cwd=tmp_path, capture_output=True, text=True)
    assert "Job finished" in run.stdout and "*ERROR" not in run.stdout and "*WARNING" not in run.stdout
    volumes = re.findall(r"^ +(\d+) +\d\.\d+E", (tmp_path / "deck.dat").read_text(), re.MULTILINE)
    assert sorted(map(int, volumes)) == sorted(added["B, UNSORTED, GENERATE"][1])

    command = ["gmsh", str(tmp_path / "bar.msh"), "-save", "-o", str(tmp_path / "again.msh")]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0 and "Error" not in run.stdout + run.stderr
    for path in (tmp_path / "bar.msh", tmp_path / "again.msh"):
        read = meshio.read(path)
        assert {"Solid1", "Face6", "Edge12", "Vertex8", "B_UNSORTED_GENERATE"} <= set(read.field_data)
        assert sum(map(len, read.cell_sets["Solid1"])) == bar.mesh.TetCount
        assert sum(map(len, read.cell_sets["B_UNSORTED_GENERATE"])) == 3
    for name in ("bar.vtu", "bar.xdmf"):
        assert len(meshio.read(tmp_path / name).points) == bar.mesh.PointCount


def _label(analysis, bar):
    bar.constraints[0].Label = "Pull\n*INCLUDE, INPUT=secret.inp"


def _long_label(analysis, bar):
    bar.constraints[0].Label = "x" * 1316 + "*INCLUDE, INPUT=secret.inp"


def _card(analysis, bar):
    material = next(one for one in analysis.Group if "_Bin" in one.Name)
    material.Material = {**material.Material, "Name": "Steel\n*INCLUDE, INPUT=secret.inp"}


def _constraint(name):
    def make(analysis, bar):
        import ObjectsFem

        held = ObjectsFem.makeConstraintFixed(bar.document, name)
        held.References = bar.constraints[1].References
        analysis.addObject(held)

    return make


@pytest.mark.parametrize(
    "spoil, words",
    [
        (_label, "the label of Pressure has more than one line.*rename it"),
        (_long_label, "the label of Pressure has 1342 characters.*rename it"),
        (_card, "Bin0001.*more than one line.*correct it"),
        (_constraint("Face2"), "internal name Face2, which is that of a part of the mesh.*anew"),
        (_constraint("PRESSURE"), "Pressure and PRESSURE differ in capitals only.*anew"),
        (_constraint("x" * 90), "internal name of 90 characters.*anew"),
    ],
)
def test_names_that_freecad_would_write_as_they_are(spoil, words, analysis, bar, core, fgmesh, tmp_path):
    made = analysis(bins=3)
    spoil(made, bar)
    with pytest.raises(core.InvalidInput, match=words):
        fgmesh.solve(made, tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.usefixtures("ccx")
def test_harmless_names_solve(analysis, bar, fgmesh):
    made = analysis(bins=3)
    made.Label = 'An "analysis", with *COMMAS and Größe'
    for number, constraint in enumerate(bar.constraints):
        constraint.Label = f"*INCLUDE, INPUT=secret.inp {number} {'x' * 200}"
    (result,) = fgmesh.solve(made)
    assert max(vector.x for vector in result.DisplacementVectors) == pytest.approx(0.42, rel=0.1)
