# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks at a mesh file with nothing of FGMesh's: is it sound, and how good is it?"""
import contextlib
import sys

import meshio
import numpy as np

FACES = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])
"""Face i of a tetrahedron is opposite vertex i, counter-clockwise seen from outside."""


def read(path):
    """Points (n, 3), tetrahedra (m, 4) and triangles (t, 3) of a mesh file; points of lower elements dropped."""
    with contextlib.redirect_stdout(sys.stderr):  # meshio prints an empty line for each file of gmsh
        mesh = meshio.read(path)
    cells = {
        kind: [block.data for block in mesh.cells if block.type == kind] for kind in ("tetra", "triangle")
    }
    if not cells["tetra"]:
        raise ValueError(f"{path} holds no tetrahedra")
    tets = np.vstack(cells["tetra"]).astype(np.int64)
    triangles = np.vstack([np.empty((0, 3)), *cells["triangle"]]).astype(np.int64)
    return np.asarray(mesh.points, float), tets, triangles


def volumes(points, tets):
    """Signed, mm^3; positive in VTK's order."""
    a, b, c = (points[tets[:, i]] - points[tets[:, 0]] for i in (1, 2, 3))
    return np.einsum("ij,ij->i", np.cross(a, b), c) / 6


def hull(tets):
    """The faces that belong to one tetrahedron only (h, 3), and how many belong to more than two."""
    faces = tets[:, FACES].reshape(-1, 3)
    _, first, uses = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[uses == 1]], int((uses > 2).sum())


def faults(points, tets, triangles):
    """What is wrong with a mesh, in words; an empty list where nothing is."""
    found = []
    size = volumes(points, tets)
    outer, overfull = hull(tets)
    edges = np.sort(outer[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edge_uses = np.unique(edges, axis=0, return_counts=True)[1]
    place = points[np.unique(tets)]
    checks = {
        "flat or turned over": (size <= 1e-12 * size.max()).sum(),
        "faces of more than two tetrahedra": overfull,
        "open edges of the boundary": (edge_uses % 2).sum(),
        "points in one place": len(place) - len(np.unique(place, axis=0)),
        "points of no tetrahedron": len(points) - len(place),
    }
    if len(triangles):
        rows = np.vstack([np.sort(outer, axis=1), np.sort(triangles, axis=1)])
        checks["triangles that are not the boundary"] = (
            np.unique(rows, axis=0, return_counts=True)[1] != 2
        ).sum()
    return [f"{count} {what}" for what, count in checks.items() if count]


def dihedral_angles(points, tets):
    """(m, 6), degrees."""
    corners = points[tets]
    normals = []
    for i, j, k in FACES:
        normal = np.cross(corners[:, j] - corners[:, i], corners[:, k] - corners[:, i])
        normals.append(normal / np.linalg.norm(normal, axis=1)[:, None])
    pairs = [(i, j) for i in range(4) for j in range(i)]
    cosines = np.stack([-np.einsum("ij,ij->i", normals[i], normals[j]) for i, j in pairs], axis=1)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def variation(case, points, tets):
    """Largest difference of the fraction between two vertices of each tetrahedron; (m,)."""
    return np.ptp(case.fraction_at(points)[tets], axis=1)


def slope_cubed(case, points, tets):
    """Integral of |grad f|^3 over the mesh, by the rule of four points that is exact for quadratics; 1."""
    a, b = 0.5854101966249685, 0.1381966011250105
    corners = points[tets]
    nodes = ((a - b) * corners[:, i] + b * corners.sum(axis=1) for i in range(4))
    return float((volumes(points, tets) * sum(case.slope_at(node) ** 3 for node in nodes)).sum() / 4)


ANGLE_BINS = np.arange(0, 181, 5)
"""Bounds of "dihedral_counts", degrees."""


def measure(case, path, threshold):
    """The figures of a mesh file for the table; "faults" is empty where the mesh is sound."""
    points, tets, triangles = read(path)
    size, angles, change = volumes(points, tets), dihedral_angles(points, tets), variation(case, points, tets)
    return {
        "faults": faults(points, tets, triangles),
        "points": len(points),
        "tets": len(tets),
        "eta": len(tets) * threshold**3 / slope_cubed(case, points, tets),
        "dihedral_min": float(angles.min()),
        "dihedral_max": float(angles.max()),
        "dihedral_counts": np.histogram(angles, ANGLE_BINS)[0].tolist(),
        "variation_mean": float(change.mean()),
        "variation_max": float(change.max()),
        "above": int((change > threshold * (1 + 1e-9)).sum()),
        "volume": float(size.sum()),
    }
