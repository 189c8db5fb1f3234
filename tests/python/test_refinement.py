# SPDX-License-Identifier: GPL-3.0-or-later
"""The refinement as its options, and what no refinement mends, make it: the paper's own loop, numbers of threads,
jumps, steep layers. Lengths in mm."""
import numpy as np
import pytest

from freecad.fgmesh import core


def test_paper_never_moves_vertices_of_the_material_stage(brep, meshed):
    options = {"material_threshold": 0.15, "surface_deviation": 0.02, "paper": True}
    # The certificate may add vertices to what is the last stage.
    before = meshed("cylinder", "(z/12)^2", **options, stop_after="material", certify=False)
    after = meshed("cylinder", "(z/12)^2", **options)
    assert before.status == "ok" and len(after.points) > len(before.points)
    assert set(map(tuple, before.points)) <= set(map(tuple, after.points))


def test_departures_from_the_paper_save_elements(meshed):
    options = {"material_threshold": 0.15, "stop_after": "material"}
    departed = meshed("cylinder", "(z/12)^2", **options)
    paper = meshed("cylinder", "(z/12)^2", **options, paper=True)
    assert len(departed.tets) < 0.7 * len(paper.tets)
    assert departed.dihedral_min.min() > paper.dihedral_min.min()


@pytest.mark.parametrize("count", [1, 2])
def test_number_of_threads_is_told_and_does_not_matter(brep, count):
    # Fine enough to be worked on in parts.
    options = {"material_threshold": 0.035, "stop_after": "material"}
    material = core.Material(["exp(-0.1*d)"])
    result = core.generate_mesh(brep("ball"), material, core.MeshingOptions(**options, threads=count))
    assert len(result.points) > 8192
    assert result.threads <= count
    again = core.generate_mesh(brep("ball"), material, core.MeshingOptions(**options))
    for name in ("points", "tets", "triangles", "fractions"):
        assert getattr(result, name).tobytes() == getattr(again, name).tobytes()


def test_layer_steeper_than_min_size_is_followed_only_as_far_as_that(meshed):
    # 0.05 mm thick; elements of 0.5 mm cannot follow it.
    result = meshed("box", "0.5 + 0.5*tanh((y-10)/0.05)", min_size=0.5, certify=False)
    assert result.status == "threshold_not_met"
    places = result.points[result.tets[result.above_threshold]][..., 1]
    assert places.min(axis=1).max() <= 10.2 and places.max(axis=1).min() >= 9.8
    layer = 10 * 5 * 3 * 0.5  # mm^3: three elements on either side, of the size that is allowed
    assert len(result.tets) < 3000 + 8.5 * layer / 0.5**3


def edge_lengths(result):
    edges = np.concatenate([result.tets[:, [i, j]] for i in range(4) for j in range(i)])
    return np.linalg.norm(result.points[edges[:, 0]] - result.points[edges[:, 1]], axis=1)


@pytest.mark.parametrize("anisotropy", [1, 3])
@pytest.mark.parametrize(
    "shape, formula, sizes",
    [
        ("box", "0.5 + 0.5*tanh((y-10)/0.05)", {"min_size": 0.5}),
        ("box", "0.5 + 0.5*tanh((y-10)/0.3)", {"min_size": 0.2, "max_size": 1.5}),
        ("ball", "exp(-0.1*d)", {"max_size": 4.0}),
        ("cylinder", "(z/12)^2", {"min_size": 0.4, "max_size": 2.0}),
    ],
)
def test_no_edge_is_shorter_or_longer_than_allowed(meshed, shape, formula, sizes, anisotropy):
    result = meshed(shape, formula, **sizes, anisotropy=anisotropy)
    lengths = edge_lengths(result)
    assert lengths.min() >= sizes.get("min_size", 0)
    assert lengths.max() <= sizes.get("max_size", np.inf)


def test_jump_on_a_slope_costs_no_elements(meshed):
    slope = meshed("box", "y/40")
    jump = meshed("box", "y/40 + 0.5*step(10.3,y)")
    assert jump.status == "threshold_not_met"
    places = jump.points[jump.tets[jump.above_threshold]][..., 1]
    assert np.all((places.min(axis=1) <= 10.3) & (places.max(axis=1) >= 10.3))
    assert len(jump.tets) < 1.5 * len(slope.tets)
    assert jump.dihedral_min.min() > 10
