// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/expected_tets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/steiner_points.hpp"
#include "mesh/stretch.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

// Fitted to some 130 meshes of 30 parts, from 200 to 200000 tetrahedra; bench/estimate shows what they are
// worth. Tetrahedra ...
constexpr double kMaterialTets = 6.5;   // ... in a cube in which a linear f varies by the threshold
constexpr double kStretch = 1.7;        // power of the stretch by which they are fewer; 2 far from boundaries
constexpr double kDeviationTets = 9.3;  // ... in a cube of the edge that the surface deviation wants
/// Edges shorter than two MinSize are left as they are, so the mean is about 1.4: 8.5 regular tetrahedra fill
/// the cube of their edge.
constexpr double kFinestTets = 8.5 / (1.4 * 1.4 * 1.4);  // in a cube of MinSize

double cube(double x) { return x * x * x; }

/// What is known at a corner of a piece.
struct Corner {
  Vec3 place = Vec3::Zero();
  Composition composition;  ///< NaN where it is not defined
  double slope = 0.0;       ///< |grad f|, 1/mm
  double stretch = 1.0;     ///< of elements across the gradient
  double initial = 0.0;     ///< size that the initial mesh is to have, mm; infinite where it has it
  double deviation = 0.0;   ///< size that the surface deviation asks for, mm
};

/// A part of a tetrahedron of the initial mesh.
struct Piece {
  std::array<Corner, 4> corner;
  int solid = 0, material = 0;
  double own = 0.0;     ///< density of the mesh at hand, 1/mm^3
  double flat = 0.0;    ///< the same times the area of the largest face of the tetrahedron, 1/mm
  double volume = 0.0;  ///< mm^3
  double tets = 0.0;    ///< expected in it

  bool operator<(const Piece& other) const { return tets < other.tets; }
};

class Division {
 public:
  Division(const MeshState& state, const WantedMesh& wanted) : state_(state), wanted_(wanted) {
    for (int t = 0; t < state.complex.slots(); ++t)
      if (state.complex.tet(t).alive()) pieces_.push_back(whole(t));
    std::make_heap(pieces_.begin(), pieces_.end());
  }

  /// Halves pieces, those with most tetrahedra first, until none has many or there are enough.
  void run(RunControl& control) {
    constexpr double kMany = 20.0;
    constexpr std::size_t kEnough = 60000;
    const std::size_t most = pieces_.size() + kEnough;
    while (pieces_.size() < most && pieces_.front().tets > kMany) {
      if (pieces_.size() % 256 == 0) control.check();
      std::pop_heap(pieces_.begin(), pieces_.end());
      const Piece second = halve(pieces_.back());
      std::push_heap(pieces_.begin(), pieces_.end());
      pieces_.push_back(second);
      std::push_heap(pieces_.begin(), pieces_.end());
    }
  }

  double tets() const {
    double sum = 0.0;
    for (const Piece& piece : pieces_) sum += piece.tets;
    return sum;
  }

 private:
  Piece whole(int t) const {
    const Tet& tet = state_.complex.tet(t);
    Piece piece;
    piece.solid = tet.solid;
    piece.material = state_.material(t);
    for (int i = 0; i < 4; ++i) {
      const Vertex& vertex = state_.vertices[tet.vertex[i]];
      Corner& corner = piece.corner[i];
      corner.place = vertex.position;
      put_material(vertex.in(piece.material), corner);
      put_sizes(corner);
    }
    const auto& [a, b, c, d] = piece.corner;
    piece.volume = signed_volume(a.place, b.place, c.place, d.place);
    piece.own = 1.0 / piece.volume;
    for (const auto& [i, j, k] : kFaceVertices)
      piece.flat = std::max(
          piece.flat,
          0.5 * piece.own *
              area_vector(piece.corner[i].place, piece.corner[j].place, piece.corner[k].place).norm());
    piece.tets = tets_in(piece);
    return piece;
  }

  void put_material(const MaterialValue& found, Corner& corner) const {
    corner.composition = found.composition;
    const Vec3 gradient = steepest(found.gradient);
    corner.slope = gradient.norm();
    corner.stretch = 1.0 + stretch_at(state_.materials().field(found.material), corner.place, gradient,
                                      wanted_.sizing.at(gradient), wanted_.sizing)
                               .norm();
  }

  void put_sizes(Corner& corner) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    corner.initial = wanted_.max_size > 0.0 ? wanted_.initial.at(corner.place, wanted_.max_size) : kInfinity;
    corner.deviation = wanted_.deviation.at(corner.place, kInfinity);
  }

  Corner corner_at(const Vec3& place, const Piece& piece) const {
    Corner corner;
    corner.place = place;
    MaterialValue found;
    found.material = piece.material;
    if (state_.evaluate(place, {3, piece.solid}, found)) {
      put_material(found, corner);
    } else {
      corner.composition.assign(found.composition.size(), std::numeric_limits<double>::quiet_NaN());
    }
    put_sizes(corner);
    return corner;
  }

  /// Leaves one half of the piece in its place, and returns the other.
  Piece halve(Piece& piece) const {
    const auto length = [&](const int* edge) {
      return (piece.corner[edge[0]].place - piece.corner[edge[1]].place).squaredNorm();
    };
    const int* longest = kEdgeVertices[0];
    for (const auto& edge : kEdgeVertices)
      if (length(edge) > length(longest)) longest = edge;
    const int a = longest[0], b = longest[1];
    const Corner middle = corner_at(0.5 * (piece.corner[a].place + piece.corner[b].place), piece);
    Piece other = piece;
    piece.corner[b] = other.corner[a] = middle;
    for (Piece* half : {&piece, &other}) {
      half->volume *= 0.5;
      half->tets = tets_in(*half);
    }
    return other;
  }

  /// A slope that f has between the corners and not at them, as in a steep layer. A jump is none: no
  /// tetrahedra are spent on it.
  double hidden_slope(const Piece& piece) const {
    double highest = 0.0;
    for (const auto& [i, j] : kEdgeVertices) {
      const Corner &a = piece.corner[i], &b = piece.corner[j];
      const double change = difference(a.composition, b.composition), length = (a.place - b.place).norm();
      const double foretold = std::max(a.slope, b.slope) * length;
      if (!(change > wanted_.threshold) || change <= 3.0 * foretold + 0.5 * wanted_.threshold ||
          jumps_between(state_.materials().field(piece.material), a.place, b.place, wanted_.threshold))
        continue;
      highest = std::max(highest, change / length);
    }
    return highest;
  }

  /// Where elements of this size are thicker than a wall, what counts is how many triangles cover it.
  static double density_of(double size, double in_cube, const Piece& piece) {
    // An equilateral triangle of unit area has a squared edge of 2.3; walls of parts get somewhat more.
    constexpr double kTriangle = 2.7;
    return std::max(in_cube / cube(size), kTriangle * piece.flat / (size * size));
  }

  /// Where two densities are about the same there are more tetrahedra than either asks for: squares add up.
  double tets_in(const Piece& piece) const {
    const double hidden = wanted_.material ? hidden_slope(piece) : 0.0;
    double sum = 0.0;
    for (const Corner& corner : piece.corner) {
      double density = std::max(piece.own, density_of(corner.initial, kInitialTets, piece));
      if (wanted_.material) {
        const double steep = std::max(hidden, corner.slope) / wanted_.threshold;
        const double finest = kFinestTets / cube(wanted_.sizing.min_size);
        density = std::hypot(
            density, std::min(finest, kMaterialTets * cube(steep) / std::pow(corner.stretch, kStretch)));
      }
      sum += std::hypot(density, density_of(corner.deviation, kDeviationTets, piece));
    }
    return 0.25 * sum * piece.volume;
  }

  const MeshState& state_;
  const WantedMesh& wanted_;
  std::vector<Piece> pieces_;  ///< a heap
};

}  // namespace

double expected_tets(const MeshState& state, const WantedMesh& wanted, RunControl& control) {
  Division division(state, wanted);
  division.run(control);
  return division.tets();
}

}  // namespace fgmesh
