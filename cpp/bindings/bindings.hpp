// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace fgmesh::bindings {

// One a folder of C++; called in this order when Python imports the module.
void bind_core(pybind11::module_& module);
void bind_brep(pybind11::module_& module);
void bind_material(pybind11::module_& module);
void bind_pipeline(pybind11::module_& module);

/// Versions of the OpenCASCADE libraries in this process, such as "7.6.3": those of their file names. More
/// than one where different copies were loaded, empty where there is none.
std::vector<std::string> loaded_occt_versions();

}  // namespace fgmesh::bindings
