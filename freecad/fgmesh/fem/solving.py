# SPDX-License-Identifier: GPL-3.0-or-later
"""Solving a graded analysis with CalculiX, by FreeCAD's own tools, with failures told in words."""
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import FreeCAD

from freecad.fgmesh import core
from freecad.fgmesh.fem.analysis import solvers_of
from freecad.fgmesh.adapter import fem_module
from freecad.fgmesh.fem.boundary_conditions import check_constraints, check_held, check_loads
from freecad.fgmesh.fem.deck_names import check_names
from freecad.fgmesh.fem.graded_material import check_filled, is_graded_material
from freecad.fgmesh.fem.graded_solver import check_analysis, grade_deck, is_graded_solver
from freecad.fgmesh.fem.result_fields import add_fields, remove_fields
from freecad.fgmesh.model import presentation
from freecad.fgmesh.model.transaction import transaction

POLL_SECONDS = 0.1
UNDO_NAME = "Solve graded analysis"


class SolverFailed(core.Error):
    """CalculiX is missing, or has not come to an end: the message has its own words. `log`: all that it printed."""

    def __init__(self, message, log=""):
        super().__init__(message)
        self.log = log


def solve(analysis, directory=None, control=None):
    """Writes the deck of `analysis`, as make_analysis() makes it, runs CalculiX and puts the results into the document,
    each with a pipeline for post-processing that has fractions and properties, too.

    directory: where deck and results are written; None: where the preferences of the FEM workbench have it. Blocks;
    Esc, or `control`, a core.RunControl in the hands of another thread, stops CalculiX. Returns the list of new result objects. Raises core.InvalidInput where something is missing or out of date;
    SolverFailed with the words of CalculiX; core.Cancelled, and the results are those of before. One undo step.
    """
    solver = _solver(analysis)
    graded = next(filter(is_graded_material, analysis.Group), None)
    if graded is not None:
        check_filled(graded)
    if is_graded_solver(solver):
        check_analysis(analysis, solver)
    deck = write_deck(analysis, directory)
    # Only now: what is wrong with the analysis is told where there is no CalculiX, too.
    _run(_program(), deck, control or core.RunControl())
    with transaction(analysis.Document, UNDO_NAME):
        return _read_results(analysis, solver, deck)


def write_deck(analysis, directory=None):
    """Writes the deck for CalculiX. Returns its Path. Raises core.InvalidInput, with the words of FreeCAD where its
    own check finds something amiss."""
    solver = _solver(analysis)
    check_names(analysis)
    check_constraints(analysis)
    tool = _tool(analysis, solver)
    tool.update_objects()
    tool.setup_working_dir(None if directory is None else str(directory))
    message = tool.check_prerequisites()
    if message:
        # FreeCAD says the same of each material, and there is one for each bin.
        lines = dict.fromkeys(line.strip() for line in message.splitlines() if line.strip())
        raise core.InvalidInput(f"{analysis.Label} is not ready to be solved: {' '.join(lines)}")
    check_loads(analysis, solver.AnalysisType)
    check_held(analysis, solver.AnalysisType)
    tool.write_inp_file()
    if not tool.inp_file_name:
        raise core.InvalidInput(
            f"FreeCAD could not write the deck of {analysis.Label}: its report view says why"
        )
    if is_graded_solver(solver):
        grade_deck(tool.inp_file_name, analysis)
    return Path(tool.inp_file_name)


def _solver(analysis):
    if not (hasattr(analysis, "isDerivedFrom") and analysis.isDerivedFrom("Fem::FemAnalysis")):
        raise core.InvalidInput(f"{getattr(analysis, 'Label', analysis)} is no FEM analysis")
    solvers = solvers_of(analysis)
    if len(solvers) != 1:
        raise core.InvalidInput(
            f"{analysis.Label} has {len(solvers) or 'no'} CalculiX solvers, where one is needed: "
            + ("delete the others" if solvers else "create the graded analysis")
        )
    return solvers[0]


def _tool(analysis, solver):
    # In its test mode it looks for no program and shows no message boxes.
    return fem_module("femtools.ccxtools").FemToolsCcx(analysis, solver, test_mode=True)


def _program():
    """The path of CalculiX, as the FEM workbench finds it."""
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Ccx")
    own = "" if settings.GetBool("UseStandardCcxLocation", True) else settings.GetString("ccxBinaryPath", "")
    found = shutil.which(own or "ccx")
    if found is None:
        raise SolverFailed(
            f"CalculiX was not found{f' at {own}' if own else ''}: install it (on Debian the package calculix-ccx), or "
            "set its path in the preferences of the FEM workbench, CalculiX"
        )
    return found


def _run(program, deck, control):
    for ending in (".frd", ".dat"):  # those of an earlier run would pass for results
        deck.with_suffix(ending).unlink(missing_ok=True)
    environment = {"OMP_NUM_THREADS": str(os.cpu_count() or 1), **os.environ}
    with tempfile.TemporaryFile(
        "w+", errors="replace"
    ) as output:  # a pipe would have to be emptied meanwhile
        process = subprocess.Popen(
            [program, "-i", deck.stem],
            cwd=deck.parent,
            env=environment,
            stdout=output,
            stderr=subprocess.STDOUT,
        )
        with process, presentation.progress("Solving") as show:
            try:
                while process.poll() is None and not control.cancelled():
                    show(control)
                    time.sleep(POLL_SECONDS)
            finally:
                process.kill()
        if control.cancelled():
            raise core.Cancelled("CalculiX was stopped: the results are those of before")
        output.seek(0)
        log = output.read()
    errors = re.findall(r"\*ERROR.*(?:\n(?! *\*).*\S.*)*", log)
    if process.returncode or errors or not deck.with_suffix(".frd").exists():
        FreeCAD.Console.PrintError(log[-20000:])
        told = (
            " ".join(" ".join(errors[:3]).split())
            or f"it ended with {process.returncode} and no word of an error"
        )
        raise SolverFailed(
            f"CalculiX has failed: {told}. The deck is {deck}; all it said is in the report view", log
        )


def _read_results(analysis, solver, deck):
    tool = _tool(analysis, solver)
    remove_fields(analysis)
    tool.purge_results()
    before = set(analysis.Group)
    tool.inp_file_name = str(deck)
    tool.load_results()
    results = [
        thing
        for thing in analysis.Group
        if thing.isDerivedFrom("Fem::FemResultObject") and thing not in before
    ]
    if not results and solver.AnalysisType != "check":
        raise SolverFailed(
            f"CalculiX has written no results that FreeCAD can read: see {deck.with_suffix('.frd')}"
        )
    if any(is_graded_material(thing) for thing in analysis.Group):
        for result in results:
            add_fields(result)
    return results
