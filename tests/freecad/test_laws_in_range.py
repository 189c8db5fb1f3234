# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing laws count where the mesh has fractions, and nowhere else: they need no meaning for others."""
import exact_problems
import meshio
import numpy as np
import Part
import pytest

LENGTH = 40.0


@pytest.fixture
def prism(document, fgmesh):
    """A function: the meshed Bench of a prism of 10 x 10 x 40 mm under 1 MPa along z, E0 = 3500 MPa, nu = 0, whose
    fraction goes from `low` to `high` along z."""

    def make(low, high, **options):
        shape = Part.makeBox(10, 10, LENGTH)
        formula = f"{low} + {high - low}*z/{LENGTH}"
        bench = exact_problems.Bench(document, fgmesh, shape, formula, (3500.0, 100.0), 0.0, **options)
        bench.constrain("Pressure", [("Face", (5, 5, LENGTH))], Pressure="1 MPa", Reversed=True)
        bench.hold("xyz", ("Face", (5, 5, 0)))
        fgmesh.generate(bench.mesh)
        return bench

    return make


def solved(bench, fgmesh, **options):
    analysis = fgmesh.make_analysis(bench.mesh, mixing={"YoungsModulus": "p1*v1^2"}, **options)
    analysis.addObjects([one for one in bench.constraints if one not in analysis.Group])
    bench.document.recompute()
    (result,) = fgmesh.solve(analysis)
    return result, max(vector.z for vector in result.DisplacementVectors)


@pytest.mark.usefixtures("ccx")
def test_a_law_that_is_0_without_the_first_constituent(prism, fgmesh):
    """u = s L/E0 * integral of 1/v^2 = 40/3500/0.6*(1/0.2 - 1/0.8) mm."""
    bench = prism(0.2, 0.8, MaxSize=5, MaterialThreshold=0.1, SecondOrder=True)
    _, moved = solved(bench, fgmesh, mode="continuous")
    assert moved == pytest.approx(0.0714286, rel=2e-4)


@pytest.mark.usefixtures("ccx")
def test_a_uniform_fraction(prism, fgmesh):
    """A table of one row: E = E0/4 everywhere."""
    _, moved = solved(prism(0.5, 0.5, MaxSize=10), fgmesh, mode="continuous")
    assert moved == pytest.approx(LENGTH / 3500 * 4, rel=1e-6)


@pytest.mark.usefixtures("ccx")
def test_nodes_where_a_law_has_no_meaning(prism, fgmesh, core, tmp_path):
    """On the face z = 0 there is no first constituent, and so no modulus. Elements have some of it, which is enough for
    bins; at nodes of that face fields show what the law gives, 0. The continuous mode needs a modulus there.
    """
    from freecad.fgmesh.fem.export import export_properties

    bench = prism(0.0, 1.0, MaterialThreshold=0.2)
    result, moved = solved(bench, fgmesh, bins=10)
    analysis = result.getParentGroup()
    assert 0 < moved and analysis is not None
    laws = {"YoungsModulus": "p1*v1^2"}
    for name in ("prism.vtu", "prism.inp"):
        export_properties(bench.mesh, tmp_path / name, laws)
    read = meshio.read(tmp_path / "prism.vtu")
    shown = read.point_data["YoungsModulus (MPa)"].ravel()
    assert shown == pytest.approx(3500 * (read.points[:, 2] / LENGTH) ** 2, abs=1e-9)
    assert (np.concatenate(read.cell_data["YoungsModulus (MPa)"]) > 0).all()
    with pytest.raises(core.InvalidInput, match="gives 0 where v1 = 0"):
        fgmesh.make_analysis(bench.mesh, mode="continuous", mixing=laws, analysis=analysis)
