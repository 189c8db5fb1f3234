// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fgmesh {

/// The tetrahedra that a walk has met, by their slots. Walks are short: most fit into a table on the stack.
class SlotSet {
 public:
  SlotSet() { near_.fill(kNone); }

  /// False where it is there already.
  bool insert(int slot) {
    if (2 * (count_ + 1) > capacity()) grow();
    int& place = find(slot);
    if (place == slot) return false;
    place = slot;
    ++count_;
    return true;
  }
  bool contains(int slot) const { return const_cast<SlotSet*>(this)->find(slot) == slot; }

 private:
  static constexpr int kNone = -1;

  std::size_t capacity() const { return far_.empty() ? near_.size() : far_.size(); }
  /// Where the slot is, or is to be put. Open addressing; the capacity is a power of two.
  int& find(int slot) {
    int* const table = far_.empty() ? near_.data() : far_.data();
    const std::size_t mask = capacity() - 1;
    std::size_t place = (static_cast<std::uint32_t>(slot) * 2654435769u >> 7) & mask;
    while (table[place] != kNone && table[place] != slot) place = (place + 1) & mask;
    return table[place];
  }
  void grow() {
    std::vector<int> old = far_;
    if (old.empty()) old.assign(near_.begin(), near_.end());
    far_.assign(2 * old.size(), kNone);
    for (int slot : old)
      if (slot != kNone) find(slot) = slot;
  }

  std::size_t count_ = 0;
  std::array<int, 128> near_;
  std::vector<int> far_;
};

}  // namespace fgmesh
