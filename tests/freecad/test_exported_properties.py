# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with fractions and properties, and decks, as files that other programs read."""
import itertools
import re
import subprocess

import FreeCAD
import meshio
import numpy as np
import pytest


@pytest.fixture
def export_properties(fgmesh):
    from freecad.fgmesh.fem.export import export_properties

    return export_properties


@pytest.mark.parametrize("second_order", [False, True])
@pytest.mark.parametrize("extension", ["vtu", "msh", "xdmf"])
def test_files_for_other_programs(extension, second_order, bar, fgmesh, tmp_path, export_properties):
    """Read by meshio; .msh by gmsh itself, too, which gives back as many tetrahedra and all names."""
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
    facets = meshio.read(tmp_path / "bar_facets.xdmf") if extension == "xdmf" else read
    assert_facets_lie_on_their_faces(facets, bar.shape)
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
        assert set(again.field_data) == set(read.field_data) == set(NAMES)
        assert again.cell_data_dict["gmsh:physical"].keys() >= {
            "tetra10",
            "triangle6",
            "line3",
            "vertex",
        } or (not second_order)


NAMES = [
    "Solid1",
    *(f"{word}{n}" for word, last in (("Face", 6), ("Edge", 12), ("Vertex", 8)) for n in range(1, last + 1)),
]
"""Of the parts of a box."""


def assert_facets_lie_on_their_faces(read, box):
    """And cover them; they carry the properties of the tetrahedra behind them."""
    areas = dict.fromkeys(range(1, 7), 0.0)
    for block, faces, moduli in zip(
        read.cells, read.cell_data["face"], read.cell_data["YoungsModulus (MPa)"]
    ):
        if block.type.startswith("triangle"):
            corners = read.points[block.data[:, :3]]
            doubled = np.linalg.norm(np.cross(*(corners[:, i] - corners[:, 0] for i in (1, 2))), axis=1)
            for face, area, middle in zip(np.ravel(faces).astype(int), doubled / 2, corners.mean(axis=1)):
                areas[face] += area
                assert box.Faces[face - 1].isInside(FreeCAD.Vector(*middle), 1e-6, True)
            assert (
                np.abs(np.log(np.ravel(moduli) / 1000 / 8 ** (corners[..., 0].mean(axis=1) / 10))).max() < 0.3
            )
    assert list(areas.values()) == pytest.approx([face.Area for face in box.Faces])


@pytest.mark.usefixtures("ccx")
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

    middles = [tuple(face.CenterOfMass) for face in bar.shape.Faces]
    held, pulled = (
        f"Face{1 + np.abs(np.subtract(middles, (x, 0, 0))).max(axis=1).argmin()}" for x in (0, 10)
    )
    step = (
        f"*BOUNDARY\n{held}, 1, 3\n*STEP\n*STATIC\n*DSLOAD\n{pulled}, P, -8.\n*NODE PRINT, NSET={pulled}\nU\n"
    )
    (tmp_path / "deck.inp").write_text(f"*INCLUDE, INPUT=bar.inp\n{step}*END STEP\n")
    run = subprocess.run(["ccx", "-i", "deck"], cwd=tmp_path, capture_output=True, text=True)
    assert "*ERROR" not in run.stdout and "*WARNING" not in run.stdout
    # Heads of tables differ from release to release of CalculiX.
    rows = [line.split() for line in (tmp_path / "deck.dat").read_text().splitlines()]
    moved = np.array([float(row[1]) for row in rows if len(row) == 4 and row[0].isdigit()])
    assert len(moved) > 0
    # A bar of springs in a row: u = s integral of dx/E.
    assert moved == pytest.approx(8 * 10 / 1000 * (1 - 1 / 8) / np.log(8), rel=0.03)


def test_the_command_line_and_the_export_write_the_same_mesh(bar, fgmesh, tmp_path, export_properties):
    """Up to the materials: with the same sets and surfaces, under the same names."""
    from freecad.fgmesh import io

    bar.mesh.SecondOrder = True
    io.write_mesh(fgmesh.generate(bar.mesh), tmp_path / "mesh.inp")
    export_properties(bar.mesh, tmp_path / "bar.inp")
    mesh = (tmp_path / "mesh.inp").read_text()
    assert (tmp_path / "bar.inp").read_text().startswith(mesh)
    assert re.findall(r"\*NSET, NSET=(.*)", mesh) == NAMES
    assert re.findall(r"\*SURFACE, NAME=(.*), TYPE=ELEMENT", mesh) == [n for n in NAMES if "Face" in n]
    assert re.findall(r"\*ELSET, ELSET=(.*)", mesh) == ["Solid1"]


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
    with pytest.raises(core.InvalidInput, match=".vtu, .msh, .xdmf, .inp"):
        export_properties(bar.mesh, tmp_path / "bar.stl")
    with pytest.raises(core.InvalidInput, match="FreeCAD exports the mesh object"):
        export_properties(bar.mesh, tmp_path / "bar.med")
    assert not list(tmp_path.iterdir())
