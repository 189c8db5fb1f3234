# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by the scripts of this folder; sourced, not run.
set -euo pipefail

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
BUILD=${FGMESH_BUILD:-$ROOT/build}
# The Python that FreeCAD runs; another python3 may come first on PATH.
PYTHON=/usr/bin/python3

# One compiler of CGAL's templates takes up to 2 GB.
job_count() {
  local cores memory_gb fitting
  cores=$(nproc)
  memory_gb=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo)
  fitting=$((memory_gb / 2))
  echo $((fitting < 1 ? 1 : fitting < cores ? fitting : cores))
}

say() { printf '== %s\n' "$*" >&2; }
