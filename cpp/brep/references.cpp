// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/references.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "brep/distance_field.hpp"
#include "brep/occt.hpp"
#include "brep/shape_reader.hpp"

namespace fgmesh {
namespace {

using brep::MeasuredShape;
using brep::Piece;

enum class Kind { face, edge, vertex, solid };

struct Part {
  Kind kind;
  int number;
};

/// Throws InvalidInput for a name that is none, and for a number that the shape does not have.
Part find_part(const std::string& name, const brep::Topology& topology) {
  const struct {
    const char* word;
    Kind kind;
    int count;
  } kinds[] = {{"Face", Kind::face, topology.face_count()},
               {"Edge", Kind::edge, topology.edge_count()},
               {"Vertex", Kind::vertex, topology.vertex_count()},
               {"Solid", Kind::solid, topology.solid_count()}};
  const auto first_digit =
      std::find_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const std::string word(name.begin(), first_digit), digits(first_digit, name.end());
  const bool is_number =
      !digits.empty() && digits[0] != '0' &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  for (const auto& kind : kinds) {
    if (word != kind.word || !is_number) continue;
    const bool exists = digits.size() < 10 && std::stoi(digits) <= kind.count;
    if (exists) return {kind.kind, std::stoi(digits)};
    throw InvalidInput("the reference " + name + " is lost: the shape ends with " + word +
                       std::to_string(kind.count) + "; choose it anew");
  }
  throw InvalidInput("the reference '" + name + "' names no part: write Face1, Edge1, Vertex1 or Solid1");
}

[[noreturn]] void refuse_loose(const std::string& name) {
  throw InvalidInput("the reference " + name +
                     " bounds no solid of the shape; choose a face, edge or vertex of a solid");
}

std::vector<int> faces_of(int solid, const brep::Topology& topology) {
  std::vector<int> faces;
  for (int face = 1; face <= topology.face_count(); ++face) {
    const brep::FaceUse& use = topology.face_use(face);
    if (use.solid_behind == solid || use.solid_before == solid) faces.push_back(face);
  }
  return faces;
}

std::vector<Piece> pieces_of(const Part& part, const std::string& name, const MeasuredShape& measured,
                             RunControl& control) {
  const brep::Topology& topology = measured.shape.topology;
  switch (part.kind) {
    case Kind::face:
      if (topology.face_use(part.number).solid_behind == 0) refuse_loose(name);
      return pieces_of_faces(measured, {part.number}, control);
    case Kind::edge:
      if (topology.edge_use(part.number).count == 0) refuse_loose(name);
      return pieces_of_edge(measured, part.number);
    case Kind::vertex:
      return pieces_of_vertex(measured, part.number);
    case Kind::solid:
      break;
  }
  return pieces_of_faces(measured, faces_of(part.number, topology), control);
}

}  // namespace

std::vector<Reference> make_references(const std::string& shape, const std::vector<std::string>& names,
                                       RunControl& control) {
  control.begin_stage("references");
  brep::CheckedShape checked = brep::check_solids(brep::read_shape(shape, control).shape, control);
  std::vector<Part> parts;
  for (const std::string& name : names) parts.push_back(find_part(name, checked.topology));
  const auto measured = std::make_shared<MeasuredShape>(MeasuredShape{std::move(checked), {}, {}});
  measured->sampling = brep::sample_boundary(measured->shape, {}, control);
  return brep::guarded("preparing distances", [&] {
    measured->projections = brep::Projections(measured->shape.topology, measured->sampling, control);
    std::vector<Reference> references;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool is_solid = parts[i].kind == Kind::solid;
      references.push_back(
          {names[i], is_solid,
           std::make_shared<brep::DistanceField>(measured, pieces_of(parts[i], names[i], *measured, control),
                                                 is_solid ? parts[i].number : 0)});
    }
    return references;
  });
}

}  // namespace fgmesh
