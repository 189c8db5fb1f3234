# SPDX-License-Identifier: GPL-3.0-or-later
"""XDMF 3 (https://www.xdmf.org/index.php/XDMF_Model_and_Format): text, read by ParaView, VisIt, meshio and FEniCS.

meshio writes it only where h5py is installed; FreeCAD not for meshes with groups of nodes (FreeCAD issue 22762). FEniCS
wants one kind of cells in a file, and so does meshio of cells with ten nodes: facets go to a file of their own.
"""
from xml.sax.saxutils import quoteattr

import numpy as np

# By dimension and number of nodes, which are in the order of VTK.
_TOPOLOGIES = {(2, 3): "Triangle", (3, 4): "Tetrahedron", (2, 6): "Triangle_6", (3, 10): "Tetrahedron_10"}


def write_xdmf(mesh, fields, path):
    """Write the tetrahedra of a GroupedMesh with their Fields and those at points."""
    _write(path, mesh, 3, fields.at_points, {name: of_tets for name, (of_tets, _) in fields.in_cells.items()})


def write_xdmf_facets(mesh, fields, path):
    """Write the triangles of a GroupedMesh with their Fields, on the same points."""
    _write(path, mesh, 2, {}, {name: of_triangles for name, (_, of_triangles) in fields.in_cells.items()})


def _write(path, mesh, dimension, at_points, in_cells):
    cells = mesh.cells(dimension)
    count, nodes = cells.shape
    kind = _TOPOLOGIES[dimension, nodes]
    with open(path, "w", encoding="utf-8") as file:
        file.write(
            '<?xml version="1.0"?>\n<Xdmf Version="3.0">\n<Domain>\n<Grid Name="mesh" GridType="Uniform">\n'
        )
        file.write('<Geometry GeometryType="XYZ">\n')
        _data(file, mesh.points)
        file.write(
            f'</Geometry>\n<Topology TopologyType="{kind}" NumberOfElements="{count}" NodesPerElement="{nodes}">\n'
        )
        _data(file, cells)
        file.write("</Topology>\n")
        for center, values in (("Node", at_points), ("Cell", in_cells)):
            for name, column in values.items():
                file.write(f'<Attribute Name={quoteattr(name)} AttributeType="Scalar" Center="{center}">\n')
                _data(file, column)
                file.write("</Attribute>\n")
        file.write("</Grid>\n</Domain>\n</Xdmf>\n")


def _data(file, values):
    values = np.asarray(values)
    whole = np.issubdtype(values.dtype, np.integer)
    kind, form = ('"Int" Precision="4"', "%d") if whole else ('"Float" Precision="8"', "%.17g")
    size = " ".join(map(str, values.shape))
    file.write(f'<DataItem DataType={kind} Dimensions="{size}" Format="XML">\n')
    np.savetxt(file, values, form)
    file.write("</DataItem>\n")
