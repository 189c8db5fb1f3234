// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "bindings/bindings.hpp"
#include "core/error.hpp"
#include "core/run_control.hpp"
#include "material/material.hpp"
#include "pipeline/estimate.hpp"
#include "pipeline/generate_mesh.hpp"

namespace py = pybind11;

namespace fgmesh::bindings {
namespace {

/// Calls `visit(name, member)` for every field of MeshingOptions: all that Python knows of them comes from
/// here.
template <class Visit>
void for_each_option(Visit visit) {
  visit("material_threshold", &MeshingOptions::material_threshold);
  visit("surface_deviation", &MeshingOptions::surface_deviation);
  visit("min_size", &MeshingOptions::min_size);
  visit("max_size", &MeshingOptions::max_size);
  visit("anisotropy", &MeshingOptions::anisotropy);
  visit("order", &MeshingOptions::order);
  visit("paper", &MeshingOptions::paper);
  visit("certify", &MeshingOptions::certify);
  visit("stop_after", &MeshingOptions::stop_after);
  visit("threads", &MeshingOptions::threads);
  visit("seed", &MeshingOptions::seed);
}

std::string repr_of(const py::object& object) { return py::str(py::repr(object)); }

py::dict as_dict(const MeshingOptions& options) {
  py::dict result;
  for_each_option([&](const char* name, auto member) { result[name] = options.*member; });
  return result;
}

std::string in_words(const MeshingOptions& options) {
  std::string text;
  for_each_option([&](const char* name, auto member) {
    text += std::string(text.empty() ? "" : ", ") + name + "=" + repr_of(py::cast(options.*member));
  });
  return "MeshingOptions(" + text + ")";
}

MeshingOptions options_from(const py::kwargs& given) {
  MeshingOptions options;
  std::size_t known = 0;
  for_each_option([&](const char* name, auto member) {
    if (!given.contains(name)) return;
    ++known;
    const py::object value = given[name];
    try {
      options.*member = value.cast<std::decay_t<decltype(options.*member)>>();
    } catch (const py::cast_error&) {
      const std::string kind = py::str(py::type::of(py::cast(options.*member)).attr("__name__"));
      throw py::type_error("MeshingOptions: " + std::string(name) + " is a " + kind + ", not " +
                           repr_of(value));
    }
  });
  if (known == given.size()) return options;
  const py::dict all = as_dict(options);
  for (const auto& item : given) {
    if (all.contains(item.first)) continue;
    const std::string names = py::str(py::str(", ").attr("join")(all));
    throw py::type_error("MeshingOptions has no option '" + std::string(py::str(item.first)) +
                         "'; there are " + names);
  }
  return options;
}

void bind_options(py::module_& module) {
  const std::string doc =
      in_words({}) +
      "\n\nHow a mesh is to be; keyword arguments only. Lengths in mm; 0: a default in proportion to the "
      "part."
      "\nmaterial_threshold: largest difference of composition in a tetrahedron, in (0, 1]."
      "\nsurface_deviation: largest distance of a facet's centre to the true boundary."
      "\nmin_size, max_size: of edges. anisotropy: largest stretch across the gradient. order: 2 for "
      "ten-node tetrahedra."
      "\npaper: keeps to the paper where FGMesh departs from it for fewer elements (docs/method.md)."
      "\ncertify: whether the threshold is proved over the whole of each tetrahedron."
      "\nstop_after: \"initial\", \"material\" or \"geometry\". threads: at most as many are used, 0: all "
      "processors; the mesh does not depend on it. seed: of random choices.";
  py::class_<MeshingOptions> options(module, "MeshingOptions", doc.c_str());
  options.def(py::init(&options_from));
  for_each_option([&](const char* name, auto member) { options.def_readwrite(name, member); });
  options
      .def("validate", &MeshingOptions::validate, "Raises InvalidInput that names the option out of range.")
      .def("as_dict", &as_dict, "Every option by name.")
      .def_static(
          "fields", [] { return as_dict({}); }, "Every option's name and default.")
      .def("__repr__", &in_words)
      .def(
          "__eq__",
          [](const MeshingOptions& a, const MeshingOptions& b) { return as_dict(a).equal(as_dict(b)); },
          py::is_operator());
  // Changeable, so not to be a key.
  options.attr("__hash__") = py::none();
}

void bind_report(py::module_& module) {
  py::class_<Histogram>(module, "Histogram", "Counts over equal bins of [low, high].")
      .def_readonly("low", &Histogram::low)
      .def_readonly("high", &Histogram::high)
      .def_readonly("counts", &Histogram::counts);

  py::class_<StageReport>(module, "StageReport", "The figures of one stage; angles in degrees.")
      .def_readonly("name", &StageReport::name)
      .def_readonly("points", &StageReport::points)
      .def_readonly("facets", &StageReport::facets)
      .def_readonly("tets", &StageReport::tets)
      .def_readonly("variation_min", &StageReport::variation_min)
      .def_readonly("variation_max", &StageReport::variation_max)
      .def_readonly("variation_mean", &StageReport::variation_mean)
      .def_readonly("above_threshold", &StageReport::above_threshold)
      .def_readonly("variation_histogram", &StageReport::variation_histogram)
      .def_readonly("dihedral_min", &StageReport::dihedral_min)
      .def_readonly("dihedral_max", &StageReport::dihedral_max)
      .def_readonly("dihedral_histogram", &StageReport::dihedral_histogram)
      .def_readonly("seconds", &StageReport::seconds);

  py::class_<CertificateReport>(module, "CertificateReport",
                                "What is proved of the threshold over the whole of each tetrahedron.")
      .def_readonly("made", &CertificateReport::made)
      .def_property_readonly("holds", &CertificateReport::holds)
      .def_readonly("tets", &CertificateReport::tets)
      .def_readonly("broken", &CertificateReport::broken)
      .def_readonly("unproved", &CertificateReport::unproved)
      .def_readonly("bound", &CertificateReport::bound)
      .def_readonly("seconds", &CertificateReport::seconds);
}

/// A read-only array over memory that `owner`, a Python object, keeps alive.
template <class Number>
py::array view(const void* data, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array result(py::dtype::of<Number>(), std::move(shape), data, owner);
  result.attr("flags").attr("writeable") = false;
  return result;
}

template <class Number>
py::array column(const std::vector<Number>& values, const py::object& owner) {
  return view<Number>(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Rows that lie in memory as `Number`s one after another: points, tetrahedra, carriers.
template <class Number, class Row>
py::array table(const std::vector<Row>& rows, const py::object& owner) {
  static_assert(sizeof(Row) % sizeof(Number) == 0 && std::is_standard_layout_v<Row>);
  constexpr py::ssize_t kColumns = sizeof(Row) / sizeof(Number);
  return view<Number>(rows.data(), {static_cast<py::ssize_t>(rows.size()), kColumns}, owner);
}

/// The rows of the mesh as it was asked for: of first or of second order.
template <class Number, class Row, class LongRow>
void def_table(py::class_<MeshingResult>& result, const char* name, std::vector<Row> TetMesh::*rows,
               std::vector<LongRow> SecondOrderMesh::*long_rows) {
  result.def_property_readonly(name, [rows, long_rows](const py::object& self) {
    const MeshingResult& found = self.cast<const MeshingResult&>();
    return found.second_order.tets.empty() ? table<Number>(found.mesh.*rows, self)
                                           : table<Number>(found.second_order.*long_rows, self);
  });
}

template <class Number>
void def_column(py::class_<MeshingResult>& result, const char* name, std::vector<Number> TetMesh::*values) {
  result.def_property_readonly(name, [values](const py::object& self) {
    return column(self.cast<const MeshingResult&>().mesh.*values, self);
  });
}

template <class Number>
void def_column(py::class_<MeshingResult>& result, const char* name,
                std::vector<Number> MeshingResult::*values) {
  result.def_property_readonly(name, [values](const py::object& self) {
    return column(self.cast<const MeshingResult&>().*values, self);
  });
}

py::array fractions(const py::object& self) {
  const MeshingResult& found = self.cast<const MeshingResult&>();
  const py::ssize_t columns = found.constituents, size = found.fractions.size();
  return view<double>(found.fractions.data(), {size / columns, columns}, self);
}

/// Of four or ten nodes; none where all solids have one material.
py::array tet_fractions(const py::object& self) {
  const MeshingResult& found = self.cast<const MeshingResult&>();
  const py::ssize_t nodes = found.second_order.tets.empty() ? 4 : 10, columns = found.constituents;
  const py::ssize_t rows = found.tet_fractions.size() / (nodes * columns);
  return view<double>(found.tet_fractions.data(), {rows, nodes, columns}, self);
}

void bind_result(py::module_& module) {
  py::class_<MeshingResult> result(
      module, "MeshingResult",
      "A mesh and its figures. Arrays are read-only views of the C++ memory, which "
      "lives as long as any of them.");
  def_table<double>(result, "points", &TetMesh::points, &SecondOrderMesh::points);
  def_table<std::int32_t>(result, "carriers", &TetMesh::carriers, &SecondOrderMesh::carriers);
  def_table<std::int32_t>(result, "tets", &TetMesh::tets, &SecondOrderMesh::tets);
  def_column(result, "tet_solids", &TetMesh::tet_solids);
  def_table<std::int32_t>(result, "triangles", &TetMesh::triangles, &SecondOrderMesh::triangles);
  def_column(result, "triangle_faces", &TetMesh::triangle_faces);
  def_table<std::int32_t>(result, "edges", &TetMesh::edges, &SecondOrderMesh::edges);
  def_column(result, "edge_edges", &TetMesh::edge_edges);
  result.def_property_readonly("fractions", &fractions);
  def_column(result, "variation", &MeshingResult::variation);
  def_column(result, "dihedral_min", &MeshingResult::dihedral_min);
  def_column(result, "above_threshold", &MeshingResult::above_threshold);
  result.def_property_readonly("coincident_faces", [](const py::object& self) {
    return table<std::int32_t>(self.cast<const MeshingResult&>().coincident_faces, self);
  });
  def_column(result, "solid_volumes", &MeshingResult::solid_volumes);
  def_column(result, "shape_solid_volumes", &MeshingResult::shape_solid_volumes);
  result.def_property_readonly("tet_fractions", &tet_fractions);
  def_column(result, "forced_angles", &MeshingResult::forced_angles);
  def_column(result, "small_angles", &MeshingResult::small_angles);
  def_column(result, "broken", &MeshingResult::broken);
  def_column(result, "unproved", &MeshingResult::unproved);
  result.def_property_readonly("straightened", [](const py::object& self) {
    return column(self.cast<const MeshingResult&>().second_order.straightened, self);
  });
  result.def_readonly("stages", &MeshingResult::stages)
      .def_readonly("status", &MeshingResult::status)
      .def_readonly("messages", &MeshingResult::messages)
      .def_readonly("certificate", &MeshingResult::certificate)
      .def_readonly("angle_goal", &MeshingResult::angle_goal)
      .def_readonly("element_ratio", &MeshingResult::element_ratio)
      .def_readonly("deviation_max", &MeshingResult::deviation_max)
      .def_readonly("surface_deviation", &MeshingResult::surface_deviation)
      .def_readonly("volume", &MeshingResult::volume)
      .def_readonly("shape_volume", &MeshingResult::shape_volume)
      .def_readonly("threads", &MeshingResult::threads)
      .def_readonly("peak_memory_mb", &MeshingResult::peak_memory_mb)
      .def("__repr__", [](const MeshingResult& result) {
        return py::str("<MeshingResult: {} tetrahedra, {} points, {}>")
            .format(result.mesh.tets.size(), result.fractions.size() / result.constituents, result.status);
      });
}

using MeshFunction = MeshingResult(const std::string&, const std::vector<const CompositionField*>&,
                                   const MeshingOptions&, RunControl&);

/// A function of the pipeline as Python calls it. `options` is a copy: the Python object may change while the
/// run goes on without the GIL.
template <auto function>
auto call(const std::string& shape, const std::vector<const Material*>& materials, MeshingOptions options,
          RunControl* control) {
  for (const Material* material : materials)
    if (!material) throw InvalidInput("None is no material: give a Material for each solid");
  RunControl unwatched;
  return function(shape, {materials.begin(), materials.end()}, options, control ? *control : unwatched);
}

void bind_estimate(py::module_& module) {
  py::class_<MeshEstimate>(module, "MeshEstimate", "What is to be expected of a mesh.")
      .def_readonly("tets", &MeshEstimate::tets, "Number of tetrahedra.")
      .def_readonly("memory_mb", &MeshEstimate::memory_mb,
                    "Largest resident memory of a process that does nothing but mesh, MB.")
      .def("__repr__", [](const MeshEstimate& estimate) {
        return py::str("<MeshEstimate: {:.0f} tetrahedra, {:.0f} MB>")
            .format(estimate.tets, estimate.memory_mb);
      });
  module.def("estimate", &call<&estimate_mesh>, py::arg("shape"), py::arg("materials"),
             py::arg("options") = MeshingOptions(), py::arg("control") = py::none(),
             py::call_guard<py::gil_scoped_release>(),
             "What generate_mesh would give for these arguments, as a MeshEstimate.");
}

}  // namespace

void bind_pipeline(py::module_& module) {
  bind_options(module);
  bind_report(module);
  bind_result(module);
  bind_estimate(module);
  module.def("generate_mesh", &call<static_cast<MeshFunction*>(&generate_mesh)>, py::arg("shape"),
             py::arg("materials"), py::arg("options") = MeshingOptions(), py::arg("control") = py::none(),
             py::call_guard<py::gil_scoped_release>(),
             "Mesh the solids in the content (bytes) of a BREP or STEP file. materials: a list, one for all "
             "solids or one for each. Other Python threads run "
             "meanwhile. Gives "
             "a MeshingResult; raises InvalidInput, GeometryError or Cancelled.");
}

}  // namespace fgmesh::bindings
