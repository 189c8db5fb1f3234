// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings/bindings.hpp"

namespace py = pybind11;

namespace fgmesh::bindings {
namespace {

/// "7.6" of "7.6.3": OpenCASCADE keeps its binary interface within these.
std::string major_and_minor(const std::string& version) {
  return version.substr(0, version.find('.', version.find('.') + 1));
}

/// FreeCAD and this module share one OpenCASCADE; another one than it was compiled for would crash, not fail.
void check_occt() {
  for (const std::string& loaded : loaded_occt_versions()) {
    // "7": a library whose file name tells too little to judge.
    if (loaded.find('.') == std::string::npos) continue;
    if (major_and_minor(loaded) == major_and_minor(FGMESH_OCCT_VERSION)) continue;
    throw py::import_error("FGMesh was built for OpenCASCADE " FGMESH_OCCT_VERSION ", but OpenCASCADE " +
                           loaded + " is loaded: build FGMesh again on this system with ./scripts/build");
  }
}

py::dict versions() {
  py::dict result;
  result["fgmesh"] = FGMESH_VERSION;
  result["occt_compiled"] = FGMESH_OCCT_VERSION;
  result["occt_loaded"] = loaded_occt_versions();
  result["cgal"] = FGMESH_CGAL_VERSION;
  return result;
}

}  // namespace
}  // namespace fgmesh::bindings

PYBIND11_MODULE(_core, module) {
  using namespace fgmesh::bindings;
  check_occt();
  module.doc() = "The C++ side of FGMesh. Use freecad.fgmesh.core, which documents it.";
  module.attr("__version__") = FGMESH_VERSION;
  module.def(
      "versions", &versions,
      "Versions as a dict: fgmesh; occt_compiled and cgal, of the headers; occt_loaded, a list of those in "
      "this process.");
  bind_core(module);
  bind_brep(module);
  bind_material(module);
  bind_pipeline(module);
}
