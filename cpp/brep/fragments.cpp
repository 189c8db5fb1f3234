// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/fragments.hpp"

#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_BuilderSolid.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <utility>

#include "brep/occt.hpp"
#include "brep/shape_check.hpp"
#include "core/error.hpp"

namespace fgmesh::brep {
namespace {

/// "Solid1", "Solid1 and Solid4", "Solid1, Solid2 and Solid4"; of many the first ones.
std::string named(const char* word, const std::vector<int>& numbers) {
  constexpr std::size_t kMost = 8;
  const std::size_t count = std::min(numbers.size(), kMost);
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += i + 1 == numbers.size() ? " and " : ", ";
    text += word + std::to_string(numbers[i]);
  }
  return numbers.size() > count ? text + ", ..." : text;
}

/// Placements and exports leave solids a little apart that were made to touch, and no mesh could fill such a
/// gap: what counts as touching, mm.
double touching_distance(const Topology& topology) {
  constexpr double kPart = 1e-7;  // of the diagonal
  Bnd_Box bounds;
  for (int solid = 1; solid <= topology.solid_count(); ++solid)
    BRepBndLib::Add(topology.solid(solid), bounds, Standard_False);
  return kPart * std::sqrt(bounds.SquareExtent());
}

/// The solids whose boxes reach into that of another one.
std::vector<int> neighbours(const Topology& topology, double touching) {
  std::vector<Bnd_Box> boxes(topology.solid_count());
  for (int solid = 1; solid <= topology.solid_count(); ++solid) {
    BRepBndLib::Add(topology.solid(solid), boxes[solid - 1], Standard_False);
    boxes[solid - 1].Enlarge(0.5 * touching);
  }
  std::vector<int> found;
  for (int solid = 1; solid <= topology.solid_count(); ++solid) {
    const bool near = std::count_if(boxes.begin(), boxes.end(),
                                    [&](const Bnd_Box& other) { return !other.IsOut(boxes[solid - 1]); }) > 1;
    if (near) found.push_back(solid);
  }
  return found;
}

/// A region that General Fuse has cut out: no face runs through it.
struct Cell {
  TopoDS_Shape shape;
  std::vector<int> holders;  ///< the solids it lies in, ascending
  int owner = 0;             ///< that of them which gets it
};

/// Gives every cell to the lowest of its holders, but lets a solid that would be left with nothing have all
/// of its own; of equal solids the first. Volumes of the solids in mm^3.
void choose_owners(std::vector<Cell>& cells, const std::vector<double>& volumes) {
  const int count = static_cast<int>(volumes.size());
  std::vector<std::vector<int>> held(count);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    cells[c].owner = cells[c].holders.front();
    for (int solid : cells[c].holders) held[solid - 1].push_back(static_cast<int>(c));
  }
  // Largest first: of nested solids each then leaves the next smaller one its own.
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return volumes[a] > volumes[b]; });
  for (int solid : order) {
    const std::vector<int>& own = held[solid];
    const bool keeps_some =
        std::any_of(own.begin(), own.end(), [&](int c) { return cells[c].owner == solid + 1; });
    const bool is_copy = std::find(held.begin(), held.begin() + solid, own) != held.begin() + solid;
    if (keeps_some || is_copy) continue;
    for (int c : own) cells[c].owner = solid + 1;
  }
}

/// The cells of one solid without the faces that two of them share.
TopTools_ListOfShape joined(const TopTools_ListOfShape& cells, RunControl& control) {
  TopTools_MapOfShape once, twice;
  for (const TopoDS_Shape& cell : cells)
    for (TopExp_Explorer it(cell, TopAbs_FACE); it.More(); it.Next())
      if (!once.Add(it.Current())) twice.Add(it.Current());
  if (twice.IsEmpty()) return cells;
  TopTools_ListOfShape walls;
  for (const TopoDS_Shape& cell : cells)
    for (TopExp_Explorer it(cell, TopAbs_FACE); it.More(); it.Next())
      if (!twice.Contains(it.Current())) walls.Append(it.Current());
  BOPAlgo_BuilderSolid builder;
  builder.SetShapes(walls);
  Handle(StopIndicator) indicator = new StopIndicator(control);
  builder.Perform(indicator->Start());
  control.check();
  return builder.HasErrors() ? cells : builder.Areas();
}

class Fragmenter {
 public:
  Fragmenter(const Topology& topology, const std::vector<double>& volumes, RunControl& control)
      : topology_(topology), volumes_(volumes), control_(control), touching_(touching_distance(topology)) {}

  std::optional<Fragments> run() {
    fused_ = neighbours(topology_, touching_);
    if (fused_.empty()) return std::nullopt;
    fuse();
    if (!has_changed()) return std::nullopt;
    find_cells();
    choose_owners(cells_, volumes_);
    assemble();
    find_origins();
    note_overlaps();
    note_losses();
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw GeometryError(named("Solid", fused_) + " touch or overlap, and OpenCASCADE " + what +
                        "; separate them with Part -> Boolean -> Boolean Fragments, or mesh them one by one");
  }

  void fuse() {
    for (int solid : fused_) builder_.AddArgument(topology_.solid(solid));
    builder_.SetFuzzyValue(touching_);
    builder_.SetNonDestructive(Standard_True);
    builder_.SetRunParallel(Standard_False);  // the same numbers in every run
    Handle(StopIndicator) indicator = new StopIndicator(control_);
    builder_.Perform(indicator->Start());
    control_.check();
    if (builder_.HasErrors()) refuse("cannot tell how");
  }

  /// True where a part was split, joined with another one or lost. One that was only copied, with another
  /// tolerance perhaps, is what it was.
  bool has_changed() {
    for (TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      TopTools_IndexedMapOfShape parts, made;
      for (int solid : fused_) TopExp::MapShapes(topology_.solid(solid), kind, parts);
      for (int i = 1; i <= parts.Extent(); ++i) {
        const TopTools_ListOfShape found = pieces(parts(i));
        if (found.Extent() != 1 || made.Contains(found.First())) return true;
        made.Add(found.First());
      }
    }
    return false;
  }

  /// What became of a part of the shape: itself where nothing did.
  TopTools_ListOfShape pieces(const TopoDS_Shape& part) {
    TopTools_ListOfShape found = builder_.Modified(part);
    if (found.IsEmpty() && !builder_.IsDeleted(part)) found.Append(part);
    return found;
  }

  void find_cells() {
    TopTools_IndexedMapOfShape numbers;
    for (int solid = 1; solid <= topology_.solid_count(); ++solid) {
      for (const TopoDS_Shape& piece : pieces(topology_.solid(solid))) {
        const std::size_t number = numbers.Add(piece);
        if (number > cells_.size()) cells_.push_back({piece, {}, 0});
        cells_[number - 1].holders.push_back(solid);
      }
    }
    // General Fuse may lose a piece without a word.
    constexpr double kAllowedLoss = 1e-3;
    std::vector<double> found(volumes_.size(), 0.0);
    for (const Cell& cell : cells_) {
      const double volume = std::abs(enclosed_volume(cell.shape));
      control_.check();
      for (int solid : cell.holders) found[solid - 1] += volume;
      cell_volumes_.push_back(volume);
    }
    for (std::size_t i = 0; i < found.size(); ++i)
      if (!(std::abs(found[i] / volumes_[i] - 1.0) < kAllowedLoss))
        refuse("loses a part of Solid" + std::to_string(i + 1) + " when it separates them");
  }

  void assemble() {
    TopoDS_Compound compound;
    const BRep_Builder builder;
    builder.MakeCompound(compound);
    for (int solid = 1; solid <= topology_.solid_count(); ++solid) {
      TopTools_ListOfShape own;
      for (const Cell& cell : cells_)
        if (cell.owner == solid) own.Append(cell.shape);
      for (const TopoDS_Shape& piece : joined(own, control_)) {
        builder.Add(compound, piece);
        result_.origins.solids.push_back(solid);
      }
    }
    result_.origins.solid_count = topology_.solid_count();
    result_.shape = compound;
  }

  void find_origins() {
    const Topology made(result_.shape);
    Origins& origins = result_.origins;
    origins.faces.resize(made.face_count());
    origins.edges.resize(made.edge_count());
    origins.vertices.resize(made.vertex_count());
    const auto inherit = [&](const TopoDS_Shape& part, int number, const auto& number_of,
                             std::vector<std::vector<int>>& origins_of) {
      bool any = false;
      for (const TopoDS_Shape& piece : pieces(part)) {
        const int found = number_of(piece);
        if (found > 0) origins_of[found - 1].push_back(number);
        any = any || found > 0;
      }
      return any;
    };
    for (int face = 1; face <= topology_.face_count(); ++face) {
      if (topology_.face_use(face).solid_behind == 0) continue;
      const auto number_of = [&](const TopoDS_Shape& piece) { return made.face_number(piece); };
      if (!inherit(topology_.face(face), face, number_of, origins.faces)) lost_faces_.push_back(face);
    }
    for (int edge = 1; edge <= topology_.edge_count(); ++edge)
      inherit(
          topology_.edge(edge), edge, [&](const TopoDS_Shape& piece) { return made.edge_number(piece); },
          origins.edges);
    for (int vertex = 1; vertex <= topology_.vertex_count(); ++vertex)
      inherit(
          topology_.vertex(vertex), vertex,
          [&](const TopoDS_Shape& piece) { return made.vertex_number(piece); }, origins.vertices);
  }

  void note_overlaps() {
    std::map<std::pair<int, int>, double> overlaps;  // of owner and loser, mm^3
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (int solid : cells_[c].holders)
        if (solid != cells_[c].owner) overlaps[{cells_[c].owner, solid}] += cell_volumes_[c];
    for (const auto& [solids, volume] : overlaps) {
      std::ostringstream text;
      const std::string owner = "Solid" + std::to_string(solids.first);
      text << owner << " and Solid" << solids.second << " overlap by " << volume
           << " mm^3: that region belongs to " << owner;
      result_.notes.push_back(text.str());
    }
    if (overlaps.empty())
      result_.notes.push_back(named("Solid", fused_) +
                              " touch without sharing faces: they were made to share them");
  }

  void note_losses() {
    std::vector<int> empty;
    for (int solid = 1; solid <= topology_.solid_count(); ++solid) {
      const std::vector<int>& left = result_.origins.solids;
      if (!std::binary_search(left.begin(), left.end(), solid)) empty.push_back(solid);
    }
    if (!empty.empty())
      result_.notes.push_back("other solids fill " + named("Solid", empty) +
                              ", which has no tetrahedra of its own: remove what stands there twice");
    if (!lost_faces_.empty())
      result_.notes.push_back(named("Face", lost_faces_) + (lost_faces_.size() == 1 ? " lies" : " lie") +
                              " inside another solid and bounds nothing any more");
  }

  const Topology& topology_;
  const std::vector<double>& volumes_;
  RunControl& control_;
  const double touching_;
  BOPAlgo_Builder builder_;
  std::vector<int> fused_;
  std::vector<Cell> cells_;
  std::vector<double> cell_volumes_;
  std::vector<int> lost_faces_;
  Fragments result_;
};

}  // namespace

std::optional<Fragments> fragment(const Topology& topology, const std::vector<double>& volumes,
                                  RunControl& control) {
  if (topology.solid_count() < 2) return std::nullopt;
  return Fragmenter(topology, volumes, control).run();
}

}  // namespace fgmesh::brep
