# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials that a solid may be made of: FreeCAD's cards, the user's own, and those of the document."""
from collections import Counter
from pathlib import Path

import FreeCAD

from freecad.fgmesh import adapter, core

_USER_FOLDER = "Material"


def card_paths():
    """{name: path} of the material cards of FreeCAD and of its user, whose cards come before those of the same
    name."""
    resources, user = Path(FreeCAD.getResourceDir()), Path(FreeCAD.getUserAppDataDir())
    found = {}
    for folder in [*(resources / folder for folder in adapter.CARD_FOLDERS), user / _USER_FOLDER]:
        found.update((path.stem, str(path)) for path in sorted(folder.rglob("*.FCMat")))
    return found


def material_objects(document):
    """The material objects of `document`, as the FEM workbench makes them for solids."""
    return [
        thing for thing in document.Objects if hasattr(thing, "Material") and isinstance(thing.Material, dict)
    ]


MADE_BY_US = "FGMesh"
"""The "Father" in the cards of materials that stand for bins of a grading, which nothing is made of."""


def available(document):
    """{name that `attach_material` takes as a constituent: what a user knows it by}: the document's material objects, by
    their labels, then cards."""
    objects = [thing for thing in material_objects(document) if thing.Material.get("Father") != MADE_BY_US]
    cards = sorted(card_paths(), key=str.lower)
    labels = Counter([thing.Label for thing in objects] + cards)
    shown = {
        thing.Name: thing.Label if labels[thing.Label] == 1 else f"{thing.Label} ({thing.Name})"
        for thing in objects
    }
    return {**shown, **{name: name for name in cards if name not in shown}}


def properties(name, document):
    """{property: text with unit} of a constituent: a material object of `document`, else a card. Empty where there
    is none of that name."""
    for thing in material_objects(document):
        if thing.Name == name:
            return dict(thing.Material)
    path = card_paths().get(name)
    return adapter.read_card(path) if path else {}


UNITS = {
    "YoungsModulus": "MPa",
    "PoissonRatio": "",
    "Density": "t/mm^3",
    "ThermalConductivity": "W/m/K",
    "ThermalExpansionCoefficient": "1/K",
    "SpecificHeat": "mm^2/s^2/K",
    "YieldStrength": "MPa",
}
"""{property of material cards: unit}, which fit together: mm, t, s, K."""

SI_UNITS = {
    **UNITS,
    "YoungsModulus": "Pa",
    "Density": "kg/m^3",
    "SpecificHeat": "J/kg/K",
    "YieldStrength": "Pa",
}
"""The same in SI units, in which FreeCAD's post-processing has its own fields."""


def values(names, document):
    """{property of UNITS: [number in its unit for each constituent, None where its card is silent]}. Raises
    core.InvalidInput where there is no material of a name, or where its text is no such quantity."""
    cards = []
    for name in names:
        card = properties(name, document)
        if not card:
            raise core.InvalidInput(
                f"there is no material card and no material object called {name!r}: choose another constituent, "
                "or put the card where FreeCAD looks for them"
            )
        cards.append((name, card))
    return {
        key: [_required_number(name, key, card.get(key), unit) for name, card in cards]
        for key, unit in UNITS.items()
    }


def number_in(text, unit):
    """The number in `unit` that a card's text stands for; None where it is none."""
    if not text:
        return None
    try:
        quantity = FreeCAD.Units.Quantity(text)
        return float(quantity.getValueAs(unit)) if unit else float(quantity)
    except Exception:  # FreeCAD's parser of quantities knows many
        return None


def _required_number(name, key, text, unit):
    number = number_in(text, unit)
    if number is None and text and str(text).strip():
        raise core.InvalidInput(
            f"{name}: its {key} is {text!r}, which is no quantity in {unit or 'plain numbers'}: correct the card"
        )
    return number
