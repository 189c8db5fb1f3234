// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brep/piece_tree.hpp"
#include "brep/projections.hpp"
#include "brep/sampling.hpp"
#include "brep/shape_check.hpp"
#include "core/run_control.hpp"

namespace fgmesh::brep {

/// A sampled shape to whose parts distances are measured; they share it.
struct MeasuredShape {
  CheckedShape shape;
  Sampling sampling;
  Projections projections;
};

// The pieces of a part of the shape, which must bound a solid. Faces come with their edges: the nearest point
// of a face is inside of it or on one of them.
std::vector<Piece> pieces_of_vertex(const MeasuredShape& measured, int vertex);
std::vector<Piece> pieces_of_edge(const MeasuredShape& measured, int edge);
std::vector<Piece> pieces_of_faces(const MeasuredShape& measured, const std::vector<int>& faces,
                                   RunControl& control);

}  // namespace fgmesh::brep
