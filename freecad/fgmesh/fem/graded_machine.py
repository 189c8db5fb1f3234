# SPDX-License-Identifier: GPL-3.0-or-later
"""How FreeCAD's panel and its Run button solve an analysis whose properties vary inside elements.

The steps are FreeCAD's own; the deck is graded once it is written.
"""
from pathlib import Path

from freecad.fgmesh import core
from freecad.fgmesh.adapter import fem_module
from freecad.fgmesh.fem.boundary_conditions import check_constraints, check_held, check_loads
from freecad.fgmesh.fem.deck_names import check_names
from freecad.fgmesh.fem.graded_solver import check_analysis, grade_deck
from freecad.fgmesh.fem.solving import UNDO_NAME
from freecad.fgmesh.model.transaction import transaction

tasks = fem_module("femsolver.calculix.tasks")
run = fem_module("femsolver.run")


def make_machine(solver, directory, testmode):
    return run.Machine(
        solver=solver,
        directory=directory,
        check=Check(),
        prepare=Prepare(),
        solve=tasks.Solve(),
        results=Results(),
        testmode=testmode,
    )


class Check(tasks.Check):
    def run(self):
        super().run()
        try:
            check_analysis(self.analysis, self.solver)
            check_names(self.analysis)
            check_constraints(self.analysis)
            check_loads(self.analysis, self.solver.AnalysisType)
            check_held(self.analysis, self.solver.AnalysisType)
        except core.Error as error:
            self.report.error(f"{error}\n")
            self.fail()


class Prepare(tasks.Prepare):
    def run(self):
        super().run()
        decks = list(Path(self.directory).glob("*.inp"))
        if self.failed or not decks:
            return
        try:
            for deck in decks:
                grade_deck(deck, self.analysis)
        except core.Error as error:
            self.report.error(f"{error}\n")
            self.fail()


class Results(tasks.Results):
    """In one undo step, which FreeCAD's own lack: its results outlast the undo of the analysis that they belong to."""

    def run(self):
        with transaction(self.analysis.Document, UNDO_NAME):
            super().run()
