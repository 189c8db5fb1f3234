# SPDX-License-Identifier: GPL-3.0-or-later
"""All that differs between the versions of FreeCAD, 0.20 to 1.x, in names, places and modules.

Nothing else of FGMesh asks for a version, or tries one name after another. What a version lacks is found out by looking for
it, not by the version's number. Works without a GUI; functions for Qt take its objects.
"""
import importlib
import sys
from pathlib import Path

import FreeCAD


def fem_module(name):
    """The module of the FEM workbench with this name, as "ObjectsFem" or "femtools.ccxtools", which only FreeCAD's
    windows and its command line have on their path."""
    return _module_in(name, "Mod/Fem", "Ext")


def make_standard_solver(document):
    """FreeCAD's own solver object for CalculiX."""
    objects = fem_module("ObjectsFem")
    make = _first(objects, "makeSolverCalculixCcxTools", "makeSolverCalculiXCcxTools")  # FreeCAD 0.20, 1.x
    return make(document)


SOLVER_SETTINGS = {"Fem", "AnalysisType", "ElementModel", "Solver", "TimeIncrement"}
"""Groups of the properties of a solver object that are its user's: the first in 0.20 and 1.0, the others since 1.1."""


def solver_bases():
    """Classes that a proxy of a solver object for CalculiX derives from: the one that knows its properties, which 1.1
    has renamed and takes over from older documents; and the one that FreeCAD's own panel and Run button use, which
    1.2 has no more.
    """
    properties = fem_module("femobjects.solver_ccxtools").SolverCcxTools
    framework = _solver_framework()
    return (properties, framework.Proxy) if framework else (properties,)


def solver_view():
    """Class of the view provider with FreeCAD's own panel for such a solver object; None since 1.2."""
    framework = _solver_framework()
    return framework and framework.ViewProxy


def _solver_framework():
    try:
        return fem_module("femsolver.calculix.solver")
    except ImportError:
        return None


_PLAIN_UNITS = {"Force": "N", "Pressure": "MPa", "Temperature": "K", "initialTemperature": "K"}


def set_quantity(constraint, name, text):
    """Gives a FEM constraint a value with its unit, as set_quantity(force, "Force", "100 N").

    A plain number would count as mN, kPa in 1.x; 0.20 takes nothing else, and means N, MPa, K by it.
    """
    quantity = FreeCAD.Units.Quantity(text)
    if constraint.getTypeIdOfProperty(name) == "App::PropertyFloat":
        quantity = quantity.getValueAs(_PLAIN_UNITS[name]).Value
    setattr(constraint, name, quantity)


def hold(constraint, axes):
    """Has a FEM constraint of displacements hold what it refers to along `axes`, as "xz"."""
    for axis in axes:
        setattr(constraint, f"{axis}Free", False)
        if f"{axis}Fix" in constraint.PropertiesList:  # in 0.20
            setattr(constraint, f"{axis}Fix", True)


def set_weight(weight, direction):
    """Has a FEM constraint of self-weight act with standard gravity along `direction`, three numbers of length 1."""
    if "GravityDirection" in weight.PropertiesList:
        weight.GravityDirection = FreeCAD.Vector(*direction)
    else:  # in 0.20
        weight.Gravity_x, weight.Gravity_y, weight.Gravity_z = direction


def add_filter(pipeline, post_filter):
    """Has a post-processing filter take its data from `pipeline`."""
    if "Filter" in pipeline.PropertiesList:
        pipeline.Filter = [*pipeline.Filter, post_filter]
    else:  # since 1.1 a pipeline is a group
        pipeline.addObject(post_filter)


def plotted(line, field):
    """(places, values) of `field`, of a vector its length, along a Fem::FemPostDataAlongLineFilter."""
    # 1.x plots nothing before a component is chosen, which it leaves to its window.
    if "PlotDataComponent" in line.PropertiesList and not line.getEnumerationsOfProperty("PlotDataComponent"):
        line.PlotDataComponent = ["Magnitude"]
    line.Document.recompute(None, True)  # which gives it the pipeline's data
    line.PlotData = field
    line.touch()
    line.Document.recompute()
    return line.XAxisData, line.YAxisData


CARD_FOLDERS = ("Mod/Material/StandardMaterial", "Mod/Material/Resources/Materials")
"""Of FreeCAD's resources: where its material cards are in 0.20, in 1.x."""


def read_card(path):
    """{property: text with unit} of the material card at `path`; empty where FreeCAD does not know it."""
    try:
        import Materials  # FreeCAD 1.x
    except ImportError:
        return dict(_module_in("importFCMat", "Mod/Material").read(path))
    for material in Materials.MaterialManager().Materials.values():
        if _is_of_card(material, Path(path)):
            return {name: str(value) for name, value in material.Properties.items()}
    return {}


def _is_of_card(material, path):
    """FreeCAD 1.0 tells the card's path in its library, 1.1 only its folder there."""
    if Path(material.Directory).suffix:
        return f"/{path.as_posix()}".endswith(f"/{material.Directory}")
    names = (path.stem, path.stem.replace("-", " "))
    return material.Name in names and path.parent.as_posix().endswith(material.Directory)


def flag_number(flags):
    """The number of flags or an enumerator of Qt's, which PySide2 turns into one by int(), PySide6 has as a value."""
    return flags.value if hasattr(flags, "value") else int(flags)


def _module_in(name, *folders):
    try:
        return importlib.import_module(name)
    except ImportError:
        paths = [str(Path(FreeCAD.getResourceDir()) / folder) for folder in folders]
        if set(paths) <= set(sys.path):
            raise
        sys.path += [path for path in paths if path not in sys.path]
        return importlib.import_module(name)


def _first(owner, *names):
    """What `owner` has by one of these names."""
    for name in names:
        if hasattr(owner, name):
            return getattr(owner, name)
    raise RuntimeError(f"this FreeCAD has none of {', '.join(names)}, of which FGMesh needs one")
