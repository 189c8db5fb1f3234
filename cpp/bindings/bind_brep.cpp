// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bindings/bindings.hpp"
#include "brep/references.hpp"
#include "brep/shown_surface.hpp"
#include "core/run_control.hpp"

namespace py = pybind11;

namespace fgmesh::bindings {
namespace {

std::vector<Reference> references(const std::string& shape, const std::vector<std::string>& names,
                                  RunControl* control) {
  RunControl unwatched;
  std::vector<Reference> made = make_references(shape, names, control ? *control : unwatched);
  const auto content = std::make_shared<const std::string>(shape);
  for (Reference& reference : made) reference.shape = content;
  return made;
}

/// Formulas can be checked with these; a shape that no one should read here goes to another process as it is.
std::vector<Reference> unread_references(const std::string& shape, const std::vector<std::string>& names) {
  const auto content = std::make_shared<const std::string>(shape);
  std::vector<Reference> made;
  for (const std::string& name : names) made.push_back({name, name.rfind("Solid", 0) == 0, nullptr, content});
  return made;
}

py::array_t<double> as_rows(const std::vector<Vec3>& points) {
  py::array_t<double> rows({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  double* out = rows.mutable_data();
  for (const Vec3& p : points) {
    for (const double coordinate : {p.x(), p.y(), p.z()}) *out++ = coordinate;
  }
  return rows;
}

py::list triangles(const std::string& shape, double deflection, double angle, RunControl* control) {
  RunControl unwatched;
  std::vector<FaceTriangles> faces;
  {
    const py::gil_scoped_release released;
    faces = shown_triangles(shape, deflection, angle, control ? *control : unwatched);
  }
  py::list found;
  for (const FaceTriangles& face : faces) {
    py::array_t<std::int64_t> corners({static_cast<py::ssize_t>(face.triangles.size()), py::ssize_t{3}});
    std::int64_t* out = corners.mutable_data();
    for (const std::array<int, 3>& triangle : face.triangles)
      out = std::copy(triangle.begin(), triangle.end(), out);
    found.append(py::make_tuple(face.solid, as_rows(face.points), corners));
  }
  return found;
}

py::array_t<double> reach(const std::string& shape) {
  RunControl unwatched;
  std::vector<Vec3> points;
  {
    const py::gil_scoped_release released;
    points = reach_points(shape, unwatched);
  }
  return as_rows(points);
}

}  // namespace

void bind_brep(py::module_& module) {
  py::class_<Reference>(module, "Reference",
                        "A face, edge, vertex or solid of a shape to which formulas measure distances.")
      .def_readonly("name", &Reference::name, "As FreeCAD has it: \"Face3\".")
      .def_readonly("is_solid", &Reference::is_solid, "Whether its distance has a sign, too.")
      .def_property_readonly(
          "shape", [](const Reference& reference) { return py::bytes(*reference.shape); },
          "Content of the file that it was found in.")
      .def_property_readonly(
          "is_read", [](const Reference& reference) { return reference.distance != nullptr; },
          "Whether the shape has been read, so that the distance can be evaluated.")
      .def("__repr__", [](const Reference& reference) { return "<Reference: " + reference.name + ">"; });

  module.def(
      "references", &references, py::arg("shape"), py::arg("names"), py::arg("control") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "A list of Reference to the parts `names` of the solids in the content (bytes) of a BREP or STEP "
      "file. Raises InvalidInput that names a part which is not there, GeometryError or Cancelled.");
  module.def("unread_references", &unread_references, py::arg("shape"), py::arg("names"),
             "The same without a look at the shape: for a material that is checked here and evaluated in "
             "another process.");

  module.def("shown_triangles", &triangles, py::arg("shape"), py::arg("deflection"), py::arg("angle"),
             py::arg("control") = py::none(),
             "(solid, points (n, 3), triangles (m, 3)) of each face of each solid in the content (bytes) of "
             "a BREP or "
             "STEP file, to be looked at; solids count from 0. deflection in mm, angle in radians. Raises "
             "InvalidInput, GeometryError or Cancelled.");
  module.def("reach_points", &reach, py::arg("shape"),
             "Points (n, 3) of the boundary of the shape in the content (bytes) of a BREP or STEP file that "
             "tell how far "
             "it reaches in any direction. Raises InvalidInput or GeometryError.");
}

}  // namespace fgmesh::bindings
