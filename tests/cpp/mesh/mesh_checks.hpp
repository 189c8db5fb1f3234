// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <random>
#include <string>

#include "analytic_solids.hpp"
#include "box_grid.hpp"
#include "fields.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh::test {

/// What is inconsistent in the connectivity, in words; empty where nothing is: neighbours know each other and
/// share the same three vertices, labels stand on exactly the boundary and the interfaces and are the same
/// from both sides, every vertex knows one of its tetrahedra, stars are complete, creases are edges of the
/// mesh.
std::string find_fault(const TetComplex& complex);

/// The same for a mesh in progress: its connectivity, what find_fault(TetMesh) checks, every vertex on its
/// carrier, corners in their place, and creases as long as the true edges (`crease_tolerance` of it missing
/// at most, where chords stand for arcs).
std::string find_fault(const MeshState& state, const AnalyticSolid& solid, double crease_tolerance = 1e-9);

double volume_of(const MeshState& state);
int vertex_count(const MeshState& state);
double largest_variation(const MeshState& state);
AngleRange angle_range(const MeshState& state);

/// Puts the arrays of a finished mesh into a mesh in progress; vertices get the size `size`.
void load(MeshState& state, const TetMesh& mesh, double size);

/// A cube at the origin as a grid of cells.
struct GridMesh {
  GridMesh(double side, int cells, FunctionField material = constant(0.5), double threshold = 0.1);
  GridMesh(const GridMesh&) = delete;  // the state refers to its neighbours here

  /// Moves every inner vertex, and those on faces and edges along them, by up to `part` of a cell, as far as
  /// no tetrahedron is turned over.
  void shake(double part, unsigned seed);

  double side;
  int cells;
  BoxSolid solid;
  FunctionField field;
  MeshState state;
};

}  // namespace fgmesh::test
