# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents made by one FreeCAD are alive in another: material, mesh and analysis.

Runs where other releases of Debian are installed, and built in, by scripts/test-on: FGMESH_ROOTS names their folder.
"""
import itertools
import json
import os
import subprocess
from pathlib import Path

import pytest

HERE = "here"
ROOTS = os.environ.get("FGMESH_ROOTS", "")
RELEASES = [HERE] + [name for name in ("trixie", "forky") if ROOTS and (Path(ROOTS) / name).is_dir()]

pytestmark = pytest.mark.skipif(
    len(RELEASES) == 1, reason="FGMESH_ROOTS names no folder with roots of other releases (scripts/test-on)"
)


@pytest.fixture
def exchange(source_dir, tmp_path, freecad_home):
    """A function: has the FreeCAD of a release "make" documents or "look" at them; gives what it says."""

    def run(release, what, path):
        home, answer = tmp_path / f"home-{release}", tmp_path / "answer.json"
        answer.unlink(missing_ok=True)
        home.mkdir(exist_ok=True)
        if release == HERE:
            freecad_home(home)
            command = []
        else:
            built = next((Path(ROOTS) / release / "build").glob("**/Mod/FGMesh"))
            link = home / ".local" / "share" / "FreeCAD" / "Mod" / "FGMesh"
            link.parent.mkdir(parents=True, exist_ok=True)
            link.unlink(missing_ok=True)
            link.symlink_to("/" / built.relative_to(Path(ROOTS) / release))
            command = [str(source_dir / "scripts" / "in-debian"), release]
        given = {"HOME": home, "FGMESH_EXCHANGE": what, "FGMESH_DOCUMENT": path, "FGMESH_ANSWER": answer}
        command += ["env", *(f"{name}={value}" for name, value in given.items()), "freecadcmd"]
        done = subprocess.run(
            [*command, str(source_dir / "tests" / "freecad" / "exchanged.py")],
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert answer.exists(), done.stdout[-2000:] + done.stderr[-2000:]
        said = json.loads(answer.read_text())
        assert "error" not in said, said["error"]
        return said

    return run


@pytest.mark.parametrize("maker", RELEASES)
def test_documents_live_in_every_other_freecad(maker, exchange, tmp_path):
    path = tmp_path / "exchanged"
    exchange(maker, "make", path)
    seen = {release: exchange(release, "look", path) for release in RELEASES}
    for release, mode in itertools.product(RELEASES, ("bins", "continuous")):
        there, kept = seen[release][mode], seen[release][mode]["kept"]
        assert (kept["status"], kept["materials"]) == ("ok", "ok"), (release, mode)
        assert kept["tets"][0] == kept["tets"][1] > 0
        assert kept["bins"] == (8 if mode == "bins" else 1)
        assert kept["modulus"] == pytest.approx(seen[maker][mode]["kept"]["modulus"], rel=1e-9)
        assert kept["deck"] == ([8, 0, True] if mode == "bins" else [1, 1, True]), (release, mode)
        assert there["changed"].startswith("out of date: MaterialThreshold"), (release, mode)
        assert there["again"] == {"status": "ok", "materials": "ok", "tets": kept["tets"]}, (release, mode)
