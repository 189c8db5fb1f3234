// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/reference_pieces.hpp"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>

#include "brep/occt.hpp"

namespace fgmesh::brep {
namespace {

// A chord is farthest from its curve near its middle, a triangle near its own or at a side's: twice what is
// found there covers the rest.
constexpr double kSafety = 2.0;

/// What faces and edges that should meet may miss each other by, mm.
double slack(const CheckedShape& shape) {
  const double diagonal = shape.bounds.diagonal();
  return std::min(shape.tolerance, 1e-4 * diagonal) + 1e-12 * diagonal;
}

Piece point_piece(const Vec3& point) { return {{point, point, point}}; }

/// Without thickness.
std::vector<Piece> triangles_of(const MeasuredShape& measured, int face) {
  const SampledBoundary& boundary = measured.sampling.boundary;
  const FaceProjector& projector = *measured.projections.faces[face - 1];
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    if (boundary.triangle_face[i] != face) continue;
    const auto& [a, b, c] = boundary.triangles[i];
    Piece piece{{boundary.points[a], boundary.points[b], boundary.points[c]}, face};
    if (!projector.has_closed_form()) {
      for (const Vec3& corner : piece.corners) {
        const std::array<double, 2> here = projector.curvatures(corner);
        for (int side = 0; side < 2; ++side) {
          piece.curvatures[side] = std::max(piece.curvatures[side], here[side]);
        }
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

double deviation_of(const std::vector<Piece>& triangles, const FaceProjector& projector,
                    RunControl& control) {
  double deviation = 0.0;
  for (const Piece& triangle : triangles) {
    control.check();
    const Vec3 middle = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
    deviation = std::max(deviation, (projector.project(middle).position - middle).norm());
  }
  return deviation;
}

}  // namespace

std::vector<Piece> pieces_of_vertex(const MeasuredShape& measured, int vertex) {
  return {point_piece(to_vec3(BRep_Tool::Pnt(measured.shape.topology.vertex(vertex))))};
}

std::vector<Piece> pieces_of_edge(const MeasuredShape& measured, int edge) {
  const Topology& topology = measured.shape.topology;
  if (topology.edge_use(edge).degenerate) {
    return pieces_of_vertex(measured, topology.vertex_number(TopExp::FirstVertex(topology.edge(edge))));
  }
  const EdgeProjector& projector = *measured.projections.edges[edge - 1];
  const std::vector<double>& parameters = projector.parameters();
  std::vector<Piece> pieces;
  double deviation = 0.0;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const Vec3 a = projector.at(parameters[i - 1]).position, b = projector.at(parameters[i]).position;
    const Vec3 middle = 0.5 * (a + b);
    deviation = std::max(deviation, (projector.project(middle).position - middle).norm());
    Piece piece{{a, b, b}, 0, edge};
    piece.low = parameters[i - 1];
    piece.high = parameters[i];
    pieces.push_back(piece);
  }
  for (Piece& piece : pieces) piece.thickness = kSafety * deviation + slack(measured.shape);
  return pieces;
}

std::vector<Piece> pieces_of_faces(const MeasuredShape& measured, const std::vector<int>& faces,
                                   RunControl& control) {
  const Topology& topology = measured.shape.topology;
  std::vector<Piece> pieces;
  std::set<int> done;
  for (const int face : faces) {
    std::vector<Piece> triangles = triangles_of(measured, face);
    double thickness = kSafety * deviation_of(triangles, *measured.projections.faces[face - 1], control) +
                       slack(measured.shape);
    for (TopExp_Explorer it(topology.face(face), TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = topology.edge_number(it.Current());
      if (topology.edge_use(edge).count == 0) continue;
      const std::vector<Piece> segments = pieces_of_edge(measured, edge);
      // A face reaches beyond its triangles as far as its edges do.
      for (const Piece& segment : segments) thickness = std::max(thickness, segment.thickness);
      if (done.insert(edge).second) pieces.insert(pieces.end(), segments.begin(), segments.end());
    }
    for (Piece& triangle : triangles) triangle.thickness = thickness;
    pieces.insert(pieces.end(), triangles.begin(), triangles.end());
  }
  return pieces;
}

}  // namespace fgmesh::brep
