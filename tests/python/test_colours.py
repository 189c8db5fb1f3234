# SPDX-License-Identifier: GPL-3.0-or-later
"""The scale of colours: viridis without its dark end, with marks for what is outside it."""
import subprocess
import sys

import numpy as np
import pytest


@pytest.fixture
def colours(build_dir):
    from freecad.fgmesh import colours

    return colours


def test_scale_is_viridis(colours):
    import matplotlib

    wanted = matplotlib.colormaps["viridis"](np.linspace(0.12, 1, 256))[:, :3]
    assert colours.table().shape == (256, 3)
    assert np.abs(colours.table() - wanted).max() < 3 / 255


def test_lightness_rises_evenly(colours):
    lightness = colours.table() @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(lightness) > 0).all()


def test_range_takes_the_whole_scale(colours):
    table = colours.table()
    assert (colours.rgb([2, 3, 4], 2, 4) == table[[0, 128, 255]]).all()


def test_marks(colours):
    values = [np.nan, -0.01, 0, 1, 1.01, -np.inf, np.inf]
    wanted = [
        colours.UNDEFINED,
        colours.BELOW,
        colours.table()[0],
        colours.table()[-1],
        colours.ABOVE,
        colours.BELOW,
        colours.ABOVE,
    ]
    assert (colours.rgb(values) == np.array(wanted)).all()


@pytest.mark.parametrize("name", ["UNDEFINED", "BELOW", "ABOVE"])
def test_marks_are_no_colours_of_the_scale(colours, name):
    mark = np.array(getattr(colours, name))
    assert np.abs(colours.table() - mark).max(axis=1).min() > 0.15


def test_rounding_is_not_marked(colours):
    assert (colours.rgb([-1e-9, 1 + 1e-9]) == colours.table()[[0, -1]]).all()


def test_range_of_one_value(colours):
    found = colours.rgb([0.3, 0.2, 0.4, np.nan], 0.3, 0.3)
    assert (found[0] == colours.table()[128]).all()
    assert (found[1:] == np.array([colours.BELOW, colours.ABOVE, colours.UNDEFINED])).all()


def test_table_cannot_be_changed(colours):
    with pytest.raises(ValueError):
        colours.table()[0] = 0


def test_nothing_heavy_is_imported(own_namespace):
    script = (
        f"{own_namespace}import sys\n"
        "from freecad.fgmesh import colours\nassert 'numpy' not in sys.modules\n"
        "colours.rgb([0.5])\nassert 'matplotlib' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-P", "-c", script], check=True)
