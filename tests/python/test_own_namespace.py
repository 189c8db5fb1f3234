# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line and its child process import no other package called `freecad`, as Debian 13 has one."""
import os
import subprocess
import sys


def test_another_freecad_package_is_left_alone(fgmesh, shapes, tmp_path):
    other = tmp_path / "other" / "freecad"
    other.mkdir(parents=True)
    (other / "__init__.py").write_text("print('loaded'); raise SystemExit(7)\n")
    environment = {**os.environ, "PYTHONPATH": str(other.parent)}
    imported = subprocess.run([sys.executable, "-P", "-c", "import freecad"], env=environment)
    assert imported.returncode == 7
    done = fgmesh(shapes / "box.brep", "--fraction", "x/10", "--quiet", "-o", "box.vtu", env=environment)
    assert (done.returncode, done.stderr) == (0, "")
    assert "loaded" not in done.stdout
    assert (tmp_path / "box.vtu").exists()
