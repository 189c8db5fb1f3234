// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/worst_first.hpp"

#include <boost/container_hash/hash.hpp>

#include "mesh/blocks.hpp"

namespace fgmesh {
namespace {

/// Many bad tetrahedra of which a round leaves so large a part are forced by the shape: a thin wall.
constexpr std::size_t kFew = 50;
constexpr double kHopeless = 0.95;

}  // namespace

/// Whether more is wrong with a tetrahedron that scores low than a variation that only points could lower.
bool WorstFirst::may_be_mended(int t) const {
  return !score_.goal().material || state_.variation(t) <= kBeyondMoves * state_.threshold() ||
         shape_(t) < 1.0;
}

std::vector<int> WorstFirst::bad_tets(double least) const {
  std::vector<double> scores(state_.complex.slots(), 1.0);
  for_ranges_at_once(scores.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      if (const int tet = static_cast<int>(t); state_.complex.tet(tet).alive())
        if (const double score = score_(tet); score < least && may_be_mended(tet)) scores[t] = score;
  });
  std::vector<int> tets;
  for (int t = 0; t < state_.complex.slots(); ++t)
    if (scores[t] < least) tets.push_back(t);
  std::stable_sort(tets.begin(), tets.end(), [&](int a, int b) { return scores[a] < scores[b]; });
  return tets;
}

/// A hash of the vertices of a tetrahedron and its neighbours and of their places: while it stays the same,
/// to try again in other random directions is worth it for a few tetrahedra only.
std::size_t WorstFirst::surroundings(int t) const {
  std::size_t hash = 0;
  const auto add = [&](const Tet& tet) {
    for (int v : tet.vertex) {
      boost::hash_combine(hash, v);
      for (double x : state_.position(v)) boost::hash_combine(hash, x);
    }
  };
  const Tet& tet = state_.complex.tet(t);
  add(tet);
  for (int other : tet.neighbour)
    if (other >= 0) add(state_.complex.tet(other));
  return hash;
}

template <class IsDue>
WorstFirst::Outcome WorstFirst::mend(const std::vector<int>& tets, TetMender& mender, bool all_hope,
                                     const IsDue& is_due, RunControl& control) const {
  Outcome outcome;
  int polls = 0;
  for (int t : tets) {
    if (++polls % 64 == 0) control.check_at(state_.position(state_.complex.tet(t).vertex[0]));
    // Earlier changes may have mended it, or put another tetrahedron into its slot: both are told by its
    // score.
    const Tet& tet = state_.complex.tet(t);
    if (!tet.alive() || !is_due(tet) || score_(t) >= 1.0) continue;
    const std::size_t place = surroundings(t);
    if (!all_hope && hopeless_.count(place)) continue;
    if (mender.mend(t, may_insert_))
      outcome.any = true;
    else
      outcome.hopeless.push_back(place);
  }
  return outcome;
}

/// Mends what is inside blocks of the mesh, some at the same time. Returns what is left.
std::vector<int> WorstFirst::mend_at_once(const std::vector<int>& bad, bool& any, RunControl& control) {
  TetComplex& complex = state_.complex;
  const Blocks blocks(state_);
  std::vector<int> rest = bad;
  for (int cut = 0; cut < blocks.last_cut(); ++cut) {
    // Of a collapse along a crease others would have to know.
    const auto is_inside = [&](const Tet& tet) {
      return std::all_of(tet.vertex.begin(), tet.vertex.end(), [&](int v) {
        return blocks.is_inner(cut, v) && state_.vertices[v].carrier.dimension > 1;
      });
    };
    std::vector<std::vector<int>> members(blocks.count(cut));
    std::vector<int> others;
    for (int t : rest) {
      const Tet& tet = complex.tet(t);
      if (tet.alive()) (is_inside(tet) ? members[blocks.at(cut, tet.vertex[0])] : others).push_back(t);
    }
    std::vector<int> room;
    for (const std::vector<int>& tets : members) room.push_back(32 + static_cast<int>(tets.size()));
    std::vector<TetComplex::Site> sites = complex.part(room);
    std::vector<Outcome> outcomes(members.size());
    const std::uint32_t seed = seeds_;
    for_each_at_once(static_cast<int>(members.size()), [&](int block) {
      TetMender mender(state_, score_, sites[block], seed + block);
      outcomes[block] = mend(members[block], mender, false, is_inside, control);
    });
    seeds_ += static_cast<std::uint32_t>(members.size());
    complex.rejoin(sites);
    for (const Outcome& outcome : outcomes) any |= note(outcome);
    rest = std::move(others);
  }
  return rest;
}

bool WorstFirst::note(const Outcome& outcome) {
  hopeless_.insert(outcome.hopeless.begin(), outcome.hopeless.end());
  return outcome.any;
}

int WorstFirst::run(int rounds, RunControl& control) {
  std::vector<int> bad = bad_tets();
  for (int round = 0; round < rounds && !bad.empty(); ++round) {
    bool any = false;
    const bool are_few = bad.size() <= kFew;
    // Whoever adds a vertex works alone.
    const std::vector<int> rest = are_few || may_insert_ ? bad : mend_at_once(bad, any, control);
    any |= note(mend(
        rest, alone_, are_few, [](const Tet&) { return true; }, control));
    const std::size_t before = bad.size();
    bad = bad_tets();
    if (!any || (bad.size() > kFew && bad.size() > kHopeless * before)) break;
  }
  return static_cast<int>(bad.size());
}

}  // namespace fgmesh
