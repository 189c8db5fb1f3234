# SPDX-License-Identifier: GPL-3.0-or-later
"""A solver object for CalculiX whose properties vary inside elements.

CalculiX interpolates only temperatures inside an element; so the volume fraction of the first constituent takes the
temperature's place: properties are tables over it, and it is the initial temperature of the nodes. Without
*EXPANSION it strains nothing. The temperature itself is lost by that: there is no thermomechanical analysis so.
The decks are FreeCAD's own, with the materials replaced.
"""
import os
from pathlib import Path

import numpy as np

from freecad.fgmesh import core
from freecad.fgmesh.adapter import solver_bases
from freecad.fgmesh.fem.graded_fields import graded_mesh
from freecad.fgmesh.fem.graded_material import check_filled, is_graded_material, request_of
from freecad.fgmesh.io.deck_numbers import deck_number
from freecad.fgmesh.model import presentation

_FIRST_ROWS = 33
_MOST_ROUNDS = 12
_TABLE_ERROR = 1e-5
"""Of a table: halfway between two rows, between which CalculiX interpolates linearly, relative to the property."""

_ANALYSES = ("static", "frequency", "buckling", "check")
_PROPERTIES = (("*ELASTIC", ("YoungsModulus", "PoissonRatio")), ("*DENSITY", ("Density",)))


class GradedSolver(*solver_bases()):
    """The proxy: FreeCAD's solver object for CalculiX, but for the deck."""

    # By this FreeCAD asks for a machine, where its own solver object would be solved without one.
    Type = "Fem::SolverCalculix"

    def __init__(self, solver):
        super().__init__(solver)
        solver.Proxy = self

    def onDocumentRestored(self, solver):
        super().onDocumentRestored(solver)
        presentation.show_graded_solver(solver)

    def createMachine(self, solver, directory, testmode=False):
        # Only here: FreeCAD 1.2 has no such machines.
        from freecad.fgmesh.fem.graded_machine import make_machine

        return make_machine(solver, directory, testmode)


def make_graded_solver(document, name="GradedSolver"):
    """A new solver object."""
    solver = document.addObject("Fem::FemSolverObjectPython", name)
    GradedSolver(solver)
    solver.addExtension("App::GroupExtensionPython")  # as the view provider with FreeCAD's panel expects
    presentation.show_graded_solver(solver)
    return solver


def is_graded_solver(solver):
    return isinstance(getattr(solver, "Proxy", None), GradedSolver)


def check_analysis(analysis, solver):
    """Raises core.InvalidInput where the continuous mode cannot do what is asked for."""
    graded = _graded(analysis)
    check_filled(graded)
    if solver.AnalysisType not in _ANALYSES:
        raise core.InvalidInput(
            f"{solver.Label}: a {solver.AnalysisType} analysis needs the temperature, in whose place the continuous mode "
            "puts the volume fraction: create the graded analysis with bins"
        )
    if graded.Mode != "continuous":
        raise core.InvalidInput(
            f"{graded.Label} has bins, {solver.Label} is for the continuous mode: create the graded analysis again"
        )


def grade_deck(path, analysis):
    """Replaces the materials in the deck at `path`, which FreeCAD has written for `analysis`, by graded ones."""
    graded = _graded(analysis)
    fields, laws = graded_mesh(graded.Mesh), request_of(graded).laws()
    temperatures = fields.first_fractions()
    materials = {
        material.Name: _table(region, laws, temperatures[fields.nodes_of(region)])
        for material, region in zip(graded.Materials, fields.regions)
    }
    path = Path(path)
    new = path.with_name(path.name + ".new")
    with open(path, encoding="utf-8") as old, open(new, "w", encoding="utf-8") as deck:
        _rewrite(old, deck, materials, temperatures)
    os.replace(new, path)


def _rewrite(old, deck, materials, temperatures):
    keyword, table, done = "", None, False
    for line in old:
        if line.startswith("*") and not line.startswith("**"):
            keyword = line.split(",")[0].strip().upper()
            if keyword == "*MATERIAL":
                table = materials.get(line.rpartition("=")[2].strip())
            elif keyword not in dict(_PROPERTIES):
                table = None
            elif table:
                deck.write(line + table[keyword])
                continue
            if keyword == "*STEP" and not done:
                deck.write("** Volume fraction of the first constituent in the place of a temperature\n")
                deck.write("*INITIAL CONDITIONS, TYPE=TEMPERATURE\n")
                deck.writelines(
                    f"{node},{deck_number(value)}\n" for node, value in enumerate(temperatures, 1)
                )
                done = True
        elif table and keyword in dict(_PROPERTIES) and not line.startswith("**") and line.strip():
            continue  # the value that the table replaces
        deck.write(line)


def _table(region, laws, fractions):
    """{keyword: the lines of its table over the fraction of the first constituent}, from the least to the largest of the
    `fractions` (n,) that the nodes of the region have: a law need not have a meaning for others."""
    fractions, properties = table_rows(
        lambda fractions: region.properties(np.column_stack([fractions, 1 - fractions]), laws),
        fractions.min(),
        fractions.max(),
    )
    tables = {}
    for keyword, names in _PROPERTIES:
        if all(name in properties for name in names):
            rows = np.column_stack([*(properties[name] for name in names), fractions])
            tables[keyword] = "".join(",".join(map(deck_number, row)) + "\n" for row in rows.tolist())
    return tables


def table_rows(properties_at, low=0.0, high=1.0):
    """Fractions (n,) from `low` to `high`, and {property: (n,)} there, as many as linear interpolation needs; one where
    both are equal.

    properties_at: a function that gives {property: (n,)} at fractions (n,).
    """
    fractions = np.unique(np.linspace(low, high, _FIRST_ROWS))
    properties = properties_at(fractions)
    for _ in range(_MOST_ROUNDS):
        middles = (fractions[1:] + fractions[:-1]) / 2
        there = properties_at(middles)
        wrong = np.zeros(len(middles), bool)
        for name, values in there.items():
            ends = properties[name]
            wrong |= np.abs(values - (ends[1:] + ends[:-1]) / 2) > _TABLE_ERROR * np.abs(values)
        if not wrong.any():
            break
        places = np.flatnonzero(wrong) + 1
        fractions = np.insert(fractions, places, middles[wrong])
        properties = {
            name: np.insert(values, places, there[name][wrong]) for name, values in properties.items()
        }
    return fractions, properties


def _graded(analysis):
    found = [thing for thing in analysis.Group if is_graded_material(thing)]
    if len(found) != 1:
        raise core.InvalidInput(
            f"{analysis.Label} has {len(found) or 'no'} graded materials, where one is needed: create the graded analysis"
        )
    return found[0]
