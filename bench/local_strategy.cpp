// SPDX-License-Identifier: GPL-3.0-or-later
/// The strategy that the paper argues against (section 1, after Chiu et al.): from the same initial mesh,
/// Steiner points into the tetrahedra above the threshold, again and again until none is; nothing is smoothed
/// or swapped.
///
///     local_strategy longest|steepest PART.brep FORMULA THRESHOLD OUT.mesh
///
/// "steepest" halves the edge on which f varies most: few tetrahedra, as flat as they happen to become.
/// "longest" halves the last edge of the longest-edge propagation path (Rivara 1997), which keeps shapes.
///
/// Writes a Medit mesh; prints seconds (reading and writing apart) and tetrahedra left above, as JSON.
#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "brep/brep_model.hpp"
#include "material/material.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/initial.hpp"
#include "mesh/steiner_points.hpp"
#include "quality/validity.hpp"

namespace {

using namespace fgmesh;

std::string content(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(std::string("cannot read ") + path);
  return text.str();
}

void write_medit(const TetMesh& mesh, const char* path) {
  std::ofstream file(path);
  file.precision(17);
  file << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.size() << '\n';
  for (const Vec3& p : mesh.points) file << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
  file << "Triangles\n" << mesh.triangles.size() << '\n';
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const int v : mesh.triangles[i]) file << v + 1 << ' ';
    file << mesh.triangle_faces[i] << '\n';
  }
  file << "Tetrahedra\n" << mesh.tets.size() << '\n';
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    for (const int v : mesh.tets[i]) file << v + 1 << ' ';
    file << mesh.tet_solids[i] << '\n';
  }
  file << "End\n";
  if (!file.flush()) throw std::runtime_error(std::string("cannot write ") + path);
}

struct LongestEdge {
  int a = -1, b = -1;
  double squared = 0.0;
};

LongestEdge longest_edge(const MeshState& state, int t) {
  LongestEdge best;
  const auto& v = state.complex.tet(t).vertex;
  for (const auto& [i, j] : kEdgeVertices) {
    const double squared = (state.position(v[i]) - state.position(v[j])).squaredNorm();
    if (squared > best.squared) best = {v[i], v[j], squared};
  }
  return best;
}

/// Halves the edge at the end of the longest-edge propagation path of tetrahedron t: the longest of all that
/// share it. True where the mesh has changed.
bool split_longest(MeshState& state, int t) {
  LongestEdge edge = longest_edge(state, t);
  EdgeRing ring;
  for (bool longer = true; longer;) {
    longer = false;
    state.complex.ring(edge.a, edge.b, t, ring);
    for (const int around : ring.tet) {
      const LongestEdge other = longest_edge(state, around);
      if (other.squared <= edge.squared) continue;
      edge = other;
      t = around;
      longer = true;
    }
  }
  return split_edge(state, edge.a, edge.b, t) >= 0;
}

/// One round over the tetrahedra above the threshold. Returns how many points were inserted.
int insert_on_longest_edges(MeshState& state, RunControl& control) {
  int inserted = 0;
  for (int t = 0, before = state.complex.slots(); t < before; ++t) {
    if (t % 1024 == 0) control.check();
    if (state.complex.tet(t).alive() && state.variation(t) > state.threshold())
      inserted += split_longest(state, t);
  }
  return inserted;
}

/// Lengths as in the pipeline, so that all strategies start from the same initial mesh.
void refine_locally(MeshState& state, const SampledBoundary& samples, bool longest, RunControl& control) {
  const double max_size = state.diagonal() / 8.0;
  constexpr std::size_t kMostPoints = 2000000;
  state.chord_limit = max_size / 20.0;
  make_initial_mesh(state, samples, {max_size, state.chord_limit}, control);
  state.min_size = state.diagonal() / 2000.0;
  int inserted = 1;
  while (inserted > 0 && state.vertices.size() < kMostPoints)
    inserted = longest ? insert_on_longest_edges(state, control)
                       : insert_steiner_points(state, state.threshold(), kMostPoints, control);
}

void run(bool longest, const char* part, const char* formula, const char* threshold, const char* out) {
  const Material material({formula});
  RunControl control;
  BrepModel model = BrepModel::from_text(content(part), control);
  const auto start = std::chrono::steady_clock::now();
  const SampledBoundary samples = model.sample({}, control);
  MeshState state(model, material, std::stod(threshold), samples.bounds.diagonal());
  refine_locally(state, samples, longest, control);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  const TetMesh mesh = state.to_tet_mesh();
  if (const std::string fault = find_fault(mesh); !fault.empty()) throw std::runtime_error(fault);
  write_medit(mesh, out);
  std::cout << "{\"seconds\": " << seconds.count() << ", \"left\": " << count_above(state, state.threshold())
            << "}\n";
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string edge = argc == 6 ? argv[1] : "";
  if (edge != "longest" && edge != "steepest")
    throw std::invalid_argument(
        "usage: local_strategy longest|steepest PART.brep FORMULA THRESHOLD OUT.mesh");
  run(edge == "longest", argv[2], argv[3], argv[4], argv[5]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "local_strategy: " << error.what() << '\n';
  return 1;
}
