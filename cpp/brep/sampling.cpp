// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/sampling.hpp"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gp_Trsf.hxx>
#include <optional>
#include <string>

#include "brep/divided_spans.hpp"
#include "brep/flat_triangles.hpp"
#include "brep/occt.hpp"
#include "brep/shape_limits.hpp"
#include "brep/surface.hpp"
#include "brep/weld.hpp"

namespace fgmesh::brep {
namespace {

/// How to triangulate: first as asked, then in ways that help where that fails.
struct Attempt {
  double factor;      ///< of the deflection asked for
  bool altered_copy;  ///< triangulate a copy, a little larger and with more knots
};
constexpr Attempt attempts[] = {{1.0, false}, {0.9, true}, {0.3, false}, {0.1, true}};

// BRepMesh of OCCT 7.6 gives up on some sound faces whose seam ends one rounding error beside another edge. A
// copy larger by less than any tolerance has other rounding errors and passes.
constexpr double imperceptible = 1e-10;

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
  const TopoDS_Compound solids = shape.topology.compound_of_solids();
  gp_Trsf growth;
  growth.SetScale(gp_Pnt(), 1.0 + imperceptible);
  std::optional<BRepBuilderAPI_Transform> copy;
  if (attempt.altered_copy) {
    copy.emplace(solids, growth, Standard_True);
    divide_spans(copy->Shape());
  }
  triangulate(copy ? copy->Shape() : solids, attempt.factor * deflection, angle, control);
  const TriangulatedCopy triangulated = [&](const TopoDS_Shape& sub_shape) {
    return copy ? copy->ModifiedShape(sub_shape).Oriented(sub_shape.Orientation()) : sub_shape;
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

/// The volume between the triangles of each solid and its true faces. Over a triangle whose face bends evenly
/// the mean distance is 3/4 of that at the centre.
std::vector<double> volumes_beyond(const Sampling& sampling, const Topology& topology) {
  std::vector<double> volumes(topology.solid_count(), 0.0);
  for (std::size_t i = 0; i < sampling.faces.size(); ++i) {
    const FaceSamples& samples = sampling.faces[i];
    if (samples.triangles.empty()) continue;
    const int number = static_cast<int>(i) + 1;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(topology.face(number));
    double volume = 0.0;  // on the side to which the surface looks
    for (const auto& [a, b, c] : samples.triangles) {
      const Vec3 &p = samples.points[a], &q = samples.points[b], &r = samples.points[c];
      const Uv &at_p = samples.uv[a], &at_q = samples.uv[b], &at_r = samples.uv[c];
      const gp_Pnt middle =
          surface->Value((at_p[0] + at_q[0] + at_r[0]) / 3.0, (at_p[1] + at_q[1] + at_r[1]) / 3.0);
      const Vec3 beyond = to_vec3(middle) - (p + q + r) / 3.0;
      volume += 0.75 * beyond.dot(0.5 * (q - p).cross(r - p));
    }
    const FaceUse& use = topology.face_use(number);
    if (use.reversed) volume = -volume;
    if (use.solid_behind) volumes[use.solid_behind - 1] += volume;
    if (use.solid_before) volumes[use.solid_before - 1] -= volume;
  }
  return volumes;
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

/// Part of the volume; a lost triangle costs more.
constexpr double allowed_loss = 0.002;

/// So many triangles are fine enough, whatever volume they lose by bending.
constexpr std::size_t many = 30000;

/// Empty where the samples bound every solid as its true faces do, but for the volumes `beyond` them; else
/// what is wrong.
std::string fault_of(const SampledBoundary& boundary, const CheckedShape& shape,
                     const std::vector<double>& beyond) {
  for (int solid = 1; solid <= boundary.solid_count; ++solid) {
    if (const int face = face_at_gap(boundary, solid)) {
      return "the triangles of Face" + std::to_string(face) + " do not meet those of its neighbours";
    }
    const double volume = sampled_volume(boundary, solid) + beyond[solid - 1];
    const double error = std::abs(volume / shape.volumes[solid - 1] - 1.0);
    if (!(error <= allowed_loss)) {
      return "the triangles of Solid" + std::to_string(solid) + " bound another volume than its faces do (" +
             std::to_string(100.0 * error) + " % off)";
    }
  }
  return {};
}

/// Whether samples without a fault are as fine as meshing likes them: at needles' tips coarse ones are not.
bool is_fine(const SampledBoundary& boundary, const CheckedShape& shape, const std::vector<double>& beyond) {
  if (boundary.triangles.size() > many) return true;
  for (std::size_t i = 0; i < beyond.size(); ++i)
    if (!(std::abs(beyond[i]) <= allowed_loss * shape.volumes[i])) return false;
  return true;
}

}  // namespace

Sampling sample_boundary(const CheckedShape& shape, const SamplingOptions& options, RunControl& control) {
  const double diagonal = shape.bounds.diagonal();
  const double asked = options.deflection > 0.0 ? options.deflection : diagonal / 2000.0;
  std::string fault;
  std::optional<Sampling> coarse;
  for (const Attempt& attempt : attempts) {
    std::optional<Sampling> sampling = guarded("triangulating the faces", [&] {
      return attempt_sampling(shape, attempt, asked, options.angle, control, fault);
    });
    if (!sampling) continue;
    flip_flat_triangles(sampling->boundary);
    const std::vector<double> beyond = volumes_beyond(*sampling, shape.topology);
    fault = fault_of(sampling->boundary, shape, beyond);
    if (!fault.empty()) continue;
    if (is_fine(sampling->boundary, shape, beyond)) return std::move(*sampling);
    coarse = std::move(sampling);
  }
  if (coarse) return std::move(*coarse);
  const std::string gap = largest_gap(shape.topology, diagonal);
  if (!gap.empty()) fault += "; " + gap + ", which may be the cause";
  throw GeometryError(
      "the boundary cannot be triangulated: " + fault +
      "; Part -> Check geometry shows faces that cross themselves or each other, Part -> Refine "
      "shape or a finer export may help");
}

}  // namespace fgmesh::brep
