// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/certification.hpp"

#include <algorithm>
#include <cstdint>

#include "core/parallel.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/steiner_points.hpp"
#include "mesh/worst_first.hpp"

namespace fgmesh {
namespace {

/// Pieces that a tetrahedron is divided into, at first and where that is not enough: those that need little
/// are not to wait for those that no number of pieces proves.
constexpr int kPieces[] = {48, 300, 2000};
/// In the mean of all that are looked at there are no more of them; then what is open remains so.
constexpr int kMeanPieces = 100;

Corners corners_of(const MeshState& state, int t) {
  const std::array<int, 4>& v = state.complex.tet(t).vertex;
  return {state.position(v[0]), state.position(v[1]), state.position(v[2]), state.position(v[3])};
}

/// The certificates of a mesh in progress: each is made once, and anew where its tetrahedron has changed.
class Certificates {
 public:
  explicit Certificates(const MeshState& state) : state_(state) {}

  /// Those of all tetrahedra that changed since the last call.
  void update(RunControl& control) {
    std::vector<int> open = changed();
    budget_ += std::int64_t{kMeanPieces} * static_cast<std::int64_t>(open.size());
    for (const int pieces : kPieces) {
      // In batches, so that what is left out does not depend on how many are worked on at the same time.
      constexpr std::size_t kBatch = 256;
      for (std::size_t begin = 0; begin < open.size(); begin += kBatch) {
        if (pieces > kPieces[0] && effort_ >= budget_) return;
        const std::size_t end = std::min(begin + kBatch, open.size());
        certify({open.begin() + begin, open.begin() + end}, pieces, control);
      }
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](int t) { return certificates_[t].proof != Proof::kUnproved; }),
                 open.end());
    }
  }

  /// What is to be divided, worst first: the tetrahedra that break the threshold though their corners keep
  /// it; where there are none any more those that nothing was proved of, if few. Many are the formula's
  /// fault.
  std::vector<int> to_divide() const {
    constexpr double kFew = 0.05;
    std::vector<int> tets = hidden(Proof::kBroken);
    if (!tets.empty()) return tets;
    tets = hidden(Proof::kUnproved);
    return tets.size() <= kFew * state_.complex.tet_count() ? tets : std::vector<int>{};
  }

  const TetCertificate& operator[](int t) const { return certificates_[t]; }
  const std::vector<TetCertificate>& all() const { return certificates_; }

 private:
  std::vector<int> changed() {
    const int slots = state_.complex.slots();
    certificates_.resize(slots);
    of_.resize(slots);
    solid_.resize(slots, 0);
    std::vector<int> tets;
    for (int t = 0; t < slots; ++t) {
      const int solid = state_.complex.tet(t).solid;
      const bool same = solid == solid_[t] && (solid == 0 || of_[t] == corners_of(state_, t));
      solid_[t] = solid;
      if (same || solid == 0) continue;
      of_[t] = corners_of(state_, t);
      tets.push_back(t);
    }
    return tets;
  }

  /// Those with this proof whose corners keep the threshold, worst first.
  std::vector<int> hidden(Proof proof) const {
    std::vector<int> tets;
    for (int t = 0; t < state_.complex.slots(); ++t)
      if (state_.complex.tet(t).alive() && certificates_[t].proof == proof &&
          !(state_.variation(t) > state_.threshold()))
        tets.push_back(t);
    std::stable_sort(tets.begin(), tets.end(),
                     [&](int a, int b) { return certificates_[a].variation > certificates_[b].variation; });
    return tets;
  }

  void certify(const std::vector<int>& tets, int most_pieces, RunControl& control) {
    constexpr int kTogether = 16;  // little work, so that a run can be stopped soon where distances are slow
    const int count = static_cast<int>(tets.size());
    for_each_at_once((count + kTogether - 1) / kTogether, [&](int part) {
      control.check();
      for (int i = part * kTogether; i < std::min((part + 1) * kTogether, count); ++i)
        certify(tets[i], most_pieces);
    });
    for (const int t : tets) effort_ += certificates_[t].pieces;
  }

  void certify(int t, int most_pieces) {
    const Tet& tet = state_.complex.tet(t);
    const int material = state_.material(t);
    const auto value = [&](int i) { return state_.vertices[tet.vertex[i]].in(material).composition; };
    certificates_[t] = certify_tet(state_.materials().field(material), of_[t],
                                   {value(0), value(1), value(2), value(3)}, state_.threshold(), most_pieces);
  }

  const MeshState& state_;
  std::vector<TetCertificate> certificates_;
  std::vector<Corners> of_;  // the tetrahedra that they were made for, by their corners,
  std::vector<int> solid_;   // and by their solids; 0: none
  std::int64_t effort_ = 0;  // pieces in all,
  std::int64_t budget_ = 0;  // and how many there may be
};

/// The edges of a tetrahedron that can be split, the longest first.
std::vector<std::array<int, 2>> edges_to_split(const MeshState& state, int t) {
  const std::array<int, 4>& v = state.complex.tet(t).vertex;
  std::vector<std::array<int, 2>> edges;
  const auto length = [&](const std::array<int, 2>& edge) {
    return (state.position(edge[0]) - state.position(edge[1])).norm();
  };
  for (const auto& [i, j] : kEdgeVertices)
    if (length({v[i], v[j]}) >= 2.0 * state.min_size) edges.push_back({v[i], v[j]});
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto& a, const auto& b) { return length(a) > length(b); });
  return edges;
}

/// Splits the longest edges of the tetrahedra; none that another split of this call has touched. Returns how
/// many.
int split(MeshState& state, const std::vector<int>& tets, const Certificates& certificates,
          RunControl& control) {
  TetComplex& complex = state.complex;
  const int old_vertices = complex.vertex_slots();
  int count = 0;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    if (i % 64 == 0) control.check_at(state.position(complex.tet(tets[i]).vertex[0]));
    const int t = tets[i];
    const Tet& tet = complex.tet(t);
    if (!tet.alive() || *std::max_element(tet.vertex.begin(), tet.vertex.end()) >= old_vertices) continue;
    const auto& [p, q] = certificates[t].apart;
    if (jumps_between(state.materials().field(state.material(t)), p, q, state.threshold())) continue;
    for (const auto& [a, b] : edges_to_split(state, t)) {
      EdgeRing ring;
      complex.ring(a, b, t, ring);
      const int v =
          state.label_at(a, b, ring) ? split_boundary_edge(state, a, b, t) : split_edge(state, a, b, t);
      if (v < 0) continue;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace

std::vector<TetCertificate> certify_mesh(MeshState& state, const QualityGoal& goal, RunControl& control) {
  constexpr int kMostTets = 20000000;  // nothing is divided once the mesh has as many
  constexpr int kMostRounds = 12;
  Certificates certificates(state);
  certificates.update(control);
  const TetScore score(state, goal);
  WorstFirst mender(state, score);
  int left = 0, left_before = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    control.report(static_cast<double>(round) / kMostRounds, state.complex.tet_count());
    const std::vector<int> tets = certificates.to_divide();
    const int above = count_divisible(state, state.threshold());
    const bool is_done = tets.empty() && above == 0 && (left == 0 || left == left_before);
    if (is_done || state.complex.tet_count() >= kMostTets) break;
    // At first without new points: most are broken by so little that moves of vertices mend them.
    int added = round > 0 ? split(state, tets, certificates, control) : 0;
    left_before = left;
    left = mender.run(3, control);
    const std::size_t most = tets.size() + above;
    if (const int points = insert_steiner_points(state, state.threshold(), most, control)) {
      added += points;
      left = mender.run(3, control);
    }
    certificates.update(control);
    if (round > 0 && added == 0) break;
  }
  return certificates.all();
}

}  // namespace fgmesh
