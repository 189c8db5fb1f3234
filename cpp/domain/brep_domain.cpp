// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/brep_domain.hpp"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <iterator>

#include "core/error.hpp"

namespace fgmesh {
namespace {

CgalPolyhedron make_polyhedron(const SampledBoundary& samples) {
  std::vector<CgalKernel::Point_3> points;
  points.reserve(samples.points.size());
  for (const Vec3& p : samples.points) points.push_back(to_cgal(p));
  std::vector<std::vector<std::size_t>> triangles;
  triangles.reserve(samples.triangles.size());
  for (const auto& [a, b, c] : samples.triangles)
    triangles.push_back(
        {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});

  namespace pmp = CGAL::Polygon_mesh_processing;
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles))
    throw GeometryError(
        "the sampled boundary of the solid is no manifold surface; Part > Check geometry may tell where");
  CgalPolyhedron polyhedron;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, polyhedron);
  if (!CGAL::is_closed(polyhedron))
    throw GeometryError(
        "the sampled boundary of the solid is not closed; Part > Check geometry may tell where");
  return polyhedron;
}

}  // namespace

BrepDomain make_brep_domain(const SampledBoundary& samples) {
  BrepDomain result;
  result.surface = std::make_unique<CgalPolyhedron>(make_polyhedron(samples));
  result.domain = std::make_unique<CgalDomain>(*result.surface);

  for (const SampledBoundary::Corner& corner : samples.corners)
    result.domain->add_corner(to_cgal(samples.points[corner.point]));
  std::vector<std::vector<CgalKernel::Point_3>> polylines;
  polylines.reserve(samples.curves.size());
  for (const SampledBoundary::Curve& curve : samples.curves) {
    std::vector<CgalKernel::Point_3> line;
    line.reserve(curve.points.size());
    for (int p : curve.points) line.push_back(to_cgal(samples.points[p]));
    polylines.push_back(std::move(line));
  }
  std::vector<CgalDomain::Curve_index> indices;
  result.domain->add_features(polylines.begin(), polylines.end(), std::back_inserter(indices));
  for (std::size_t curve = 0; curve < indices.size(); ++curve) {
    const auto index = static_cast<std::size_t>(indices[curve]);
    if (result.curve_of_index.size() <= index) result.curve_of_index.resize(index + 1, -1);
    result.curve_of_index[index] = static_cast<int>(curve);
  }
  return result;
}

}  // namespace fgmesh
