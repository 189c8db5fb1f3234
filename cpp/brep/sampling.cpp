// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/sampling.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gp_Trsf.hxx>
#include <optional>
#include <string>

#include "brep/flat_triangles.hpp"
#include "brep/occt.hpp"
#include "brep/weld.hpp"

namespace fgmesh::brep {
namespace {

/// How to triangulate: first as asked, then in ways that help where that fails.
struct Attempt {
  double factor;   ///< of the deflection asked for
  double stretch;  ///< relative growth of the copy that is triangulated
};

// BRepMesh of OCCT 7.6 gives up on some sound faces whose seam ends one rounding error beside another edge. A
// copy larger by less than any tolerance has other rounding errors and passes.
constexpr double imperceptible = 1e-10;
constexpr Attempt attempts[] = {{1.0, 0.0}, {0.9, imperceptible}, {0.3, 0.0}, {0.1, imperceptible}};

TopoDS_Compound compound_of_solids(const Topology& topology) {
  TopoDS_Compound solids;
  const BRep_Builder builder;
  builder.MakeCompound(solids);
  for (int number = 1; number <= topology.solid_count(); ++number)
    builder.Add(solids, topology.solid(number));
  return solids;
}

/// Leaves triangulations on the faces of `solids`.
void triangulate(const TopoDS_Shape& solids, double deflection, double angle, RunControl& control) {
  // A triangulation that came with the file, or from a coarser attempt, would be kept otherwise.
  BRepTools::Clean(solids);
  IMeshTools_Parameters parameters;
  parameters.Deflection = std::max(deflection, Precision::Confusion());  // it refuses less
  parameters.Angle = angle;
  parameters.InParallel = Standard_False;  // the same points in every run
  Handle(StopIndicator) indicator = new StopIndicator(control);
  BRepMesh_IncrementalMesh(solids, parameters, indicator->Start());
  control.check();
}

std::optional<Sampling> attempt_sampling(const CheckedShape& shape, const Attempt& attempt, double deflection,
                                         double angle, RunControl& control, std::string& fault) {
  const TopoDS_Compound solids = compound_of_solids(shape.topology);
  gp_Trsf growth;
  if (attempt.stretch > 0.0) growth.SetScale(gp_Pnt(), 1.0 + attempt.stretch);
  BRepBuilderAPI_Transform copy(solids, growth, Standard_True);
  const bool use_copy = attempt.stretch > 0.0;
  triangulate(use_copy ? copy.Shape() : solids, attempt.factor * deflection, angle, control);
  const TriangulatedCopy triangulated = [&](const TopoDS_Shape& sub_shape) {
    return use_copy ? copy.ModifiedShape(sub_shape).Oriented(sub_shape.Orientation()) : sub_shape;
  };
  return weld(shape, triangulated, fault);
}

/// Triangles as they bound `solid`, each side of an interface turned outward.
template <class Visit>
void for_each_triangle_of(const SampledBoundary& boundary, int solid, const Visit& visit) {
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    const auto& [a, b, c] = boundary.triangles[i];
    if (boundary.triangle_solids[i][0] == solid) visit(a, b, c, boundary.triangle_face[i]);
    if (boundary.triangle_solids[i][1] == solid) visit(a, c, b, boundary.triangle_face[i]);
  }
}

double sampled_volume(const SampledBoundary& boundary, int solid) {
  const Vec3 middle = 0.5 * (boundary.bounds.low + boundary.bounds.high);
  double volume = 0.0;
  for_each_triangle_of(boundary, solid, [&](int a, int b, int c, int) {
    volume +=
        (boundary.points[a] - middle).dot((boundary.points[b] - middle).cross(boundary.points[c] - middle)) /
        6.0;
  });
  return volume;
}

/// A face with a triangle edge that no neighbour runs along in the other direction; 0 where all is closed.
int face_at_gap(const SampledBoundary& boundary, int solid) {
  struct Side {
    std::uint64_t key;
    int direction, face;
  };
  std::vector<Side> sides;
  const auto add = [&](int from, int to, int face) {
    const auto [low, high] = std::minmax(from, to);
    sides.push_back(
        {static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high), from < to ? 1 : -1, face});
  };
  for_each_triangle_of(boundary, solid, [&](int a, int b, int c, int face) {
    add(a, b, face);
    add(b, c, face);
    add(c, a, face);
  });
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    int balance = 0;
    for (end = begin; end < sides.size() && sides[end].key == sides[begin].key; ++end) {
      balance += sides[end].direction;
    }
    if (balance != 0) return sides[begin].face;
  }
  return 0;
}

// Parts of the volume. A lost triangle costs more than the first; at flat tips and rims, where there is
// little volume for the area, sound samples do, too, and the second is borne where no attempt keeps the
// first.
constexpr double allowed_loss = 0.002, bearable_loss = 0.02;

/// Empty where the samples bound every solid as its true faces do, but for a loss of volume; else what is
/// wrong.
std::string fault_of(const SampledBoundary& boundary, const std::vector<double>& volumes, double allowed) {
  for (int solid = 1; solid <= boundary.solid_count; ++solid) {
    if (const int face = face_at_gap(boundary, solid)) {
      return "the triangles of Face" + std::to_string(face) + " do not meet those of its neighbours";
    }
    const double error = std::abs(sampled_volume(boundary, solid) / volumes[solid - 1] - 1.0);
    if (!(error <= allowed)) {
      return "the triangles of Solid" + std::to_string(solid) + " bound another volume than its faces do (" +
             std::to_string(100.0 * error) + " % off)";
    }
  }
  return {};
}

}  // namespace

Sampling sample_boundary(const CheckedShape& shape, const SamplingOptions& options, RunControl& control) {
  const double diagonal = shape.bounds.diagonal();
  const double asked = options.deflection > 0.0 ? options.deflection : diagonal / 2000.0;
  std::string fault;
  std::optional<Sampling> bearable;
  for (const Attempt& attempt : attempts) {
    std::optional<Sampling> sampling = guarded("triangulating the faces", [&] {
      return attempt_sampling(shape, attempt, asked, options.angle, control, fault);
    });
    if (!sampling) continue;
    flip_flat_triangles(sampling->boundary);
    fault = fault_of(sampling->boundary, shape.volumes, allowed_loss);
    if (fault.empty()) return std::move(*sampling);
    if (fault_of(sampling->boundary, shape.volumes, bearable_loss).empty()) bearable = std::move(sampling);
  }
  if (bearable) return std::move(*bearable);
  throw GeometryError(
      "the boundary cannot be triangulated: " + fault +
      "; Part -> Check geometry shows faces that cross themselves or each other, Part -> Refine "
      "shape or a finer export may help");
}

}  // namespace fgmesh::brep
