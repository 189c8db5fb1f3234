// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// The mesh cut into blocks of vertices near each other, whose insides can be worked on at the same time.
/// What lies across the border of two blocks is in the middle of one where the mesh is cut another way, or is
/// left to the last cut, which has one block of all. Cuts depend on the mesh alone, and not on the number of
/// threads, so that results do not either. A mesh of few vertices has the last cut only.
class Blocks {
 public:
  explicit Blocks(const MeshState& state);

  int cuts() const { return static_cast<int>(cuts_.size()); }
  int last_cut() const { return cuts() - 1; }
  int count(int cut) const { return cuts_[cut].count; }
  /// The block of a vertex; -1 where it is in none.
  int at(int cut, int v) const { return cuts_[cut].block[v]; }

  /// The block that holds all of the vertices; -1 where there is none.
  template <class Vertices>
  int around(int cut, const Vertices& vertices) const {
    int common = -1;
    for (int v : vertices) {
      const int block = at(cut, v);
      if (block < 0 || (common >= 0 && block != common)) return -1;
      common = block;
    }
    return common;
  }

  /// Whether the block of a vertex in this cut holds all its neighbours. That is so until a vertex or an edge
  /// across the border of a block is added.
  bool is_inner(int cut, int v) const { return inner_[v] >> cut & 1; }
  /// Whether that is so in a cut before this one.
  bool was_inner(int cut, int v) const { return inner_[v] & ((1u << cut) - 1); }

 private:
  struct Cut {
    std::vector<int> block;
    int count = 1;
  };

  void find_inner(const TetComplex& complex);

  std::vector<Cut> cuts_;
  std::vector<std::uint8_t> inner_;  // a bit for each cut
};

/// Calls work(v, scratch) for each vertex of the mesh, some at the same time, but none beside another: it may
/// change the vertex, and look at those around it. `scratch` is a vector for its own use.
template <class Work>
void sweep_vertices(const MeshState& state, RunControl& control, const Work& work) {
  const Blocks blocks(state);
  std::vector<std::vector<int>> members;
  for (int cut = 0; cut < blocks.cuts(); ++cut) {
    members.assign(blocks.count(cut), {});
    for (int v = 0; v < state.complex.vertex_slots(); ++v)
      if (state.complex.tet_at(v) >= 0 && blocks.is_inner(cut, v) && !blocks.was_inner(cut, v))
        members[blocks.at(cut, v)].push_back(v);
    for_each_at_once(blocks.count(cut), [&](int block) {
      std::vector<int> scratch;
      for (std::size_t i = 0; i < members[block].size(); ++i) {
        if (i % 512 == 0) control.check();
        work(members[block][i], scratch);
      }
    });
  }
}

}  // namespace fgmesh
