// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wall_thickness.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "domain/cgal_types.hpp"

namespace fgmesh {

using Triangles = std::vector<CgalKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<CgalKernel, Triangles::const_iterator>;

struct WallThickness::Tree {
  Triangles triangles;
  std::vector<int> faces;
  std::vector<std::array<int, 2>> solids;
  std::set<std::array<int, 2>>
      wedges;  ///< faces that meet at an edge; twice the same where its seam is sharp
  CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, Primitive>> boxes;
};

WallThickness::WallThickness(const SampledBoundary& samples) : tree_(std::make_unique<Tree>()) {
  for (std::size_t i = 0; i < samples.triangles.size(); ++i) {
    const auto& [a, b, c] = samples.triangles[i];
    const CgalKernel::Triangle_3 triangle(to_cgal(samples.points[a]), to_cgal(samples.points[b]),
                                          to_cgal(samples.points[c]));
    if (triangle.is_degenerate()) continue;
    tree_->triangles.push_back(triangle);
    tree_->faces.push_back(samples.triangle_face[i]);
    tree_->solids.push_back(samples.triangle_solids[i]);
  }
  for (const SampledBoundary::Curve& curve : samples.curves)
    for (int one : curve.faces)
      for (int other : curve.faces)
        if (one != other || curve.faces.size() == 1) tree_->wedges.insert({one, other});
  tree_->boxes.insert(tree_->triangles.begin(), tree_->triangles.end());
  tree_->boxes.build();
}

WallThickness::~WallThickness() = default;

double WallThickness::at(const Vec3& point, const Vec3& inward, int solid, int face) const {
  const CgalKernel::Point_3 start = to_cgal(point);
  const CgalKernel::Vector_3 way(inward.x(), inward.y(), inward.z());
  const auto normal = [](const CgalKernel::Triangle_3& triangle) {
    return CGAL::normal(triangle[0], triangle[1], triangle[2]);
  };
  // Only where the ray leaves the solid: the samples of the face that it starts on may lie before the point.
  const auto is_no_exit = [&](Triangles::const_iterator triangle) {
    const auto& [behind, before] = tree_->solids[triangle - tree_->triangles.cbegin()];
    const double along = way * normal(*triangle);
    return !(behind == solid && along > 0.0) && !(before == solid && along < 0.0);
  };
  const auto exit = tree_->boxes.first_intersected_primitive(CgalKernel::Ray_3(start, way), is_no_exit);
  if (!exit) return std::numeric_limits<double>::infinity();
  const CgalKernel::Vector_3 out = normal(**exit);
  // In a blunter wedge than 12 degrees elements that grow from its edge are short enough for its thickness.
  constexpr double kBlunt = 0.978;
  const int other = tree_->faces[*exit - tree_->triangles.cbegin()];
  const bool is_blunt = out * way < kBlunt * std::sqrt(out.squared_length());
  if ((is_blunt || other == face) && tree_->wedges.count({face, other}))
    return std::numeric_limits<double>::infinity();
  return (out * ((**exit)[0] - start)) / (out * way);
}

}  // namespace fgmesh
