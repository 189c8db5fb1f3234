# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user has chosen on the preference page. The page (panels/preferences.ui) holds the same defaults."""
import FreeCAD

from freecad.fgmesh import core

_GROUP = "User parameter:BaseApp/Preferences/Mod/FGMesh"


def _parameters():
    return FreeCAD.ParamGet(_GROUP)


def mesh_values():
    """{property: value} of the options that a new mesh begins with where they are not the usual defaults."""
    defaults = core.MeshingOptions()
    return {
        "MaterialThreshold": _parameters().GetFloat("MaterialThreshold", defaults.material_threshold),
        "SecondOrder": _parameters().GetBool("SecondOrder", defaults.order == 2),
    }


def limits():
    """(seconds, MB) that a meshing run may take at most; 0: no limit but that of the machine's memory."""
    return float(_parameters().GetInt("TimeLimit", 0)), float(_parameters().GetInt("MemoryLimit", 0))


def preview_at_start():
    """Whether the panel of a material opens with its preview on."""
    return _parameters().GetBool("PreviewAtStart", True)
