# SPDX-License-Identifier: GPL-3.0-or-later
"""Material cards, fractions and moduli for the tests of mixing laws, and the laws' values in one call."""
import numpy as np

from freecad.fgmesh import mixing

CARDS = {
    "YoungsModulus": (70000.0, 380000.0, 110000.0, 205000.0),
    "PoissonRatio": (0.33, 0.22, 0.35, 0.29),
    "Density": (2.7e-9, 3.9e-9, 4.4e-9, 7.9e-9),
    "ThermalConductivity": (204.0, 27.0, 7.2, 45.0),
    "ThermalExpansionCoefficient": (23e-6, 7.4e-6, 8.6e-6, 12e-6),
    "SpecificHeat": (9.0e8, 7.8e8, 5.4e8, 4.6e8),
    "YieldStrength": (95.0, 300.0, 880.0, 250.0),
}
SPHERES = ("hashin_shtrikman_lower", "hashin_shtrikman_upper", "mori_tanaka", "self_consistent")
ELASTIC = ("YoungsModulus", "PoissonRatio")
LAW_OF_EACH = [(name, law) for name in mixing.PROPERTIES for law in mixing.laws_of(name)]
FRACTION = np.linspace(0, 1, 21)
TWO = np.column_stack([1 - FRACTION, FRACTION])


def cards_of(count):
    return {name: values[:count] for name, values in CARDS.items()}


def random_fractions(count, places=200):
    return np.random.default_rng(count).dirichlet(np.ones(count), places)


def random_moduli(count, seed):
    """Bulk and shear moduli (count,), not ordered alike."""
    rng = np.random.default_rng(seed)
    return np.exp(rng.uniform(0, 5, count)), np.exp(rng.uniform(0, 5, count))


def elastic_cards(bulk, shear):
    bulk, shear = np.array(bulk), np.array(shear)
    young = 9 * bulk * shear / (3 * bulk + shear)
    return {"YoungsModulus": young, "PoissonRatio": young / (2 * shear) - 1}


def mixed(name, law, fractions, cards):
    text = f"{law}(150000)" if law == "tamura" else law
    return mixing.mixed(fractions, cards, mixing.read_laws({name: text}), (name,))[name]


def mixed_moduli(law, fractions, bulk, shear):
    """(K, G) of the mixture, through Young's modulus and Poisson's ratio."""
    laws = mixing.read_laws({"YoungsModulus": law})
    values = mixing.mixed(fractions, elastic_cards(bulk, shear), laws)
    young, poisson = (values[name] for name in ELASTIC)
    return young / (3 - 6 * poisson), young / (2 + 2 * poisson)
