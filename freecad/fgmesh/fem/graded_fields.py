# SPDX-License-Identifier: GPL-3.0-or-later
"""Composition and properties on a mesh that is in a document: in its tetrahedra and at its nodes."""
from typing import NamedTuple

import numpy as np

from freecad.fgmesh import core, mixing
from freecad.fgmesh.fem.fem_mesh import points_and_tets
from freecad.fgmesh.model import constituents, mesh_object, stored
from freecad.fgmesh.model.graded_parts import owners_of
from freecad.fgmesh.model.graded_solid import material_of

_NEAR, _FAR = 0.5854101966249685, 0.1381966011250105
_QUADRATURE = np.full((4, 4), _FAR) + (_NEAR - _FAR) * np.eye(4)
"""Barycentric coordinates of four points, of equal weight, that integrate quadratic functions over a tetrahedron
exactly (Hammer, Marlowe and Stroud, Mathematical Tables and Other Aids to Computation 10 (1956) 130)."""

REQUIRED = ("YoungsModulus", "PoissonRatio")
"""What no analysis of a solid does without."""

_ROUNDING = 1e-9
"""How far outside of [0, 1] a fraction may be; more is not silently moved into it."""

_JUMP = 1e-6
"""Of a fraction at a node, between one solid and another."""


class Region(NamedTuple):
    """The solids of a mesh in which one material holds."""

    owner: object  # the document object that has the material
    material: core.Material  # in the mesh's coordinates, its references read
    cards: dict  # {property: [number for each constituent, or None]}, as constituents.values() gives them
    tets: np.ndarray  # (t,) 0-based
    corners: np.ndarray  # (t, 4) 0-based nodes

    def mean_fractions(self, points):
        """(t, k): the mean over each tetrahedron, of the nodes' `points` (n, 3)."""
        corners = points[self.corners]
        total = sum(
            self.material.evaluate(np.einsum("c,tcx->tx", weights, corners)) for weights in _QUADRATURE
        )
        return self._checked(total / len(_QUADRATURE))

    def node_fractions(self, points, nodes):
        """(n, k) at the nodes with these 0-based numbers."""
        return self._checked(self.material.evaluate(points[nodes]))

    def properties(self, fractions, laws, within_range=True):
        """{property: (n,)} of mixtures with `fractions` (n, k): of `REQUIRED`, and of all others that each card has.
        laws, within_range: as mixing.mixed() takes them. Raises core.InvalidInput that names the solid."""
        wanted = [name for name in mixing.PROPERTIES if name in REQUIRED or None not in self.cards[name]]
        try:
            return mixing.mixed(fractions, self.cards, laws, wanted, within_range)
        except core.InvalidInput as error:
            names = ", ".join(
                f"{n}: {name}" for n, name in enumerate(stored.texts(self.owner, "FGMConstituents"), 1)
            )
            raise core.InvalidInput(f"{self.owner.Label} ({names}): {error}") from None

    def _checked(self, fractions):
        wrong = ~(np.abs(fractions - 0.5) <= 0.5 + _ROUNDING).all(axis=1)
        if wrong.any():
            row = ", ".join(f"{fraction:.4g}" for fraction in fractions[wrong][0])
            raise core.InvalidInput(
                f"{self.owner.Label}: the volume fractions are {row} in {wrong.sum()} places of the mesh, but must "
                "be defined and lie between 0 and 1: correct the material's formulas, with clamp(..., 0, 1) "
                "where nothing else is meant"
            )
        return np.clip(fractions, 0, 1)


class GradedMesh(NamedTuple):
    points: np.ndarray  # (n, 3), mm; node i + 1 of the Fem mesh at i
    tets: np.ndarray  # (m, 4 or 10), 0-based
    solids: np.ndarray  # (m,) 0-based solid of each tetrahedron
    regions: list

    def in_tets(self, laws):
        """{property: (m,)} by `laws`, of the mean fractions of each tetrahedron: what is known in all regions."""
        parts = [
            (region, region.properties(region.mean_fractions(self.points), laws)) for region in self.regions
        ]
        known = set.intersection(*(set(properties) for _, properties in parts))
        values = {name: np.empty(len(self.tets)) for name in mixing.PROPERTIES if name in known}
        for region, properties in parts:
            for name, column in values.items():
                column[region.tets] = properties[name]
        return values

    def nodes_of(self, region):
        """The 0-based nodes of a region, sorted."""
        return np.unique(self.tets[region.tets])

    def at_nodes(self, laws=None, units=constituents.UNITS):
        """{name: (n,)}: `fraction_1` ... and, where `laws` are given, the properties, as named() has them. At an
        interface a node has the values of one of the solids; NaN where a solid has not what others have.

        Values are to be looked at: on the boundary a formula may give a modulus of 0, which no element has.
        """
        values = {}
        for region in self.regions:
            nodes = self.nodes_of(region)
            fractions = region.node_fractions(self.points, nodes)
            found = {f"fraction_{number}": column for number, column in enumerate(fractions.T, 1)}
            if laws is not None:
                found.update(self.named(region.properties(fractions, laws, within_range=False), units))
            for name, column in found.items():
                values.setdefault(name, np.full(len(self.points), np.nan))[nodes] = column
        return values

    @staticmethod
    def named(properties, units=constituents.UNITS):
        """The same in `units`, {property: unit}, with the unit in each name, as "Density (t/mm^3)"."""
        found = {}
        for name, values in properties.items():
            own, unit = constituents.UNITS[name], units[name]
            scale = 1.0 if unit == own else constituents.number_in(f"1 {own}", unit)
            found[f"{name} ({unit})" if unit else name] = values * scale
        return found

    def first_fractions(self):
        """(n,): the fraction of the first constituent at each node. Raises core.InvalidInput where that does not say
        all, since there are more than two constituents, or where it jumps."""
        values = np.full(len(self.points), np.nan)
        for region in self.regions:
            count = len(stored.texts(region.owner, "FGMConstituents"))
            if count != 2:
                raise core.InvalidInput(
                    f"{region.owner.Label} has {count} constituents, but the continuous mode knows two: "
                    "take bins"
                )
            nodes = self.nodes_of(region)
            fractions = region.node_fractions(self.points, nodes)[:, 0]
            jumps = np.abs(fractions - values[nodes]) > _JUMP  # never where there is no value yet
            if jumps.any():
                x, y, z = self.points[nodes[jumps][0]]
                raise core.InvalidInput(
                    f"the composition jumps where {region.owner.Label} touches another solid, as at "
                    f"({x:.6g}, {y:.6g}, {z:.6g}), which the continuous mode cannot tell the solver: "
                    "take bins"
                )
            values[nodes] = fractions
        return values


def graded_mesh(mesh):
    """The GradedMesh of an object that make_mesh() made.

    Raises core.InvalidInput where it is none, is not meshed or out of date, or where a solid has no constituents
    or no card of theirs; core.GeometryError for a reference that cannot be read.
    """
    check_current(mesh)
    points, tets = points_and_tets(mesh.FemMesh)
    owners = owners_of(mesh.Shape)
    solids = _solids_of_tets(mesh, len(owners), len(tets))
    kinds = {id(part): part for part in owners}
    regions = []
    for key, (owner, placement) in kinds.items():
        numbers = [number for number, part in enumerate(owners) if id(part) == key]
        chosen = np.flatnonzero(np.isin(solids, numbers))
        if len(chosen):
            material = core.read_references(material_of(owner, placement))
            regions.append(Region(owner, material, _cards(owner), chosen, tets[chosen, :4]))
    return GradedMesh(points, tets, solids, regions)


def check_current(mesh):
    """Raises core.InvalidInput where `mesh` is no mesh of ours that belongs to its solid as it is now."""
    if not mesh_object.is_mesh(mesh):
        raise core.InvalidInput(
            f"{getattr(mesh, 'Label', mesh)} is no graded mesh: select one that FGMesh has made, or make one of the solid"
        )
    mesh_object.update_status(mesh)
    if mesh.Status == mesh_object.NOT_MESHED:
        raise core.InvalidInput(f"{mesh.Label} is not meshed yet: mesh it first")
    if mesh.Status.startswith("out of date"):
        raise core.InvalidInput(f"{mesh.Label} is {mesh.Status}. Mesh it again first")


def _cards(owner):
    names = stored.texts(owner, "FGMConstituents")
    if not names:
        raise core.InvalidInput(
            f"{owner.Label} has no constituents, so its properties are not known: choose a material card for each in "
            "its graded material"
        )
    return constituents.values(names, owner.Document)


def _solids_of_tets(mesh, count, tets):
    """(tets,): the 0-based solid of each tetrahedron."""
    solids = np.zeros(tets, int)
    if count == 1:
        return solids
    solids[:] = -1
    fem_mesh = mesh.FemMesh
    for group in fem_mesh.Groups:
        name = fem_mesh.getGroupName(group)
        if name.startswith("Solid") and name[5:].isdigit():
            solids[np.array(fem_mesh.getGroupElements(group)) - 1] = int(name[5:]) - 1
    if (solids < 0).any():
        raise core.InvalidInput(
            f"{mesh.Label} does not tell which tetrahedra are in which solid: add Solid to its Groups and mesh it again"
        )
    return solids
