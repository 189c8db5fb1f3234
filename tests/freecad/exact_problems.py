# SPDX-License-Identifier: GPL-3.0-or-later
"""Graded solids whose displacements are known in closed form, as documents that a user could have made.

Each function takes a `Bench` and gives a function points (n, 3) -> displacements (n, 3), mm. Units mm, N, MPa.
"""
import math

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

from freecad.fgmesh import adapter


class Bench:
    """A document with one graded solid, its mesh, and constraints on its parts, which are found by places on them."""

    kind = "static"
    """Of the analysis; thermomech: temperatures are what is known."""

    def __init__(self, document, fgmesh, shape, formula, stiffness, poisson, **options):
        self.document, self.fgmesh, self.shape = document, fgmesh, shape
        self.part = document.addObject("Part::Feature", "Part")
        self.part.Shape = shape
        cards = [self.card(name, modulus, poisson) for name, modulus in zip(("Hard", "Soft"), stiffness)]
        document.recompute()
        fgmesh.attach_material(self.part, formula, constituents=cards)
        self.mesh = fgmesh.make_mesh(document, self.part)
        for name, value in options.items():
            setattr(self.mesh, name, value)
        self.constraints = []

    def constrain(self, kind, places, **values):
        """A constraint of makeConstraint<kind> on the parts of the shape at `places`, ("Face" or "Vertex", point); `values`
        are flags, and texts as "5 MPa"."""
        import ObjectsFem

        constraint = getattr(ObjectsFem, f"makeConstraint{kind}")(self.document, kind)
        constraint.References = [(self.part, self._name(*place)) for place in places]
        for name, value in values.items():
            if isinstance(value, bool):
                setattr(constraint, name, value)
            else:
                adapter.set_quantity(constraint, name, value)
        self.constraints.append(constraint)
        return constraint

    def hold(self, axes, *places):
        """Displacements of 0 along `axes`, as "xz"."""
        adapter.hold(self.constrain("Displacement", places), axes)

    def card(self, name, modulus, poisson):
        """Of a density and a conductivity proportional to its modulus."""
        import ObjectsFem

        card = ObjectsFem.makeMaterialSolid(self.document, name)
        card.Material = {
            "Name": name,
            "YoungsModulus": f"{modulus!r} MPa",
            "PoissonRatio": repr(poisson),
            "Density": f"{modulus!r} kg/m^3",
            "ThermalConductivity": f"{modulus / 100!r} W/m/K",
            "ThermalExpansionCoefficient": "12 um/m/K",
            "SpecificHeat": "500 J/kg/K",
        }
        return card

    def _name(self, kind, point):
        parts = getattr(self.shape, {"Face": "Faces", "Vertex": "Vertexes"}[kind])
        distances = [part.distToShape(Part.Vertex(*point))[0] for part in parts]
        return f"{kind}{1 + int(np.argmin(distances))}"


def solved(bench, fgmesh, mode, bins=100):
    """(result object, its nodes (n, 3)) of the problem, meshed and solved."""
    fgmesh.generate(bench.mesh)
    analysis = fgmesh.make_analysis(bench.mesh, mode=mode, bins=bins)
    analysis.addObjects(bench.constraints)
    (solver,) = (one for one in analysis.Group if hasattr(one, "AnalysisType"))
    solver.AnalysisType = bench.kind
    bench.document.recompute()
    (result,) = fgmesh.solve(analysis)
    nodes = bench.mesh.FemMesh.Nodes
    return result, np.array([tuple(nodes[node]) for node in result.NodeNumbers])


def largest_error(bench, result, exact):
    """At a node, of the largest displacement; of temperatures, of their range."""
    if bench.kind == "thermomech":
        return np.abs(np.array(result.Temperature) - exact).max() / np.ptp(exact)
    found = np.array([tuple(vector) for vector in result.DisplacementVectors])
    return np.linalg.norm(found - exact, axis=1).max() / np.linalg.norm(exact, axis=1).max()


def _hold_statically(bench, half):
    """At three corners of the end x = 0 of a prism of the half sides `half`, so that nothing is strained."""
    bench.hold("xyz", ("Vertex", (0, -half, -half)))
    bench.hold("xz", ("Vertex", (0, half, -half)))
    bench.hold("x", ("Vertex", (0, -half, half)))


def _less(field, place):
    """`field` but for the displacement at `place`, which is held."""
    return lambda points: field(points) - field(np.array([place], float))


def patch_test(document, fgmesh, **options):
    """A prism along x, E = E0/(1 + c x/L), under tension: u is quadratic."""
    length, stress, e0, c, nu, half = 10.0, 100.0, 1000.0, -7 / 8, 0.3, 1.0
    shape = Part.makeBox(length, 2 * half, 2 * half, Vector(0, -half, -half))
    formula = f"(1/(1 + {c}*x/{length}) - 1)/(1/(1 + {c}) - 1)"
    bench = Bench(document, fgmesh, shape, formula, (e0 / (1 + c), e0), nu, **options)
    for x in (0, length):
        bench.constrain("Pressure", [("Face", (x, 0, 0))], Pressure=f"{stress} MPa", Reversed=True)
    _hold_statically(bench, half)

    def displacement(points):
        x, y, z = points.T
        along = stress / e0 * (x + c * x**2 / (2 * length)) + nu * stress * c * (y**2 + z**2) / (
            2 * e0 * length
        )
        across = -nu * stress / e0 * (1 + c * x / length)
        return np.column_stack([along, across * y, across * z])

    return bench, _less(displacement, (0, -half, -half))


def exponential_bar(document, fgmesh, **options):
    """A prism along x, E = E0 exp(beta x/L), nu = 0, under tension."""
    length, stress, e0, beta, half = 10.0, 100.0, 1000.0, math.log(8), 1.0
    shape = Part.makeBox(length, 2 * half, 2 * half, Vector(0, -half, -half))
    formula = f"(exp({beta!r}*x/{length}) - 1)/7"
    bench = Bench(document, fgmesh, shape, formula, (8 * e0, e0), 0.0, **options)
    bench.constrain("Pressure", [("Face", (length, 0, 0))], Pressure=f"{stress} MPa", Reversed=True)
    bench.hold("xyz", ("Face", (0, 0, 0)))

    def displacement(points):
        along = stress * length / (e0 * beta) * (1 - np.exp(-beta * points[:, 0] / length))
        return np.column_stack([along, 0 * along, 0 * along])

    return bench, displacement


def graded_strip(document, fgmesh, **options):
    """A strip graded exponentially through its height y, pulled by forces that an even stress along x has: it bends.

    The true stress is not even over the pulled end, which is divided into bands, each under its mean.
    """
    length, width, depth, nu, stress, bands = 27.0, 9.0, 1.5, 0.3, 1e-3, 36
    b = math.log(8) / width
    i0, i1 = 7 / b, (8 * (b * width - 1) + 1) / b**2
    i2 = (8 * ((b * width) ** 2 - 2 * b * width + 2) - 2) / b**3
    force, moment = stress * width, stress * width**2 / 2
    bend = (moment * i0 - force * i1) / (i0 * i2 - i1**2)
    stretch = (force * i2 - moment * i1) / (i0 * i2 - i1**2)
    ends = np.linspace(0, width, bands + 1)
    cuts = [Part.makeLine((length, y, 0), (length, y, depth)) for y in ends[1:-1]]
    (shape,) = Part.makeBox(length, width, depth).generalFuse(cuts)[0].Solids
    bench = Bench(document, fgmesh, shape, f"(exp({b!r}*y) - 1)/7", (8.0, 1.0), nu, **options)
    # The integral of exp(b y) (bend y + stretch), of which the differences are the forces on the bands.
    forces = np.diff(np.exp(b * ends) * (bend * (b * ends - 1) / b**2 + stretch / b))
    for y, pull in zip((ends[1:] + ends[:-1]) / 2, forces / np.diff(ends)):
        bench.constrain("Pressure", [("Face", (length, y, depth / 2))], Pressure=f"{pull} MPa", Reversed=True)
    bench.hold("x", ("Face", (0, width / 2, depth / 2)))
    bench.hold("xyz", ("Vertex", (0, 0, 0)))
    bench.hold("xz", ("Vertex", (0, width, 0)))

    def displacement(points):
        x, y, z = points.T
        along = (bend * y + stretch) * x
        up = -nu * (stretch * y + bend * y**2 / 2) - bend * x**2 / 2 + nu * bend * z**2 / 2
        return np.column_stack([along, up, -nu * (bend * y + stretch) * z])

    return bench, displacement


def thick_cylinder(document, fgmesh, **options):
    """A quarter of a thick cylinder under pressure inside, between two plates: E = E0 (r/a)^beta (Horgan and Chan,
    J. Elasticity 55 (1999) 43)."""
    a, b, height, e0, nu, p, beta = 10.0, 20.0, 1.5, 1000.0, 0.3, 100.0, 3
    n, k = nu / (1 - nu), b / a
    root = math.sqrt(beta**2 + 4 - 4 * n * beta)
    m1, m2 = (-beta + root) / 2, (-beta - root) / 2
    d = e0 * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    big_a = p / d * k**m2 / ((m1 + n) * (k**m1 - k**m2))
    big_b = -p / d * k**m1 / ((m2 + n) * (k**m1 - k**m2))
    ring = Part.makeCylinder(b, height, Vector(), Vector(0, 0, 1), 90)
    shape = ring.cut(Part.makeCylinder(a, height, Vector(), Vector(0, 0, 1), 90))
    formula = f"((r/{a})^{beta} - 1)/({k}^{beta} - 1)"
    bench = Bench(document, fgmesh, shape, formula, (e0 * k**beta, e0), nu, **options)
    middle, diagonal = (a + b) / 2, a / math.sqrt(2)
    bench.constrain("Pressure", [("Face", (diagonal, diagonal, height / 2))], Pressure=f"{p} MPa")
    bench.hold(
        "z",
        ("Face", (middle / 2**0.5, middle / 2**0.5, 0)),
        ("Face", (middle / 2**0.5, middle / 2**0.5, height)),
    )
    bench.hold("y", ("Face", (middle, 0, height / 2)))
    bench.hold("x", ("Face", (0, middle, height / 2)))

    def displacement(points):
        r = np.hypot(points[:, 0], points[:, 1])
        radial = a * (big_a * (r / a) ** m1 + big_b * (r / a) ** m2)
        return points * (radial / r)[:, None] * [1, 1, 0]

    return bench, displacement


def conduction(document, fgmesh, **options):
    """A prism along x with its ends at 0 and 100 K, k = k0 exp(beta x/L). Gives temperatures (n,)."""
    length, beta, half, hot = 10.0, math.log(8), 1.0, 100.0
    shape = Part.makeBox(length, 2 * half, 2 * half, Vector(0, -half, -half))
    bench = Bench(
        document, fgmesh, shape, f"(exp({beta!r}*x/{length}) - 1)/7", (8000.0, 1000.0), 0.3, **options
    )
    bench.kind = "thermomech"
    bench.constrain("Temperature", [("Face", (0, 0, 0))], Temperature="0 K")
    bench.constrain("Temperature", [("Face", (length, 0, 0))], Temperature=f"{hot} K")
    bench.constrain("InitialTemperature", [], initialTemperature="0 K")
    bench.hold("xyz", ("Face", (0, 0, 0)))

    def temperature(points):
        return hot * (1 - np.exp(-beta * points[:, 0] / length)) / (1 - np.exp(-beta))

    return bench, temperature
