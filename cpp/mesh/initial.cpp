// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/initial.hpp"

#include "domain/cgal_types.hpp"  // before CGAL's own headers: it replaces one of them

#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Random.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/version.h>

#include <sstream>
#include <unordered_map>

#include "core/error.hpp"
#include "domain/brep_domain.hpp"
#include "domain/crease_sizing.hpp"
#include "mesh/face_labels.hpp"
#include "mesh/worst_first.hpp"

namespace fgmesh {
namespace {

/// CGAL would print to standard error what its exception says as well.
void ignore_failure(const char*, const char*, const char*, int, const char*) {}

/// CreaseSizing as CGAL asks for it: by point, dimension and index.
struct EdgeSizeField {
  using FT = CgalKernel::FT;
  using Point_3 = CgalDomain::Point_3;
  using Index = CgalDomain::Index;

  const CreaseSizing* sizing;
  const BrepDomain* domain;
  double largest;

  FT operator()(const Point_3& p, int dimension, const Index& index) const {
    if (dimension == 0) return sizing->at_corner(to_vec3(p));
    if (dimension == 1)
      return sizing->on_curve(domain->curve_of_index[domain->domain->curve_index(index)], to_vec3(p));
    return largest;
  }
};

CgalComplex run_cgal(const BrepDomain& domain, const SampledBoundary& samples,
                     const InitialMeshOptions& options, RunControl& control) {
  namespace params = CGAL::parameters;
  using Criteria = CGAL::Mesh_criteria_3<CgalTriangulation>;
  const CreaseSizing sizing(samples, options.size);
  const EdgeSizeField edge_size{&sizing, &domain, options.size};
  const Criteria criteria(params::edge_size = edge_size, params::facet_angle = 25.0,
                          params::facet_size = options.size, params::facet_distance = options.deviation,
                          params::cell_radius_edge_ratio = 2.0, params::cell_size = options.size);
#if CGAL_VERSION_NR >= 1050600000
  const auto extra = params::mesh_3_options(params::pointer_to_stop_atomic_boolean(&control.stop_flag()));
#else
  auto extra = params::mesh_3_options();
  extra.pointer_to_stop_atomic_boolean = &control.stop_flag();
#endif
  CGAL::get_default_random() = CGAL::Random(options.seed);  // two runs give the same mesh
  return CGAL::make_mesh_3<CgalComplex>(*domain.domain, criteria, params::manifold(), params::no_perturb(),
                                        params::no_exude(), extra);
}

/// CGAL's mesh as plain tetrahedra and unlabelled boundary facets; fills state.vertices (positions
/// and dimensions only) and `creases` (two vertices and a position in SampledBoundary::curves).
void extract(const CgalComplex& mesh, const BrepDomain& domain, MeshState& state, std::vector<NewTet>& tets,
             std::vector<LabelledFacet>& facets, std::vector<std::array<int, 3>>& creases) {
  std::unordered_map<CgalTriangulation::Vertex_handle, int> number;
  const auto vertex = [&](const CgalTriangulation::Vertex_handle& handle) {
    const auto [place, fresh] = number.emplace(handle, static_cast<int>(state.vertices.size()));
    if (fresh) {
      state.vertices.emplace_back();
      state.vertices.back().position = to_vec3(handle->point());
      state.vertices.back().carrier = {handle->in_dimension() == 0 ? 0 : 3, 1};
    }
    return place->second;
  };
  for (auto cell = mesh.cells_in_complex_begin(); cell != mesh.cells_in_complex_end(); ++cell) {
    NewTet tet;
    for (int i = 0; i < 4; ++i) tet.vertex[i] = vertex(cell->vertex(i));
    tet.solid = 1;
    const auto& v = tet.vertex;
    if (orientation(state.position(v[0]), state.position(v[1]), state.position(v[2]), state.position(v[3])) <
        0.0)
      std::swap(tet.vertex[2], tet.vertex[3]);
    tets.push_back(tet);
  }
  for (auto facet = mesh.facets_in_complex_begin(); facet != mesh.facets_in_complex_end(); ++facet) {
    LabelledFacet made;
    for (int i = 0, k = 0; i < 4; ++i)
      if (i != facet->second) made.vertex[k++] = vertex(facet->first->vertex(i));
    facets.push_back(made);
  }
  for (auto edge = mesh.edges_in_complex_begin(); edge != mesh.edges_in_complex_end(); ++edge) {
    const auto index = mesh.curve_index(*edge);
    creases.push_back({vertex(edge->first->vertex(edge->second)), vertex(edge->first->vertex(edge->third)),
                       domain.curve_of_index[index]});
  }
}

/// Bringing vertices onto the true boundary may turn flat tetrahedra at it over: mends them.
void untangle(MeshState& state, RunControl& control) {
  const TetScore score(state, {10.0, 170.0, false});
  WorstFirst mender(state, score);
  mender.run(20, control);
  const std::vector<int> left = mender.bad_tets(0.0);
  if (left.empty()) return;
  Vec3 centre = Vec3::Zero();
  for (int v : state.complex.tet(left.front()).vertex) centre += 0.25 * state.position(v);
  std::ostringstream text;
  text << "the initial mesh folds over at " << left.size() << " tetrahedra, the first at " << Shown{centre}
       << " mm: the elements are too coarse for the shape there; lower MaxSize";
  throw GeometryError(text.str());
}

void mesh_once(MeshState& state, const SampledBoundary& samples, const InitialMeshOptions& options,
               RunControl& control) {
  std::vector<NewTet> tets;
  std::vector<LabelledFacet> facets;
  std::vector<std::array<int, 3>> creases;
  state.vertices.clear();
  try {
    const BrepDomain domain = make_brep_domain(samples);
    const CgalComplex mesh = run_cgal(domain, samples, options, control);
    control.check();
    extract(mesh, domain, state, tets, facets, creases);
  } catch (const CGAL::Failure_exception& error) {
    throw GeometryError(std::string("CGAL could not mesh the solid: ") + error.what());
  }
  if (tets.empty())
    throw GeometryError("the initial mesh is empty: the solid is thinner than its elements; lower MaxSize");

  carry_boundary_vertices(state, samples, creases, facets);
  for (Vertex& vertex : state.vertices) state.evaluate(vertex);
  state.complex.build(tets, facets, static_cast<int>(state.vertices.size()));
  for (const auto& [a, b, curve] : creases) state.complex.set_crease(a, b, samples.curves[curve].edge);
  untangle(state, control);
}

}  // namespace

void make_initial_mesh(MeshState& state, const SampledBoundary& samples, const InitialMeshOptions& options,
                       RunControl& control) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);  // a failed assertion would end the process otherwise
  CGAL::set_error_handler(ignore_failure);
  // A mesh too coarse for a detail of the shape loses or folds it; a finer one may not.
  constexpr int kAttempts = 3;
  InitialMeshOptions attempt = options;
  for (int left = kAttempts; left > 0; --left) {
    control.check();
    try {
      mesh_once(state, samples, attempt, control);
      return;
    } catch (const GeometryError&) {
      if (left == 1) throw;
    }
    attempt.size *= 0.5;
    attempt.deviation *= 0.4;
  }
}

}  // namespace fgmesh
