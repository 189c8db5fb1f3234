# SPDX-License-Identifier: GPL-3.0-or-later
"""The thermal conductivity of isotropic mixtures with spherical grains."""
import numpy as np

from freecad.fgmesh.mixing import comparison


def conductivity(law, fractions, parts):
    """That (n,) of the mixture by one of the Laws below; fractions (n, k), parts: those (k,) of the constituents.

    The medium around the grains counts twice. It is the worst or best conductor (Hashin and Shtrikman, J. Appl.
    Phys. 33 (1962) 3125), the matrix (Maxwell, A Treatise on Electricity and Magnetism (1873), which
    is Mori and Tanaka's idea), or the mixture itself (Bruggeman, Ann. Phys. 416 (1935) 636).
    """

    def answer(medium):
        return comparison.mean(fractions, parts, 2 * medium)

    if law.name == "self_consistent":
        return comparison.matching(answer, comparison.mean(fractions, parts, 0), fractions @ parts)
    if law.name == "mori_tanaka":
        return answer(parts[law.matrix])
    return answer(np.min(parts) if law.name == "hashin_shtrikman_lower" else np.max(parts))
