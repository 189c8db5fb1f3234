// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "brep/sampling.hpp"
#include "brep/surface.hpp"

namespace fgmesh::brep {

/// Which part of its surface a face covers, answered quickly: a grid over the face in its parameter plane
/// whose cells lie inside, outside or on the border; only in the last the border's segments are looked at.
class FaceDomain {
 public:
  enum class Place : std::uint8_t { inside, outside, border };

  explicit FaceDomain(const FaceSamples& samples);

  const Uv& low() const { return low_; }
  const Uv& high() const { return high_; }

  /// `border`: so close to a free border that neither its segments nor its curve can tell.
  Place locate(const Uv& uv) const;

 private:
  struct Segment {  // in units of cells
    double x0, y0, x1, y1;
    double band;  ///< distance within which the true border may lie; 0 where it is not free
    Handle(Geom2d_Curve) curve;
    std::array<double, 2> parameters;
  };
  enum class Side : std::uint8_t { beside, between, on, unknown };

  void mark_border(const Segment& segment);
  Side side_of_curve(const Segment& segment, double x, double y) const;
  void fill_rows();
  Place locate_by_segments(double x, double y) const;

  Uv low_{}, high_{};
  int cells_ = 0;       ///< in each direction
  double reach_ = 0.0;  ///< largest band, in cells: the face ends before that beyond the grid
  std::vector<Segment> segments_;
  std::vector<Place> places_;
};

}  // namespace fgmesh::brep
