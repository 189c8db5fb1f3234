// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity of small meshes made by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "core/error.hpp"
#include "mesh/slot_set.hpp"
#include "mesh/tet_complex.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

using test::find_fault;

/// Labels every face that only one of the tetrahedra has, with its number in order from 1.
std::vector<LabelledFacet> boundary_of(const std::vector<NewTet>& tets) {
  std::vector<LabelledFacet> found;
  for (const NewTet& tet : tets) {
    for (int i = 0; i < 4; ++i) {
      std::set<int> face(tet.vertex.begin(), tet.vertex.end());
      face.erase(tet.vertex[i]);
      const auto has_face = [&](const NewTet& other) {
        return std::all_of(face.begin(), face.end(), [&](int v) {
          return std::find(other.vertex.begin(), other.vertex.end(), v) != other.vertex.end();
        });
      };
      if (std::count_if(tets.begin(), tets.end(), has_face) > 1) continue;
      LabelledFacet facet;
      std::copy(face.begin(), face.end(), facet.vertex.begin());
      facet.label = static_cast<int>(found.size()) + 1;
      found.push_back(facet);
    }
  }
  return found;
}

TetComplex built(const std::vector<NewTet>& tets, int vertices) {
  TetComplex complex;
  complex.build(tets, boundary_of(tets), vertices);
  return complex;
}

/// Vertices 0 (below) and 1 (above) of an axis, and `count` tetrahedra around it on the vertices from 2 on;
/// all the way round where `closed`.
std::vector<NewTet> fan(int count, bool closed) {
  std::vector<NewTet> tets;
  for (int i = 0; i < count; ++i) tets.push_back({{0, 1, 2 + i, closed ? 2 + (i + 1) % count : 3 + i}, 1});
  return tets;
}

/// Three tetrahedra around the edge (3, 4), the same hole as two on the face (0, 1, 2).
const std::vector<NewTet> kTwo = {{{0, 1, 2, 3}, 1}, {{0, 2, 1, 4}, 1}};
const std::vector<NewTet> kThree = {{{4, 3, 0, 1}, 1}, {{4, 3, 1, 2}, 1}, {{4, 3, 2, 0}, 1}};

int label_of(const TetComplex& complex, const std::set<int>& face) {
  for (int t = 0; t < complex.slots(); ++t) {
    if (!complex.tet(t).alive()) continue;
    for (int i = 0; i < 4; ++i) {
      std::set<int> own(complex.tet(t).vertex.begin(), complex.tet(t).vertex.end());
      own.erase(complex.tet(t).vertex[i]);
      if (own == face) return complex.tet(t).label[i];
    }
  }
  return -1;
}

TEST(TetComplex, OfOneTetrahedron) {
  const TetComplex complex = built({{{0, 1, 2, 3}, 5}}, 6);
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_count(), 1);
  EXPECT_EQ(complex.tet(0).solid, 5);
  for (const int neighbour : complex.tet(0).neighbour) EXPECT_EQ(neighbour, -1);
  EXPECT_EQ(complex.tet_at(3), 0);
  EXPECT_EQ(complex.tet_at(5), -1);
  std::vector<int> star = {7, 8};
  complex.star(5, star);
  EXPECT_TRUE(star.empty());
}

TEST(TetComplex, JoinsTwoAcrossTheirFace) {
  const TetComplex complex = built(kTwo, 5);
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet(0).neighbour, (std::array<int, 4>{-1, -1, -1, 1}));
  EXPECT_EQ(complex.tet(1).neighbour, (std::array<int, 4>{-1, -1, -1, 0}));
  EXPECT_EQ(complex.tet(0).label[3], 0);
  EXPECT_EQ(complex.find_edge(3, 4), -1);
  EXPECT_EQ(complex.find_edge(0, 4), 1);
  std::vector<int> star;
  complex.star(0, star);
  EXPECT_EQ(std::set<int>(star.begin(), star.end()), (std::set<int>{0, 1}));
}

TEST(TetComplex, LabelsInterfacesFromBothSides) {
  const std::vector<NewTet> tets = {{{0, 1, 2, 3}, 1}, {{0, 2, 1, 4}, 2}};
  std::vector<LabelledFacet> facets = boundary_of(tets);
  facets.push_back({{2, 0, 1}, 9});
  TetComplex complex;
  complex.build(tets, facets, 5);
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet(0).label[3], 9);
  EXPECT_EQ(complex.tet(1).label[3], 9);
}

TEST(TetComplex, KnowsAllTetrahedraWhereTheyTouchWithoutACommonFace) {
  // Two that have an edge in common, and one that has a vertex of it.
  TetComplex complex = built({{{0, 1, 2, 3}, 1}, {{0, 1, 4, 5}, 1}, {{1, 6, 7, 8}, 1}}, 9);
  const auto star = [&](int v) {
    std::vector<int> found;
    complex.star(v, found);
    return std::set<int>(found.begin(), found.end());
  };
  EXPECT_EQ(star(0), (std::set<int>{0, 1}));
  EXPECT_EQ(star(1), (std::set<int>{0, 1, 2}));
  EXPECT_TRUE(complex.is_pinched(0) && complex.is_pinched(1));
  EXPECT_FALSE(complex.is_pinched(2) || complex.is_pinched(6));
  // A vertex on the common edge.
  const int middle = complex.add_vertex();
  complex.replace(
      {0, 1},
      {{{0, middle, 2, 3}, 1}, {{middle, 1, 2, 3}, 1}, {{0, middle, 4, 5}, 1}, {{middle, 1, 4, 5}, 1}}, {});
  complex.pinch(middle);
  EXPECT_EQ(star(0).size(), 2u);
  EXPECT_EQ(star(1).size(), 3u);
  EXPECT_EQ(star(middle).size(), 4u);
}

TEST(TetComplex, RefusesAFaceOfThreeTetrahedra) {
  std::vector<NewTet> tets = kTwo;
  tets.push_back({{0, 1, 2, 5}, 1});
  TetComplex complex;
  EXPECT_THROW(complex.build(tets, boundary_of(tets), 6), GeometryError);
}

TEST(TetComplex, RefusesABoundaryFaceWithoutLabel) {
  std::vector<LabelledFacet> facets = boundary_of(kTwo);
  facets.pop_back();
  TetComplex complex;
  EXPECT_THROW(complex.build(kTwo, facets, 5), GeometryError);
}

TEST(TetComplex, ForgetsWhatItHeldBeforeItWasBuilt) {
  TetComplex complex = built(fan(6, true), 8);
  complex.set_crease(0, 2, 3);
  complex.build(kTwo, boundary_of(kTwo), 5);
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_count(), 2);
  EXPECT_TRUE(complex.creases().empty());
}

/// tet[i] has link[i] and link[i + 1], in one sense of rotation throughout.
void expect_ring(const TetComplex& complex, const EdgeRing& ring, int a, int b) {
  const std::size_t n = ring.tet.size();
  ASSERT_EQ(ring.link.size(), ring.closed ? n : n + 1);
  EXPECT_EQ(std::set<int>(ring.tet.begin(), ring.tet.end()).size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    const Tet& tet = complex.tet(ring.tet[i]);
    for (const int v : {a, b, ring.link[i], ring.link[(i + 1) % ring.link.size()]}) EXPECT_TRUE(tet.has(v));
  }
}

TEST(EdgeRing, GoesAllTheWayRoundAnInnerEdge) {
  for (const int count : {3, 5, 9}) {
    const TetComplex complex = built(fan(count, true), count + 2);
    ASSERT_EQ(find_fault(complex), "");
    for (int start = 0; start < count; ++start) {
      EdgeRing ring;
      complex.ring(start % 2, 1 - start % 2, start, ring);
      EXPECT_TRUE(ring.closed);
      EXPECT_EQ(ring.tet.size(), static_cast<std::size_t>(count));
      expect_ring(complex, ring, 0, 1);
    }
  }
}

TEST(EdgeRing, GoesFromBoundaryToBoundaryWhereverItStarts) {
  for (const int count : {1, 2, 5}) {
    const TetComplex complex = built(fan(count, false), count + 3);
    for (int start = 0; start < count; ++start) {
      EdgeRing ring;
      complex.ring(0, 1, start, ring);
      EXPECT_FALSE(ring.closed);
      EXPECT_EQ(ring.tet.size(), static_cast<std::size_t>(count));
      expect_ring(complex, ring, 0, 1);
      const std::set<int> ends = {ring.link.front(), ring.link.back()};
      EXPECT_EQ(ends, (std::set<int>{2, 2 + count}));
    }
  }
}

TEST(Replace, TwoByThreeAndBack) {
  TetComplex complex = built(kTwo, 5);
  std::vector<std::set<int>> outer;
  for (const LabelledFacet& facet : boundary_of(kTwo))
    outer.emplace_back(facet.vertex.begin(), facet.vertex.end());
  complex.replace({0, 1}, kThree, {});
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_count(), 3);
  EXPECT_EQ(complex.created().size(), 3u);
  EXPECT_GE(complex.find_edge(3, 4), 0);
  EXPECT_EQ(label_of(complex, {0, 1, 2}), -1) << "the face is gone";
  for (std::size_t i = 0; i < outer.size(); ++i)
    EXPECT_EQ(label_of(complex, outer[i]), static_cast<int>(i) + 1);

  complex.replace(std::vector<int>(complex.created()), kTwo, {});
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_count(), 2);
  EXPECT_EQ(complex.find_edge(3, 4), -1);
  for (std::size_t i = 0; i < outer.size(); ++i)
    EXPECT_EQ(label_of(complex, outer[i]), static_cast<int>(i) + 1);
}

TEST(Replace, UsesFreeSlotsAgain) {
  TetComplex complex = built(kTwo, 5);
  for (int i = 0; i < 20; ++i) {
    complex.replace(i == 0 ? std::vector<int>{0, 1} : std::vector<int>(complex.created()), kThree, {});
    complex.replace(std::vector<int>(complex.created()), kTwo, {});
  }
  EXPECT_EQ(complex.tet_count(), 2);
  EXPECT_LE(complex.slots(), 5);
  EXPECT_EQ(find_fault(complex), "");
}

TEST(Replace, LabelsNewFacetsOfTheBoundary) {
  // The boundary edge (0, 1) of a fan of two goes, with its facets; its two other vertices get joined.
  TetComplex complex = built(fan(2, false), 5);
  const int first = label_of(complex, {0, 1, 2});
  complex.replace({0, 1}, {{{2, 3, 4, 1}, 1}, {{2, 4, 3, 0}, 1}}, {{{0, 2, 4}, first}, {{1, 2, 4}, first}});
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(label_of(complex, {0, 2, 4}), first);
  EXPECT_EQ(label_of(complex, {2, 1, 4}), first);
  EXPECT_EQ(label_of(complex, {2, 3, 4}), 0) << "a face inside";
}

TEST(Replace, LeavesVerticesThatAreNoMoreInUse) {
  TetComplex complex = built(fan(4, true), 6);
  const int apex = complex.add_vertex();
  EXPECT_EQ(complex.tet_at(apex), -1);
  // A vertex on the axis, and away with it again.
  std::vector<NewTet> halves;
  for (const NewTet& tet : fan(4, true)) {
    halves.push_back({{0, apex, tet.vertex[2], tet.vertex[3]}, 1});
    halves.push_back({{apex, 1, tet.vertex[2], tet.vertex[3]}, 1});
  }
  complex.replace({0, 1, 2, 3}, halves, {});
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_count(), 8);
  EXPECT_EQ(complex.find_edge(0, 1), -1);
  complex.replace(std::vector<int>(complex.created()), fan(4, true), {});
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_EQ(complex.tet_at(apex), -1);
}

TEST(Creases, AreFoundFromBothEndsAndListedInOrder) {
  TetComplex complex = built(fan(5, true), 7);
  complex.set_crease(5, 0, 12);
  complex.set_crease(0, 2, 7);
  EXPECT_EQ(complex.crease(0, 5), 12);
  EXPECT_EQ(complex.crease(5, 0), 12);
  EXPECT_EQ(complex.crease(0, 3), 0);
  using List = std::vector<std::array<int, 3>>;
  EXPECT_EQ(complex.creases(), (List{{0, 2, 7}, {0, 5, 12}}));
  complex.clear_crease(2, 0);
  EXPECT_EQ(complex.creases(), (List{{0, 5, 12}}));
}

TEST(Sites, ChangeTheirPartsOfTheMeshWithSlotsOfTheirOwn) {
  // Two of the fans side by side, of which each site fills one anew.
  std::vector<NewTet> tets = kTwo;
  for (NewTet tet : kTwo) {
    for (int& v : tet.vertex) v += 5;
    tets.push_back(tet);
  }
  std::vector<NewTet> three = kThree;
  for (NewTet& tet : three)
    for (int& v : tet.vertex) v += 5;
  TetComplex complex = built(tets, 10);
  std::vector<TetComplex::Site> sites = complex.part({1, 2});
  EXPECT_TRUE(complex.replace({0, 1}, kThree, {}, sites[0]));
  EXPECT_TRUE(complex.replace({2, 3}, three, {}, sites[1]));
  EXPECT_EQ(TetComplex::free_slots(sites[0]).size(), 0u);
  EXPECT_EQ(TetComplex::free_slots(sites[1]).size(), 1u);
  complex.rejoin(sites);
  EXPECT_EQ(complex.tet_count(), 6);
  EXPECT_EQ(find_fault(complex), "");
  EXPECT_GE(complex.find_edge(3, 4), 0);
  EXPECT_GE(complex.find_edge(8, 9), 0);
}

TEST(Sites, RefuseWhatTheyHaveNoSlotsFor) {
  TetComplex complex = built(kTwo, 5);
  std::vector<TetComplex::Site> sites = complex.part({0});
  EXPECT_FALSE(complex.replace({0, 1}, kThree, {}, sites[0]));
  complex.rejoin(sites);
  EXPECT_EQ(complex.tet_count(), 2);
  EXPECT_EQ(complex.find_edge(3, 4), -1);
  EXPECT_EQ(find_fault(complex), "");
}

TEST(SlotSet, HoldsWhatWasPutInHoweverMuch) {
  SlotSet met;
  std::set<int> expected;
  for (int i = 0; i < 1000; ++i) {
    const int slot = i * i * 31 % 1777;
    EXPECT_EQ(met.contains(slot), expected.count(slot) == 1);
    EXPECT_EQ(met.insert(slot), expected.insert(slot).second);
  }
  for (int slot = 0; slot < 1777; ++slot) EXPECT_EQ(met.contains(slot), expected.count(slot) == 1);
}

}  // namespace
}  // namespace fgmesh
