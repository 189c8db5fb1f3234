// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blocks.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace fgmesh {
namespace {

/// Vertices in a block. Smaller ones have more of their vertices at the border, larger ones leave the last
/// thread longer alone.
constexpr int kMembers = 8192;

struct Member {
  Vec3 place;
  int vertex;
};

/// Numbers blocks of about equal size, each made by halving a larger one across its longest side.
void halve(Member* begin, Member* end, int halvings, std::vector<int>& block, int& count) {
  if (halvings == 0) {
    for (const Member* member = begin; member < end; ++member) block[member->vertex] = count;
    ++count;
    return;
  }
  Vec3 low = begin->place, high = low;
  for (const Member* member = begin; member < end; ++member) {
    low = low.cwiseMin(member->place);
    high = high.cwiseMax(member->place);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  Member* const middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [axis](const Member& a, const Member& b) {
    return std::pair(a.place[axis], a.vertex) < std::pair(b.place[axis], b.vertex);
  });
  halve(begin, middle, halvings - 1, block, count);
  halve(middle, end, halvings - 1, block, count);
}

}  // namespace

Blocks::Blocks(const MeshState& state) {
  const TetComplex& complex = state.complex;
  const int slots = complex.vertex_slots();
  std::vector<Member> members;
  members.reserve(slots);
  // What happens at a pinched vertex is not near it only.
  for (int v = 0; v < slots; ++v)
    if (complex.tet_at(v) >= 0 && !complex.is_pinched(v)) members.push_back({state.position(v), v});
  int halvings = 0;
  while (members.size() >> halvings > kMembers) ++halvings;

  if (halvings > 0) {
    // Planes of the second cut meet those of the first in lines.
    Eigen::Matrix3d turn;
    turn << 1.0, 1.0, 1.0, 1.0, -1.0, 0.0, 1.0, 1.0, -2.0;
    turn.rowwise().normalize();
    for (const bool turned : {false, true}) {
      Cut& cut = cuts_.emplace_back();
      cut.block.assign(slots, -1);
      cut.count = 0;
      if (turned)
        for (Member& member : members) member.place = turn * member.place;
      halve(members.data(), members.data() + members.size(), halvings, cut.block, cut.count);
    }
  }
  cuts_.emplace_back().block.assign(slots, 0);
  inner_.assign(slots, (1u << cuts()) - 1);
  if (cuts() > 1) find_inner(complex);
}

void Blocks::find_inner(const TetComplex& complex) {
  for (int t = 0; t < complex.slots(); ++t) {
    if (!complex.tet(t).alive()) continue;
    std::uint8_t crossed = 0;
    for (int cut = 0; cut < last_cut(); ++cut)
      if (around(cut, complex.tet(t).vertex) < 0) crossed |= 1u << cut;
    for (int v : complex.tet(t).vertex) inner_[v] &= ~crossed;
  }
}

}  // namespace fgmesh
