// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <STEPControl_Reader.hxx>
#include <string>
#include <vector>

namespace fgmesh::brep {

/// What OpenCASCADE finds wrong with entities of the file that has been loaded, where the shape does not
/// depend on it: names left out, for example. One note, or none. Throws InvalidInput that names the entity
/// where a fault is in geometry, in a place or in a unit: OpenCASCADE follows its references to nowhere, and
/// crashes.
std::vector<std::string> harmless_faults(const STEPControl_Reader& reader);

/// Throws GeometryError that names an entity which describes a solid of the shape, and from which no solid,
/// or one without its cavities, was made. Returns a note on each solid that has fewer faces than its entity.
/// To be called after the transfer.
std::vector<std::string> require_all_solids(const STEPControl_Reader& reader);

}  // namespace fgmesh::brep
