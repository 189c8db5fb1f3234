// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/brep_model.hpp"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Tool.hxx>
#include <algorithm>
#include <list>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "brep/occt.hpp"
#include "brep/projections.hpp"
#include "brep/sampling.hpp"
#include "brep/self_interference.hpp"
#include "brep/shape_check.hpp"
#include "brep/shape_reader.hpp"
#include "brep/told_as_separated.hpp"

namespace fgmesh {

struct BrepModel::State {
  brep::CheckedShape shape;
  brep::Projections projections;

  // A classifier remembers its last ray, so only one thread may ask.
  mutable std::mutex classifier_mutex;
  mutable std::list<BRepClass3d_SolidClassifier> classifiers;  // they cannot be moved

  explicit State(brep::CheckedShape checked) : shape(std::move(checked)) {}

  template <class Projector>
  static const Projector& at(const std::vector<std::optional<Projector>>& projectors, int number,
                             const char* kind) {
    if (number < 1 || number > static_cast<int>(projectors.size()) || !projectors[number - 1]) {
      throw std::out_of_range(kind + std::to_string(number) + " bounds no solid, or sample() was not called");
    }
    return *projectors[number - 1];
  }
};

BrepModel::BrepModel(std::unique_ptr<State> state) : state_(std::move(state)) {}
BrepModel::BrepModel(BrepModel&&) noexcept = default;
BrepModel::~BrepModel() = default;

BrepModel BrepModel::from_text(const std::string& text, RunControl& control) {
  const brep::ReadShape read = brep::read_shape(text, control);
  brep::CheckedShape checked = brep::check_shape(read.shape, control);
  checked.notes.insert(checked.notes.begin(), read.notes.begin(), read.notes.end());
  return BrepModel(std::make_unique<State>(std::move(checked)));
}

SampledBoundary BrepModel::sample(const SamplingOptions& options, RunControl& control) {
  brep::Sampling sampling = brep::told_as_separated(
      !origins().solids.empty(), [&] { return brep::sample_boundary(state_->shape, options, control); });
  brep::guarded("preparing projections",
                [&] { state_->projections = brep::Projections(state_->shape.topology, sampling, control); });
  return std::move(sampling.boundary);
}

SurfacePoint BrepModel::project_to_face(int face, const Vec3& p, const double* guess_uv) const {
  const auto& projector = State::at(state_->projections.faces, face, "Face");
  return brep::guarded("projecting to a face", [&] { return projector.project(p, guess_uv); });
}

CurvePoint BrepModel::project_to_edge(int edge, const Vec3& p, const double* guess_t) const {
  const auto& projector = State::at(state_->projections.edges, edge, "Edge");
  return brep::guarded("projecting to an edge", [&] { return projector.project(p, guess_t); });
}

Vec3 BrepModel::vertex_position(int vertex) const {
  if (vertex < 1 || vertex > vertex_count()) {
    throw std::out_of_range("Vertex" + std::to_string(vertex) + " is not in the shape");
  }
  return brep::to_vec3(BRep_Tool::Pnt(state_->shape.topology.vertex(vertex)));
}

bool BrepModel::contains(const Vec3& p, int solid, bool with_boundary) const {
  // A sloppy file's tolerance must not make points well outside count as inside.
  const double tolerance = std::min(state_->shape.tolerance, 1e-4 * bounds().diagonal());
  const std::lock_guard<std::mutex> lock(state_->classifier_mutex);
  return brep::guarded("locating a point", [&] {
    auto& classifiers = state_->classifiers;
    if (classifiers.empty()) {
      for (int number = 1; number <= solid_count(); ++number) {
        classifiers.emplace_back(state_->shape.topology.solid(number));
      }
    }
    int number = 0;
    return std::any_of(classifiers.begin(), classifiers.end(), [&](BRepClass3d_SolidClassifier& classifier) {
      if (++number != solid && solid != 0) return false;
      classifier.Perform(brep::to_gp(p), tolerance);
      return classifier.State() == TopAbs_IN || (with_boundary && classifier.State() == TopAbs_ON);
    });
  });
}

int BrepModel::solid_count() const { return state_->shape.topology.solid_count(); }
int BrepModel::face_count() const { return state_->shape.topology.face_count(); }
int BrepModel::edge_count() const { return state_->shape.topology.edge_count(); }
int BrepModel::vertex_count() const { return state_->shape.topology.vertex_count(); }
const Origins& BrepModel::origins() const { return state_->shape.origins; }
int BrepModel::given_solid_count() const {
  return origins().solids.empty() ? solid_count() : origins().solid_count;
}
int BrepModel::given_solid(int solid) const {
  return origins().solids.empty() ? solid : origins().solids[solid - 1];
}
const std::vector<double>& BrepModel::volumes() const { return state_->shape.volumes; }
double BrepModel::volume() const { return state_->shape.volume(); }
Box BrepModel::bounds() const { return state_->shape.bounds; }
const std::vector<std::string>& BrepModel::notes() const { return state_->shape.notes; }

std::vector<std::array<Carrier, 2>> BrepModel::self_interferences(RunControl& control) const {
  return brep::guarded("looking for faces that cross",
                       [&] { return brep::self_interferences(state_->shape.topology, control); });
}

}  // namespace fgmesh
