# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with fractions and properties, and decks, as files that other programs read."""
import itertools
import re
import subprocess

import meshio
import numpy as np
import pytest


@pytest.fixture
def export_properties(fgmesh):
    from freecad.fgmesh.fem.export import export_properties

    return export_properties


@pytest.mark.parametrize("second_order", [False, True])
@pytest.mark.parametrize("extension", ["vtu", "msh"])
def test_files_for_other_programs(extension, second_order, bar, fgmesh, tmp_path, export_properties):
    """Read by meshio; .msh by gmsh itself, too, which gives back as many tetrahedra."""
    if second_order:
        bar.mesh.SecondOrder = True
        fgmesh.generate(bar.mesh)
    path = tmp_path / f"bar.{extension}"
    export_properties(bar.mesh, path, {"YoungsModulus": "voigt"})
    read = meshio.read(path)
    (tets,) = (block.data for block in read.cells if block.type.startswith("tetra"))
    assert tets.shape == (bar.mesh.TetCount, 10 if second_order else 4)
    exact = 1000 * np.exp(np.log(8) * read.points[:, 0] / 10)
    assert read.point_data["YoungsModulus (MPa)"].ravel() == pytest.approx(exact, rel=1e-6)
    assert read.point_data["fraction_1"].ravel() == pytest.approx((exact / 1000 - 1) / 7, abs=1e-6)
    centres = read.points[tets[:, :4]].mean(axis=1)[:, 0]
    in_tets = read.cell_data["YoungsModulus (MPa)"][0].ravel()
    assert in_tets == pytest.approx(1000 * np.exp(np.log(8) * centres / 10), rel=0.03)
    assert (np.ravel(read.cell_data["solid"][0]) == 1).all()
    if extension == "msh":
        said = subprocess.run(
            ["gmsh", str(path), "-0", "-o", str(tmp_path / "again.msh")], capture_output=True, text=True
        )
        assert said.returncode == 0 and "Error" not in said.stdout + said.stderr
        again = meshio.read(tmp_path / "again.msh")
        assert (
            sum(len(block.data) for block in again.cells if block.type.startswith("tetra"))
            == bar.mesh.TetCount
        )


@pytest.mark.parametrize("second_order", [False, True])
def test_models_for_decks(second_order, bar, fgmesh, tmp_path, export_properties):
    """The .inp is read by meshio, and CalculiX solves the deck that it is completed to; its bins are within the allowed
    error, and the fractions stand in the fields of Abaqus."""
    if second_order:
        bar.mesh.SecondOrder = True
        fgmesh.generate(bar.mesh)
    path = tmp_path / "bar.inp"
    export_properties(bar.mesh, path, allowed_error=0.01)
    read = meshio.read(path)
    (tets,) = (block.data for block in read.cells if block.type.startswith("tetra"))
    assert tets.shape == (bar.mesh.TetCount, 10 if second_order else 4)
    fields = np.loadtxt(tmp_path / "bar_fractions.inp", delimiter=",", comments=["**", "*"])
    assert len(fields) == 2 * bar.mesh.PointCount
    assert fields[: bar.mesh.PointCount, 1] == pytest.approx(
        np.expm1(np.log(8) * read.points[:, 0] / 10) / 7, abs=1e-9
    )

    # The mean of E over each tetrahedron, by many points.
    steps = np.array([p for p in itertools.product(range(9), repeat=4) if sum(p) == 8])
    x = read.points[tets[:, :4], 0] @ ((steps + 0.5) / 10).T
    means = (1000 * np.exp(np.log(8) * x / 10)).mean(axis=1)
    text = path.read_text()
    moduli = dict(re.findall(r"\*MATERIAL, NAME=(Bin\d+)\n\*ELASTIC\n([^,]+),", text))
    seen = 0
    for name, modulus in moduli.items():
        (members,) = re.findall(rf"\*ELSET, ELSET={name}\n([\d,\s]+)", text)
        members = np.array(members.replace("\n", " ").replace(",", " ").split(), int) - 1
        assert means[members] == pytest.approx(float(modulus), rel=0.011)
        seen += len(members)
    assert seen == bar.mesh.TetCount

    held, pulled = (np.flatnonzero(np.abs(read.points[:, 0] - x) < 1e-9) + 1 for x in (0, 10))
    step = ["*BOUNDARY", *(f"{node}, 1, 3" for node in held), "*STEP", "*STATIC", "*BOUNDARY"]
    step += [*(f"{node}, 1, 1, 0.1" for node in pulled), "*NODE PRINT, NSET=Held, TOTALS=ONLY", "RF"]
    sets = ["*NSET, NSET=Held", *(f"{node}," for node in held)]
    (tmp_path / "deck.inp").write_text("\n".join(["*INCLUDE, INPUT=bar.inp", *sets, *step, "*END STEP", ""]))
    run = subprocess.run(["ccx", "-i", "deck"], cwd=tmp_path, capture_output=True, text=True)
    assert "*ERROR" not in run.stdout and "*WARNING" not in run.stdout
    force = float((tmp_path / "deck.dat").read_text().split()[-3])
    # A bar of springs in a row: F = u A / integral of dx/E, A = 4 mm^2.
    assert -force == pytest.approx(0.1 * 4 / (10 / 1000 * (1 - 1 / 8) / np.log(8)), rel=0.03)


def test_decks_are_read_by_another_program(analysis, bar, tmp_path):
    """meshio finds the nodes, the elements and the elements of each material in the deck for CalculiX."""
    from freecad.fgmesh.fem.solving import write_deck

    deck = write_deck(analysis(bins=5), tmp_path)
    read = meshio.read(deck)
    (block,) = (block for block in read.cells if block.type == "tetra")
    assert len(read.points) == bar.mesh.PointCount and len(block.data) == bar.mesh.TetCount
    members = [
        values[0] for name, values in read.cell_sets.items() if name.upper().startswith("GRADEDMATERIAL_BIN")
    ]
    assert sorted(np.concatenate(members)) == list(range(bar.mesh.TetCount))


def test_freecad_itself_writes_med_with_the_bins(analysis, bar, tmp_path):
    import Fem

    made = analysis(bins=5)
    bar.mesh.FemMesh.write(str(tmp_path / "bar.med"))
    read = Fem.read(str(tmp_path / "bar.med"))
    assert read.VolumeCount == bar.mesh.TetCount
    names = {read.getGroupName(group) for group in read.Groups}
    bins = {f"{one.Name}_Elements" for one in made.Group if "_Bin" in one.Name}
    assert len(bins) == 5 and bins | {"Solid1", "Face1"} <= names


def test_files_of_no_known_kind(bar, tmp_path, core, export_properties):
    with pytest.raises(core.InvalidInput, match=".vtu, .msh, .inp"):
        export_properties(bar.mesh, tmp_path / "bar.stl")
    with pytest.raises(core.InvalidInput, match="FreeCAD exports the mesh object"):
        export_properties(bar.mesh, tmp_path / "bar.med")
    assert not list(tmp_path.iterdir())
