// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <memory>
#include <string>

#include "bindings/bindings.hpp"
#include "core/error.hpp"
#include "core/run_control.hpp"

namespace py = pybind11;

namespace fgmesh::bindings {
namespace {

// The translator below outlives every module object, so these references are never given back.
struct ExceptionClasses {
  PyObject* error = nullptr;
  PyObject* invalid_input = nullptr;
  PyObject* formula_error = nullptr;
  PyObject* geometry_error = nullptr;
  PyObject* cancelled = nullptr;
} classes;

PyObject* make_class(py::module_& module, const char* name, const char* doc, const py::tuple& bases) {
  const std::string full_name = "freecad.fgmesh._core." + std::string(name);
  PyObject* const result = PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), nullptr);
  if (!result) throw py::error_already_set();
  module.attr(name) = py::handle(result);
  return result;
}

void raise_formula_error(const FormulaError& error) {
  try {
    py::object instance = py::handle(classes.formula_error)(error.what());
    instance.attr("position") = error.position();
    instance.attr("formula") = error.formula();
    PyErr_SetObject(classes.formula_error, instance.ptr());
  } catch (py::error_already_set& failure) {
    failure.restore();
  }
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const FormulaError& error) {
    raise_formula_error(error);
  } catch (const InvalidInput& error) {
    PyErr_SetString(classes.invalid_input, error.what());
  } catch (const GeometryError& error) {
    PyErr_SetString(classes.geometry_error, error.what());
  } catch (const Cancelled& error) {
    PyErr_SetString(classes.cancelled, error.what());
  } catch (const Error& error) {
    PyErr_SetString(classes.error, error.what());
  }
}

void bind_errors(py::module_& module) {
  const auto bases = [](auto... items) { return py::make_tuple(py::handle(items)...); };
  classes.error = make_class(module, "Error", "Everything FGMesh raises on purpose.", bases(PyExc_Exception));
  classes.invalid_input =
      make_class(module, "InvalidInput", "An option, a file or a material that has no meaning.",
                 bases(classes.error, PyExc_ValueError));
  classes.formula_error = make_class(
      module, "FormulaError",
      "A formula that is none; `formula` is its index, `position` the offset of the fault in its text.",
      bases(classes.invalid_input));
  classes.geometry_error =
      make_class(module, "GeometryError", "The shape cannot be meshed.", bases(classes.error));
  classes.cancelled =
      make_class(module, "Cancelled", "The run was cancelled or reached a limit.", bases(classes.error));
  // So that an instance made in Python has one too.
  py::handle(classes.formula_error).attr("position") = 0;
  py::handle(classes.formula_error).attr("formula") = 0;
  py::register_exception_translator(&translate);
}

}  // namespace

void bind_core(py::module_& module) {
  bind_errors(module);

  py::class_<RunControl::Progress>(module, "Progress", "How far a run is.")
      .def_readonly("stage", &RunControl::Progress::stage, "Name of the stage; empty before the start.")
      .def_readonly("fraction", &RunControl::Progress::fraction, "Of this stage, in [0, 1].")
      .def_readonly("tets", &RunControl::Progress::tets, "Tetrahedra in the mesh at this moment.")
      .def_readonly("expected_tets", &RunControl::Progress::expected_tets,
                    "About as many tetrahedra are expected of the finished mesh; 0: not known (yet).")
      .def_property_readonly(
          "place",
          [](const RunControl::Progress& progress) -> py::object {
            if (!progress.place) return py::none();
            return py::make_tuple(progress.place->x(), progress.place->y(), progress.place->z());
          },
          "Where the stage is at work, mm; None where it does not tell.")
      .def("__repr__", [](const RunControl::Progress& progress) {
        return py::str("Progress(stage={!r}, fraction={:.3f}, tets={})")
            .format(progress.stage, progress.fraction, progress.tets);
      });

  py::class_<RunControl, std::shared_ptr<RunControl>>(
      module, "RunControl",
      "Watch or stop a run that goes on in another thread. Any thread may call any member.")
      .def(py::init<>())
      .def("cancel", &RunControl::cancel, "Stop the run within two seconds; it raises Cancelled.")
      .def("cancelled", &RunControl::cancelled)
      .def("progress", &RunControl::progress, "The Progress at this moment.")
      .def("set_limits", &RunControl::set_limits, py::arg("seconds") = 0.0, py::arg("memory_mb") = 0.0,
           "Limits in seconds from now and in MB of resident memory; 0: none.")
      .def("seconds_left", &RunControl::seconds_left,
           "Seconds until the time limit, negative after it; infinite where there is none.")
      .def("memory_limit_mb", &RunControl::memory_limit_mb, "The limit of resident memory, MB; 0: none.")
      .def("begin_stage", &RunControl::begin_stage, py::arg("name"),
           "Tell of a new stage; for those who pass on the progress of a run in another process.")
      .def("report", &RunControl::report, py::arg("fraction"), py::arg("tets"),
           "Tell how far the stage is; as begin_stage.")
      .def("expect", &RunControl::expect, py::arg("tets"),
           "Tell how many tetrahedra are expected; as begin_stage.")
      .def(
          "look_at",
          [](RunControl& control, double x, double y, double z) { control.look_at(Vec3(x, y, z)); },
          py::arg("x"), py::arg("y"), py::arg("z"), "Tell where the stage is at work, mm; as begin_stage.");

  module.def("peak_memory_mb", &peak_memory_mb, "Largest resident memory of this process so far, MB.");
}

}  // namespace fgmesh::bindings
