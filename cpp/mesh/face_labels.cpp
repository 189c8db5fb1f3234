// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/face_labels.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"

namespace fgmesh {
namespace {

using EdgeKey = std::pair<int, int>;
EdgeKey edge_key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Facets joined by edges that are no creases, and the faces that meet at its bounding creases.
struct Patch {
  std::vector<int> facets;
  std::set<int> candidates;
};

std::vector<Patch> make_patches(const std::vector<LabelledFacet>& facets,
                                const std::map<EdgeKey, int>& crease_curve, const SampledBoundary& samples) {
  std::map<EdgeKey, std::vector<int>> at_edge;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (int i = 0; i < 3; ++i)
      at_edge[edge_key(facets[f].vertex[i], facets[f].vertex[(i + 1) % 3])].push_back(static_cast<int>(f));

  std::vector<Patch> patches;
  std::vector<char> seen(facets.size(), 0);
  for (std::size_t first = 0; first < facets.size(); ++first) {
    if (seen[first]) continue;
    Patch patch;
    patch.facets.push_back(static_cast<int>(first));
    seen[first] = 1;
    for (std::size_t next = 0; next < patch.facets.size(); ++next) {
      const std::array<int, 3>& v = facets[patch.facets[next]].vertex;
      for (int i = 0; i < 3; ++i) {
        const EdgeKey key = edge_key(v[i], v[(i + 1) % 3]);
        if (const auto crease = crease_curve.find(key); crease != crease_curve.end()) {
          const std::vector<int>& faces = samples.curves[crease->second].faces;
          patch.candidates.insert(faces.begin(), faces.end());
          continue;
        }
        for (int other : at_edge[key]) {
          if (seen[other]) continue;
          seen[other] = 1;
          patch.facets.push_back(other);
        }
      }
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

/// The candidate to which a few facets of the patch are closest.
int nearest_face(const MeshState& state, const Patch& patch, const std::vector<LabelledFacet>& facets) {
  constexpr std::size_t kProbes = 12;
  const std::size_t step = std::max<std::size_t>(1, patch.facets.size() / kProbes);
  int best = 0;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int face : patch.candidates) {
    double distance = 0.0;
    for (std::size_t i = 0; i < patch.facets.size(); i += step) {
      const std::array<int, 3>& v = facets[patch.facets[i]].vertex;
      const Vec3 centre = (state.position(v[0]) + state.position(v[1]) + state.position(v[2])) / 3.0;
      distance += (state.boundary().project_to_face(face, centre).position - centre).norm();
    }
    if (distance < best_distance) {
      best_distance = distance;
      best = face;
    }
  }
  return best;
}

void check_every_face_is_there(const SampledBoundary& samples, const std::vector<LabelledFacet>& facets) {
  std::set<int> missing(samples.triangle_face.begin(), samples.triangle_face.end());
  for (const LabelledFacet& facet : facets) missing.erase(facet.label);
  if (missing.empty()) return;
  std::ostringstream text;
  text << "the initial mesh lost Face" << *missing.begin();
  if (missing.size() > 1) text << " and " << missing.size() - 1 << " more faces";
  text << ": a wall or a face there is smaller than the elements; lower MaxSize";
  throw GeometryError(text.str());
}

/// Gives CGAL's corners, which keep the coordinates of the samples, their VertexN. A corner that bounds no
/// curve any more (the tip of a cone) counts too.
void carry_corners(MeshState& state, const SampledBoundary& samples) {
  std::map<std::array<double, 3>, int> vertex_at;
  for (const SampledBoundary::Corner& corner : samples.corners) {
    const Vec3& p = samples.points[corner.point];
    vertex_at[{p.x(), p.y(), p.z()}] = corner.vertex;
  }
  for (Vertex& vertex : state.vertices) {
    if (vertex.carrier.dimension != 0) continue;
    const Vec3& p = vertex.position;
    const auto found = vertex_at.find({p.x(), p.y(), p.z()});
    if (found == vertex_at.end())
      throw GeometryError("the initial mesh has a corner that is no vertex of the shape");
    vertex.carrier.number = found->second;
    vertex.position = state.boundary().vertex_position(found->second);
  }
}

}  // namespace

void carry_boundary_vertices(MeshState& state, const SampledBoundary& samples,
                             const std::vector<std::array<int, 3>>& creases,
                             std::vector<LabelledFacet>& facets) {
  std::map<EdgeKey, int> crease_curve;
  for (const auto& [a, b, curve] : creases) crease_curve[edge_key(a, b)] = curve;

  std::set<int> faces_without_crease(samples.triangle_face.begin(), samples.triangle_face.end());
  for (const SampledBoundary::Curve& curve : samples.curves)
    for (int face : curve.faces) faces_without_crease.erase(face);

  for (Patch& patch : make_patches(facets, crease_curve, samples)) {
    if (patch.candidates.empty()) patch.candidates = faces_without_crease;
    const int label = nearest_face(state, patch, facets);
    if (label == 0)
      throw GeometryError("the initial mesh has a boundary patch that belongs to no face of the shape");
    for (int f : patch.facets) facets[f].label = label;
  }
  check_every_face_is_there(samples, facets);

  const auto carry = [&](int v, Carrier carrier) {
    if (state.vertices[v].carrier.dimension > carrier.dimension) state.vertices[v].carrier = carrier;
  };
  for (const auto& [a, b, curve] : creases)
    for (int v : {a, b}) carry(v, {1, samples.curves[curve].edge});
  for (const LabelledFacet& facet : facets)
    for (int v : facet.vertex) carry(v, {2, facet.label});
  carry_corners(state, samples);

  for (Vertex& vertex : state.vertices) vertex = state.carried(vertex, vertex.position, false);
}

}  // namespace fgmesh
