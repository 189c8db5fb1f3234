# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes graded solids through FreeCAD documents and shows what came out.

    /usr/bin/python3 examples/run_demo.py BUILD_DIR                  both case studies
    /usr/bin/python3 examples/run_demo.py BUILD_DIR PART FORMULA     a STEP or BREP file, graded by a formula

FORMULA is the fraction of the first constituent, over x y z r theta d (mm, radians). BUILD_DIR/demo receives
for each case the document, the mesh, the report and pictures of every stage; a table of figures is printed.

Exit status: 0 done; 1 not done; 2 wrong usage, formula or file; 3 shape refused; 4 done, but the threshold or
the surface deviation is not met.
"""
import importlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

FREECAD_LIBRARIES = "/usr/lib/freecad-python3/lib"
PAPER_TABLE = "paper, case I   G-Mesh  14840   63911  0.0020 0.0998 0.0301   10.01 164.07"


def main(arguments):
    if len(arguments) not in (1, 3):
        print(__doc__, file=sys.stderr)
        return 2
    build_folder = Path(arguments[0]).resolve()
    add_on = build_folder / "Mod" / "FGMesh"
    sys.path[:0] = [str(add_on), FREECAD_LIBRARIES]
    from freecad.fgmesh import core

    cases = (
        case_studies()
        if len(arguments) == 1
        else {Path(arguments[1]).stem: lambda: user_part(*arguments[1:])}
    )
    folder = build_folder / "demo"
    folder.mkdir(parents=True, exist_ok=True)
    try:
        reports = {name: run(build(), folder / name) for name, build in cases.items()}
        for name in cases:
            draw(folder, name, add_on)
    except core.InvalidInput as error:
        return complain(error, 2)
    except core.GeometryError as error:
        return complain(error, 3)
    except (core.Error, OSError, subprocess.CalledProcessError) as error:
        return complain(error, 1)
    print_table(reports)
    print(f"documents, meshes, reports and pictures: {folder}")
    return 0 if all(report["status"] == "ok" for report in reports.values()) else 4


def case_studies():
    """{name: function that builds the document}, from the macros beside this file."""
    # Last: the repository also holds the sources of the package, which have no compiled part beside them.
    sys.path.append(str(Path(__file__).resolve().parent.parent))
    names = ("case_study_1", "case_study_2")
    return {name: importlib.import_module(f"examples.{name}").build for name in names}


def user_part(path, formula):
    """A document with the part of a file, graded by `formula`. Returns its mesh object."""
    import FreeCAD
    import Part

    import freecad.fgmesh as fgmesh
    from freecad.fgmesh import core

    try:
        shape = Part.read(path)
    except Exception as error:
        raise core.InvalidInput(f"{path} cannot be read as STEP or BREP: {error}") from None
    document = FreeCAD.newDocument("Part")
    part = document.addObject("Part::Feature", "Part")
    part.Label = Path(path).stem
    part.Shape = shape
    fgmesh.attach_material(part, formula)
    return fgmesh.make_mesh(document, part)


def run(mesh, target):
    """Meshes up to each stage in turn; writes the document, the mesh of each stage and the last one's report.

    Returns that report.
    """
    import freecad.fgmesh as fgmesh
    from freecad.fgmesh.io import write_mesh, write_report

    for stage in mesh.getEnumerationsOfProperty("StopAfter"):
        print(f"{target.name}: up to the {stage} stage ...", flush=True)
        mesh.StopAfter = stage
        result = fgmesh.generate(mesh)
        write_mesh(result, f"{target}-{stage}.vtu")
    shutil.copyfile(f"{target}-{stage}.vtu", f"{target}.vtu")
    report = result.report()
    write_report(report, f"{target}.json")
    mesh.Document.recompute()
    Path(f"{target}.FCStd").unlink(missing_ok=True)  # FreeCAD would keep it as a backup
    mesh.Document.saveAs(f"{target}.FCStd")
    return report


def draw(folder, name, add_on):
    """The pictures, in a process of their own: VTK ends it where it finds no X server, as xvfb-run starts."""
    stages = [str(folder / f"{name}-{stage}.vtu") for stage in ("initial", "material", "geometry")]
    command = [sys.executable, "-m", "freecad.fgmesh.pictures", *stages, str(folder / f"{name}.json")]
    if shutil.which("xvfb-run"):
        command = ["xvfb-run", "--auto-servernum", *command]
    subprocess.run(
        command, check=True, env={**os.environ, "PYTHONPATH": str(add_on)}, stdout=subprocess.DEVNULL
    )


def print_table(reports):
    """The columns of the paper's table 1, and its last row beside the case that it belongs to."""
    print("\n                        points    tets  variation            dihedral angles")
    print("                                        min    max    mean     min   max     seconds")
    for name, report in reports.items():
        for stage in report["stages"]:
            variation, dihedral = stage["variation"], stage["dihedral"]
            print(
                f"{name[:15]:15} {stage['name'][0].upper()}-Mesh {stage['points']:6} {stage['tets']:7}  "
                f"{variation['min']:.4f} {variation['max']:.4f} {variation['mean']:.4f}  "
                f"{dihedral['min']:6.2f} {dihedral['max']:6.2f}  {stage['seconds']:7.1f}"
            )
        volume = report["volume"] / report["shape_volume"] - 1
        print(
            f"{'':15} {report['status']}, eta {report['element_ratio']:.1f}, largest deviation "
            f"{report['deviation_max']:.3g} mm, volume {volume:+.3%}"
        )
    if "case_study_1" in reports:
        print(PAPER_TABLE)
    print()


def complain(error, status):
    print(f"demo: {error}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
