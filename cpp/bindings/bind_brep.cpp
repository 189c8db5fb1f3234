// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "bindings/bindings.hpp"
#include "brep/references.hpp"
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
}

}  // namespace fgmesh::bindings
