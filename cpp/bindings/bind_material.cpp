// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/bindings.hpp"
#include "core/error.hpp"
#include "core/run_control.hpp"
#include "material/formula_error.hpp"
#include "material/formula_names.hpp"
#include "material/material.hpp"
#include "material/sampled_table.hpp"

namespace py = pybind11;

namespace fgmesh::bindings {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "rows of NumPy arrays are read as points in place");

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

struct Points {
  const Vec3* data;
  std::size_t count;
};

Points as_points(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) throw InvalidInput("points must be an array of shape (n, 3)");
  return {reinterpret_cast<const Vec3*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

void require_read(const std::vector<Reference>& references) {
  for (const Reference& reference : references) {
    if (!reference.distance) {
      throw InvalidInput("the reference " + reference.name +
                         " has not been read: evaluate core.read_references(material)");
    }
  }
}

void require_rows(const Array& distances, std::size_t rows, std::size_t columns) {
  if (distances.ndim() == 2 && distances.shape(0) == static_cast<py::ssize_t>(rows) &&
      distances.shape(1) == static_cast<py::ssize_t>(columns))
    return;
  throw InvalidInput("distances must be an array of shape (" + std::to_string(rows) + ", " +
                     std::to_string(columns) +
                     "): a row for each point, with the distance to each reference");
}

/// Rows of the arrays that a CompositionField fills, with the remainder as their last: (n, k) of numbers or
/// (n, k, 3) of vectors, the remainder of `whole`.
template <class Part>
Array with_remainder(const std::vector<Part>& parts, std::size_t count, int constituents, const Part& whole,
                     std::vector<py::ssize_t> shape) {
  Array result(std::move(shape));
  Part* out = reinterpret_cast<Part*>(result.mutable_data());
  for (std::size_t i = 0; i < count; ++i) {
    Part rest = whole;
    for (int k = 0; k + 1 < constituents; ++k) {
      const Part& part = parts[k * count + i];
      *out++ = part;
      rest -= part;
    }
    *out++ = rest;
  }
  return result;
}

Array evaluate(const Material& material, const Array& array, const std::optional<Array>& distances) {
  const Points points = as_points(array);
  if (distances)
    require_rows(*distances, points.count, material.references().size());
  else
    require_read(material.references());
  const int constituents = material.constituents();
  std::vector<double> fractions(points.count * (constituents - 1));
  {
    const py::gil_scoped_release released;
    if (distances)
      material.evaluate_at(points.data, distances->data(), points.count, fractions.data());
    else
      material.evaluate(points.data, points.count, fractions.data());
  }
  return with_remainder(fractions, points.count, constituents, 1.0, {array.shape(0), constituents});
}

/// In blocks, so that it listens to the control.
Array distances(const std::vector<Reference>& references, const Array& array, RunControl* control) {
  require_read(references);
  constexpr std::size_t kBlock = 1024;
  const Points points = as_points(array);
  Array table({points.count, references.size()});
  double* const out = table.mutable_data();
  const py::gil_scoped_release released;
  if (control) control->begin_stage("distances");
  std::vector<double> column(kBlock);
  for (std::size_t first = 0; first < points.count; first += kBlock) {
    if (control) {
      control->check();
      control->report(static_cast<double>(first) / points.count, 0);
    }
    const std::size_t count = std::min(kBlock, points.count - first);
    for (std::size_t j = 0; j < references.size(); ++j) {
      references[j].distance->evaluate(points.data + first, count, column.data());
      for (std::size_t i = 0; i < count; ++i) out[(first + i) * references.size() + j] = column[i];
    }
  }
  return table;
}

Array gradients(const Material& material, const Array& array) {
  require_read(material.references());
  const Points points = as_points(array);
  const int constituents = material.constituents();
  std::vector<Vec3> gradients(points.count * (constituents - 1));
  {
    const py::gil_scoped_release released;
    std::vector<double> fractions(gradients.size());
    material.evaluate(points.data, points.count, fractions.data(), gradients.data());
  }
  return with_remainder(gradients, points.count, constituents, Vec3(Vec3::Zero()),
                        {array.shape(0), constituents, py::ssize_t{3}});
}

std::pair<std::vector<double>, std::vector<double>> bounds(const Material& material, const Vec3& low,
                                                           const Vec3& high) {
  require_read(material.references());
  if (!(low.array() <= high.array()).all()) {
    throw InvalidInput("a box needs low <= high in each of its three coordinates");
  }
  std::vector<double> lowest(material.constituents() - 1), highest(lowest.size());
  material.bounds({low, high}, lowest.data(), highest.data());
  return {lowest, highest};
}

/// From {"x": places, ...} and the values at them.
std::shared_ptr<SampledTable> make_table(const py::dict& places, const Array& values) {
  std::vector<SampledTable::Axis> axes;
  std::vector<py::ssize_t> shape;
  for (const auto& [key, value] : places) {
    const std::string name = py::cast<std::string>(key);
    const auto coordinate = find_variable(name);
    if (!coordinate)
      throw InvalidInput("a table has no coordinate " + in_quotes(name) + ": known are x y z r theta d");
    axes.push_back({*coordinate, py::cast<std::vector<double>>(value)});
    shape.push_back(static_cast<py::ssize_t>(axes.back().places.size()));
  }
  if (!std::equal(shape.begin(), shape.end(), values.shape(), values.shape() + values.ndim())) {
    throw InvalidInput("the values of a table must have the shape " +
                       py::cast<std::string>(py::str(py::tuple(py::cast(shape)))) +
                       ": one for each place of each coordinate");
  }
  return std::make_shared<SampledTable>(std::move(axes),
                                        std::vector<double>(values.data(), values.data() + values.size()));
}

py::dict table_places(const SampledTable& table) {
  py::dict places;
  for (const SampledTable::Axis& axis : table.axes())
    places[py::str(std::string(variable_name(axis.coordinate)))] =
        Array(static_cast<py::ssize_t>(axis.places.size()), axis.places.data());
  return places;
}

Array table_values(const SampledTable& table) {
  std::vector<py::ssize_t> shape;
  for (const SampledTable::Axis& axis : table.axes())
    shape.push_back(static_cast<py::ssize_t>(axis.places.size()));
  return Array(shape, table.values().data());
}

constexpr char kTableDoc[] = R"(SampledTable(places, values)

Values on a rectilinear grid over one to three coordinates of a material's frame: linear in each of them between
samples, held constant outside of the grid. places: {coordinate: ascending places, two at least}, coordinates of
x y z r d (mm) and theta (radians, from -pi to pi). values: an array with a direction for each coordinate. Immutable;
core.read_table() makes one of a file. Raises InvalidInput for numbers that make no grid.)";

constexpr char kMaterialDoc[] =
    R"(Material(fractions, parameters={}, origin=(0, 0, 0), rotation=identity, references=[], tables=[])

A graded material of k constituents. fractions: a list of k - 1 formulas, the volume fractions of all
constituents but the last, which is the remainder, over x y z r theta d, pi, e, the parameters, the distances to
references and the values of tables. parameters: dict of name to number. origin (mm) and rotation (3x3, columns are the axes) place the frame that the formula measures in.
references: a list of Reference, see core.references(); d1 d2 ... are the distances to them in mm, to the boundary
where they are solids; s1 s2 ... those to solids with a sign, below zero inside. tables: a list of what
core.read_table() takes, or of SampledTable; t1 t2 ... are their values at the point. Immutable.
Raises FormulaError where a text is no formula, InvalidInput for a parameter or frame that has no meaning.)";

}  // namespace

void bind_material(py::module_& module) {
  py::class_<SampledTable, std::shared_ptr<SampledTable>>(module, "SampledTable", kTableDoc)
      .def(py::init(&make_table), py::arg("places"), py::arg("values"))
      .def_property_readonly("places", &table_places, "{coordinate: its places, (n,)}, as they were given.")
      .def_property_readonly("values", &table_values, "A direction for each coordinate.")
      .def_property_readonly_static(
          "max_values", [](const py::object&) { return SampledTable::kMaxValues; }, "The most that one has.")
      .def(
          "__eq__", [](const SampledTable& a, const SampledTable& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const SampledTable& table) {
        std::string text = "<SampledTable:";
        for (const SampledTable::Axis& axis : table.axes())
          text +=
              " " + std::to_string(axis.places.size()) + " of " + std::string(variable_name(axis.coordinate));
        return text + ">";
      });

  py::class_<Material>(module, "Material", kMaterialDoc)
      .def(py::init([](const std::vector<std::string>& fractions,
                       const std::map<std::string, double>& parameters, const Vec3& origin,
                       const Eigen::Matrix3d& rotation, const std::vector<Reference>& references,
                       const std::vector<std::shared_ptr<SampledTable>>& tables) {
             return std::make_unique<Material>(fractions, parameters, Frame{origin, rotation}, references,
                                               Tables(tables.begin(), tables.end()));
           }),
           py::arg("fractions"), py::arg("parameters") = std::map<std::string, double>(),
           py::arg("origin") = Frame().origin, py::arg("rotation") = Frame().rotation,
           py::arg("references") = std::vector<Reference>(), py::kw_only(),
           py::arg("tables") = std::vector<std::shared_ptr<SampledTable>>())
      .def_property_readonly("fractions", &Material::fractions)
      .def_property_readonly("parameters", &Material::parameters)
      .def_property_readonly("origin", [](const Material& material) { return Vec3(material.frame().origin); })
      .def_property_readonly(
          "rotation", [](const Material& material) { return Eigen::Matrix3d(material.frame().rotation); })
      .def_property_readonly("references", &Material::references)
      .def_property_readonly("tables",
                             [](const Material& material) {
                               std::vector<std::shared_ptr<SampledTable>> tables;
                               for (const auto& table : material.tables())  // bindings know no const
                                 tables.push_back(std::const_pointer_cast<SampledTable>(table));
                               return tables;
                             })
      .def("evaluate", &evaluate, py::arg("points"), py::arg("distances") = py::none(),
           "Volume fractions (n, k) of all constituents at points (n, 3) in mm; NaN where a formula is not "
           "defined. distances "
           "(n, r): those to the r references at the points, where they are known, as core.distances() gives "
           "them; the references then need not have been read.")
      .def(
          "gradients", &gradients, py::arg("points"),
          "Gradients (n, k, 3) of the volume fractions in 1/mm at points (n, 3), along the world's axes. NaN "
          "only where the value is; zero where the direction is not unique (d at the origin); infinite where "
          "it is unbounded.")
      .def("bounds", &bounds, py::arg("low"), py::arg("high"), py::call_guard<py::gil_scoped_release>(),
           "Certain bounds of all fractions but the last over the box between two corners, a list of k - 1 "
           "low "
           "ones and one of high ones; NaN where a fraction is defined nowhere.")
      .def("__repr__", [](const Material& material) {
        return py::str("Material({!r}, parameters={!r})")
            .format(py::cast(material.fractions()), py::cast(material.parameters()));
      });

  module.def(
      "distances", &distances, py::arg("references"), py::arg("points"), py::arg("control") = py::none(),
      "Distances (n, r) in mm from points (n, 3) to r references that have been read; to solids with a "
      "sign, below zero inside.");

  module.def(
      "caret_excerpt",
      [](const std::string& formula, std::size_t position) { return caret_excerpt(formula, position); },
      py::arg("formula"), py::arg("position"),
      "Two lines for a terminal: the formula around `position` (of a FormulaError), and a caret under it.");
}

}  // namespace fgmesh::bindings
