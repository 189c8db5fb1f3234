# SPDX-License-Identifier: GPL-3.0-or-later
"""Written meshes, read back by other programs: meshio, gmsh, FreeCAD, CalculiX."""
import subprocess

import meshio
import numpy as np
import pytest

from freecad.fgmesh import io, pictures


COUNTS = {"Solid": 1, "Face": 6, "Edge": 12}
"""Of the sample's parts."""


def volumes(points, tets):
    a, b, c = (points[tets[:, i]] - points[tets[:, 0]] for i in (1, 2, 3))
    return np.einsum("ij,ij->i", np.cross(a, b), c) / 6


def test_the_sample_is_a_cube(cube):
    assert volumes(cube.points, cube.tets).min() > 0
    assert volumes(cube.points, cube.tets).sum() == pytest.approx(8)
    a, b, c = (cube.points[cube.triangles[:, i]] for i in range(3))
    assert np.einsum("ij,ij->", np.cross(b - a, c - a), a) / 6 == pytest.approx(
        8
    )  # outward: divergence theorem


def test_vtu(cube, tmp_path):
    io.write_mesh(cube, tmp_path / "cube.vtu")
    mesh = meshio.read(tmp_path / "cube.vtu")
    assert np.array_equal(mesh.points, cube.points)
    assert [block.type for block in mesh.cells] == ["tetra", "triangle"]
    assert np.array_equal(mesh.cells[0].data, cube.tets)
    assert np.array_equal(mesh.cells[1].data, cube.triangles)
    assert np.allclose(mesh.point_data["fraction_1"], cube.points[:, 0] / 2)
    assert np.allclose(mesh.point_data["fraction_1"] + mesh.point_data["fraction_2"], 1)
    vertex, edge = mesh.point_data["vertex"], mesh.point_data["edge"]
    at_ends = (mesh.points != 1).sum(axis=1)  # 3 at vertices, 2 inside edges
    assert np.array_equal(vertex > 0, at_ends == 3) and np.array_equal(edge > 0, at_ends == 2)
    assert (vertex[26], edge[23]) == (8, 8)
    tets, triangles = mesh.cell_data["solid"]
    assert (tets == 1).all() and (triangles == 0).all()
    tets, triangles = mesh.cell_data["face"]
    assert (tets == 0).all() and sorted(set(triangles)) == [1, 2, 3, 4, 5, 6]
    # Every tetrahedron spans one small cube along x: half of the range of x/2.
    assert np.allclose(mesh.cell_data["variation"][0], 0.5)
    assert np.allclose(mesh.cell_data["dihedral_min"][0], 45)


def test_triangles_carry_the_values_of_their_tetrahedra(cube, tmp_path):
    cube.variation = np.arange(48.0)
    io.write_mesh(cube, tmp_path / "cube.vtu")
    behind = meshio.read(tmp_path / "cube.vtu").cell_data["variation"][1].astype(int)
    for triangle, tet in zip(cube.triangles, cube.tets[behind]):
        assert set(triangle) < set(tet)


def test_vtu_opens_in_vtk(cube, tmp_path):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    io.write_mesh(cube, tmp_path / "cube.vtu")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "cube.vtu"))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 27
    assert reader.GetOutput().GetNumberOfCells() == 48 + 48


def test_gmsh_groups(cube, tmp_path):
    io.write_mesh(cube, tmp_path / "cube.msh")
    # Old gmsh format, written by gmsh itself from what it understood.
    command = ["gmsh", "cube.msh", "-save", "-format", "msh22", "-o", "again.msh"]
    answer = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0 and "Error" not in answer.stdout + answer.stderr
    mesh = meshio.read(tmp_path / "again.msh")
    counts = {**COUNTS, "Vertex": 8}
    assert set(mesh.field_data) == {f"{word}{n}" for word, last in counts.items() for n in range(1, last + 1)}
    cells = mesh.cells_dict
    assert [len(cells[kind]) for kind in ("tetra", "triangle", "line", "vertex")] == [48, 48, 24, 8]
    assert volumes(mesh.points, cells["tetra"]).sum() == pytest.approx(8)

    def group(kind, name):
        physical = mesh.cell_data_dict["gmsh:physical"][kind]
        return mesh.points[cells[kind][physical == mesh.field_data[name][0]]]

    assert len(group("triangle", "Face2")) == 8 and (group("triangle", "Face2")[:, :, 0] == 2).all()
    assert group("line", "Edge8").tolist() == [[[2, 0, 2], [2, 1, 2]], [[2, 1, 2], [2, 2, 2]]]
    assert group("vertex", "Vertex8").tolist() == [[[2, 2, 2]]]


def test_parts_that_the_shape_has_not_give_no_group(cube, tmp_path):
    """Number 0: Edge8, along y at x = z = 2, and Vertex8 at its end."""
    cube.edge_edges[cube.edge_edges == 8] = 0
    cube.carriers[(cube.carriers == (1, 8)).all(axis=1), 1] = 0
    cube.carriers[(cube.carriers == (0, 8)).all(axis=1), 1] = 0
    for name in ("cube.vtu", "cube.msh", "cube.unv", "cube.inp"):
        io.write_mesh(cube, tmp_path / name)
    for name in ("cube.unv", "cube.inp"):
        text = (tmp_path / name).read_text()
        assert "Edge7" in text and "Vertex7" in text
        assert not any(f"{word}{number}" in text for word in ("Edge", "Vertex") for number in (0, 8))
    command = ["gmsh", "cube.msh", "-save", "-o", "again.msh"]
    answer = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert answer.returncode == 0 and not {"Error", "Warning"} & {
        *answer.stdout.split(),
        *answer.stderr.split(),
    }
    mesh = meshio.read(tmp_path / "cube.msh")
    assert len(mesh.points) == 27 and len(mesh.cells_dict["tetra"]) == 48
    assert len(mesh.cells_dict["line"]) == 22 and len(mesh.cells_dict["vertex"]) == 7
    assert not {"Edge0", "Edge8", "Vertex0", "Vertex8"} & set(mesh.field_data)
    data = meshio.read(tmp_path / "cube.vtu").point_data
    assert (data["vertex"][26], data["edge"][23]) == (0, 0)
    assert data["edge"][26] == 12  # of the edges that meet there, one that the shape has


def test_gmsh_has_triangles_in_the_groups_of_all_their_faces(cube, tmp_path):
    """Two triangles of Face1 lie on a Face7, too: meshio has sets, gmsh's old format each of them twice."""
    cube.coincident_faces = np.array([[0, 7], [1, 7]], np.int32)
    io.write_mesh(cube, tmp_path / "cube.msh")
    sets = meshio.read(tmp_path / "cube.msh").cell_sets
    sizes = {name: sum(map(len, sets[name])) for name in ("Face1", "Face2", "Face7")}
    assert sizes == {"Face1": 8, "Face2": 8, "Face7": 2}
    command = ["gmsh", "cube.msh", "-save", "-format", "msh22", "-o", "again.msh"]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=60).returncode == 0
    mesh = meshio.read(tmp_path / "again.msh")
    groups = mesh.cell_data_dict["gmsh:physical"]["triangle"]
    assert {name: (groups == mesh.field_data[name][0]).sum() for name in sizes} == sizes
    face = meshio.read(tmp_path / "cube.msh").cell_data_dict["face"]["triangle"]
    assert sorted(face.ravel().tolist()) == sorted(cube.triangle_faces.tolist())


def test_gmsh_keeps_fields(cube, tmp_path):
    io.write_mesh(cube, tmp_path / "cube.msh")
    mesh = meshio.read(tmp_path / "cube.msh")
    assert np.allclose(mesh.point_data["fraction_2"], 1 - mesh.points[:, 0] / 2)
    assert {"solid", "face", "variation", "dihedral_min"} <= set(mesh.cell_data)


def test_unv_in_freecad(cube, tmp_path):
    import FreeCAD  # noqa: F401
    import Fem

    io.write_mesh(cube, tmp_path / "cube.unv")
    mesh = Fem.read(str(tmp_path / "cube.unv"))
    assert (mesh.NodeCount, mesh.VolumeCount, mesh.FaceCount) == (27, 48, 48)
    points = np.array([tuple(mesh.Nodes[number]) for number in range(1, 28)])
    assert np.allclose(points, cube.points, atol=1e-14)
    # FreeCAD holds tetrahedra in the opposite sense and turns those of universal files on reading.
    tets = np.array([mesh.getElementNodes(number) for number in mesh.Volumes]) - 1
    assert volumes(points, tets).max() < 0 and volumes(points, tets).sum() == pytest.approx(-8)
    groups = {
        mesh.getGroupName(g): (mesh.getGroupElementType(g), mesh.getGroupElements(g)) for g in mesh.Groups
    }
    assert set(groups) == {
        *(
            f"{word}{n}{tail}"
            for word, last in COUNTS.items()
            for n in range(1, last + 1)
            for tail in ("", "_Nodes")
        ),
        *(f"Vertex{n}_Nodes" for n in range(1, 9)),
    }
    # Edge8: along y at x = z = 2.
    kind, edges = groups["Edge8"]
    assert kind == "Edge" and [mesh.getElementNodes(number) for number in edges] == [(21, 24), (24, 27)]
    assert groups["Edge8_Nodes"] == ("Node", (21, 24, 27)) and groups["Vertex8_Nodes"] == ("Node", (27,))
    assert groups["Solid1"][0] == "Volume" and set(groups["Solid1"][1]) == set(mesh.Volumes)
    kind, triangles = groups["Face4"]
    corners = np.array([mesh.getElementNodes(number) for number in triangles]) - 1
    assert kind == "Face" and len(triangles) == 8 and (points[corners][:, :, 1] == 2).all()
    kind, nodes = groups["Face4_Nodes"]
    assert kind == "Node" and sorted(nodes) == list(np.flatnonzero(points[:, 1] == 2) + 1)


def test_unv_of_coordinates_of_any_size(cube, tmp_path):
    import FreeCAD  # noqa: F401
    import Fem

    cube.points = cube.points * [1e-9, 1e7, 1] - [0, 0, 123456.789012345]
    io.write_mesh(cube, tmp_path / "cube.unv")
    nodes = Fem.read(str(tmp_path / "cube.unv")).Nodes
    assert np.allclose([tuple(nodes[number]) for number in range(1, 28)], cube.points, rtol=1e-15, atol=0)


@pytest.fixture(params=["cube", "cube10"])
def any_cube(request):
    return request.getfixturevalue(request.param)


def calculix(folder, deck):
    """Run a deck, given as text, in `folder`; gives the lines of what it prints into its .dat file."""
    (folder / "deck.inp").write_text(deck)
    answer = subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True, text=True, timeout=60)
    assert "Job finished" in answer.stdout and "nonpositive" not in answer.stdout, answer.stdout[-2000:]
    return (folder / "deck.dat").read_text().splitlines()


MATERIAL = "*MATERIAL, NAME=Steel\n*ELASTIC\n1000., 0.25\n*SOLID SECTION, ELSET=Solid1, MATERIAL=Steel\n"


@pytest.mark.usefixtures("ccx")
def test_inp_in_calculix(any_cube, tmp_path):
    """A bar under tension: u_x = s x / E, u_y = -nu s y / E, which tetrahedra give exactly."""
    io.write_mesh(any_cube, tmp_path / "cube.inp")
    lines = calculix(
        tmp_path,
        f"*INCLUDE, INPUT=cube.inp\n{MATERIAL}*BOUNDARY\nFace1, 1\nFace3, 2\nFace5, 3\n"
        "*STEP\n*STATIC\n*DLOAD\nFace2, P, -100.\n*NODE PRINT, NSET=Face2\nU\n*END STEP\n",
    )
    rows = [line.split() for line in lines]
    moved = {
        int(row[0]): [float(word) for word in row[1:]] for row in rows if len(row) == 4 and row[0].isdigit()
    }
    assert sorted(moved) == list(np.flatnonzero(any_cube.points[:, 0] == 2) + 1)
    for number, (u, v, w) in moved.items():
        _, y, z = any_cube.points[number - 1]
        assert u == pytest.approx(0.2, rel=1e-5)
        assert v == pytest.approx(-0.025 * y, abs=1e-7) and w == pytest.approx(-0.025 * z, abs=1e-7)


def test_inp_in_meshio(cube, tmp_path):
    io.write_mesh(cube, tmp_path / "cube.inp")
    mesh = meshio.read(tmp_path / "cube.inp")
    sets = mesh.point_sets
    assert sorted(sets["Edge8"]) == [20, 23, 26] and list(sets["Vertex8"]) == [26]
    assert len([name for name in sets if name.startswith(("Edge", "Vertex"))]) == 12 + 8
    assert np.array_equal(mesh.points, cube.points)
    assert np.array_equal(mesh.cells_dict["tetra"], cube.tets) and len(mesh.cells) == 1


def test_ten_nodes_in_vtu_and_inp(bent_cube10, tmp_path):
    for name in ("cube.vtu", "cube.inp"):
        io.write_mesh(bent_cube10, tmp_path / name)
        mesh = meshio.read(tmp_path / name)
        assert np.array_equal(mesh.points, bent_cube10.points)
        assert np.array_equal(mesh.cells_dict["tetra10"], bent_cube10.tets)
    mesh = meshio.read(tmp_path / "cube.vtu")
    assert [block.type for block in mesh.cells] == ["tetra10", "triangle6"]
    assert np.array_equal(mesh.cells[1].data, bent_cube10.triangles)
    assert np.allclose(mesh.point_data["fraction_1"], mesh.points[:, 0] / 2)
    assert np.allclose(mesh.cell_data["variation"], 0.5)


def test_ten_nodes_in_vtk(bent_cube10, tmp_path):
    """VTK's own shape functions put the middle of each tetrahedron where the bending map does."""
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.vtkCommonCore import reference

    io.write_mesh(bent_cube10, tmp_path / "cube.vtu")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "cube.vtu"))
    reader.Update()
    grid = reader.GetOutput()
    assert [grid.GetCellType(i) for i in (0, 48)] == [24, 22]  # VTK_QUADRATIC_TETRA, VTK_QUADRATIC_TRIANGLE
    for i, tet in enumerate(bent_cube10.tets):
        middle, weights = [0.0] * 3, [0.0] * 10
        grid.GetCell(i).EvaluateLocation(reference(0), [0.25] * 3, middle, weights)
        x, y, z = bent_cube10.points[tet[:4]].T
        expected = (x.mean(), y.mean(), (z - x**2 / 8).mean() + x.mean() ** 2 / 8)
        assert middle == pytest.approx(expected, abs=1e-14)


def test_pictures_show_the_corners_of_ten_nodes(bent_cube10, tmp_path):
    io.write_mesh(bent_cube10, tmp_path / "cube.vtu")
    points, tets, fraction = pictures.read_tets(tmp_path / "cube.vtu")
    assert np.array_equal(tets, bent_cube10.tets[:, :4])
    assert len(points) == len(fraction) == 125


def test_ten_nodes_in_gmsh(bent_cube10, least_jacobian, tmp_path):
    io.write_mesh(bent_cube10, tmp_path / "cube.msh")
    # Six times the volume of each tetrahedron, everywhere in it: the bending keeps volumes.
    assert least_jacobian(tmp_path / "cube.msh") == pytest.approx(1)
    bent_cube10.tets = bent_cube10.tets[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
    io.write_mesh(bent_cube10, tmp_path / "cube.msh")
    assert least_jacobian(tmp_path / "cube.msh") < 0.9


def test_ten_nodes_of_unv_in_freecad(bent_cube10, tmp_path):
    import FreeCAD  # noqa: F401
    import Fem

    io.write_mesh(bent_cube10, tmp_path / "cube.unv")
    mesh = Fem.read(str(tmp_path / "cube.unv"))
    assert (mesh.NodeCount, mesh.TetraCount, mesh.TriangleCount) == (125, 48, 48)
    # FreeCAD turns tetrahedra over; each middle node must still be the one between its corners.
    tets = np.array([mesh.getElementNodes(number) for number in mesh.Volumes]) - 1
    assert np.array_equal(tets, bent_cube10.tets[:, [0, 2, 1, 3, 6, 5, 4, 7, 9, 8]])
    triangles = np.array([mesh.getElementNodes(number) for number in mesh.Faces]) - 1
    assert np.array_equal(triangles, bent_cube10.triangles)
    assert mesh.Volume.Value == pytest.approx(8)
    edges = np.array([mesh.getElementNodes(number) for number in mesh.Edges]) - 1
    assert np.array_equal(edges, bent_cube10.edges)
    nodes = {mesh.getGroupName(g): mesh.getGroupElements(g) for g in mesh.Groups}["Face2_Nodes"]
    assert sorted(nodes) == list(np.flatnonzero(bent_cube10.points[:, 0] == 2) + 1) and len(nodes) == 25


@pytest.mark.usefixtures("ccx")
def test_ten_nodes_in_calculix(bent_cube10, tmp_path):
    io.write_mesh(bent_cube10, tmp_path / "cube.inp")
    lines = calculix(
        tmp_path,
        f"*INCLUDE, INPUT=cube.inp\n{MATERIAL}*BOUNDARY\nFace1, 1, 3\n"
        "*STEP\n*STATIC\n*DLOAD\nFace2, P, -100.\n*EL PRINT, ELSET=Solid1, TOTALS=ONLY\nEVOL\n*END STEP\n",
    )
    assert float(lines[-1]) == pytest.approx(8)


def test_inp_refuses_a_triangle_inside_no_tetrahedron(cube, tmp_path):
    cube.triangles[0] = (0, 13, 26)
    with pytest.raises(ValueError, match="no tetrahedron"):
        io.write_mesh(cube, tmp_path / "cube.inp")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["mesh.stl", "mesh", "vtu", "mesh.vtu.gz"])
def test_unknown_extension(cube, tmp_path, name):
    with pytest.raises(io.OutputError, match="vtu"):
        io.write_mesh(cube, tmp_path / name)
    assert list(tmp_path.iterdir()) == []
