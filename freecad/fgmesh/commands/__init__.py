# SPDX-License-Identifier: GPL-3.0-or-later
"""The workbench's commands, one class each: what is selected decides whether they are active, a panel does the rest."""
import FreeCADGui


def add_all():
    """Makes the commands known to FreeCAD; gives their names in the order of the menu."""
    from freecad.fgmesh.commands.analysis import AnalysisCommand
    from freecad.fgmesh.commands.examples import ExamplesCommand
    from freecad.fgmesh.commands.material import MaterialCommand
    from freecad.fgmesh.commands.mesh import MeshCommand
    from freecad.fgmesh.commands.preview import PreviewCommand
    from freecad.fgmesh.commands.report import ReportCommand

    commands = (
        MaterialCommand(),
        PreviewCommand(),
        MeshCommand(),
        ReportCommand(),
        AnalysisCommand(),
        ExamplesCommand(),
    )
    for command in commands:
        FreeCADGui.addCommand(command.name, command)
    return [command.name for command in commands]
