// SPDX-License-Identifier: GPL-3.0-or-later
/// A mesh by CGAL's own means: Delaunay refinement with the sizes C / |grad f|, CGAL's ODT smoothing,
/// perturbation.
///
///     cgal_refinement SURFACE.off FORMULA C LARGEST OUT.mesh
///
/// SURFACE is a fine closed triangulation of the part, whose creases are found by their angle and protected.
/// Edges, facets and cells get the same size, since a coarse crease spoils the mesh around it. Writes a Medit
/// mesh; prints the seconds without reading and writing as JSON.
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "domain/cgal_types.hpp"
#include "material/material.hpp"

namespace {

using fgmesh::CgalKernel;
using Polyhedron = CGAL::Mesh_polyhedron_3<CgalKernel>::type;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<CgalKernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex =
    CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Clock = std::chrono::steady_clock;
namespace parameters = CGAL::parameters;

constexpr double kCreaseAngle = 40.0;     // degrees
constexpr double kSmallestAngle = 12.0;   // degrees, that perturbation is asked for
constexpr double kPartOfSmoothing = 0.5;  // of what refinement took

struct Sizes {
  using FT = double;
  using Index = Domain::Index;
  const fgmesh::Material* material;
  double constant, largest;

  FT operator()(const CgalKernel::Point_3& p, int, const Index&) const {
    const fgmesh::Vec3 point(p.x(), p.y(), p.z());
    double value = 0.0;
    fgmesh::Vec3 gradient;
    material->evaluate(&point, 1, &value, &gradient);
    return constant / std::max(gradient.norm(), constant / largest);
  }
};

Polyhedron surface_in(const char* path) {
  Polyhedron surface;
  std::ifstream file(path);
  if (!(file >> surface) || !surface.is_closed())
    throw std::runtime_error(std::string(path) + " is no closed surface");
  return surface;
}

Complex refine(const Domain& domain, const Sizes& sizes) {
  const Criteria criteria(parameters::edge_size = sizes, parameters::facet_angle = 25.0,
                          parameters::facet_size = sizes, parameters::cell_radius_edge_ratio = 2.0,
                          parameters::cell_size = sizes);
  return CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
}

void improve(Complex& mesh, const Domain& domain, double refining) {
  CGAL::odt_optimize_mesh_3(mesh, domain, parameters::max_iteration_number = 40);
  CGAL::perturb_mesh_3(mesh, domain, parameters::sliver_bound = kSmallestAngle,
                       parameters::time_limit = std::max(1.0, kPartOfSmoothing * refining));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 6) throw std::invalid_argument("usage: cgal_refinement SURFACE.off FORMULA C LARGEST OUT.mesh");
  const fgmesh::Material material({argv[2]});
  const Polyhedron surface = surface_in(argv[1]);
  const auto start = Clock::now();
  Domain domain(surface);
  domain.detect_features(kCreaseAngle);
  Complex mesh = refine(domain, {&material, std::stod(argv[3]), std::stod(argv[4])});
  const std::chrono::duration<double> refining = Clock::now() - start;
  improve(mesh, domain, refining.count());
  const std::chrono::duration<double> seconds = Clock::now() - start;
  std::ofstream file(argv[5]);
  file.precision(17);
  mesh.output_to_medit(file, false, true);  // each triangle once
  if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + argv[5]);
  std::cout << "{\"seconds\": " << seconds.count() << "}\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "cgal_refinement: " << error.what() << '\n';
  return 1;
}
