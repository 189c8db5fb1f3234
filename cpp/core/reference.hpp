// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/scalar_field.hpp"

namespace fgmesh {

/// A part of a shape to which formulas measure distances.
struct Reference {
  std::string name;       ///< as FreeCAD has it: "Face3"
  bool is_solid = false;  ///< the distance has a sign: below zero inside
  /// Null where the shape has not been read yet, which lets a formula be checked but not be evaluated.
  /// mm, to the nearest point of the face, edge, vertex, or boundary of the solid. Where several points are
  /// the nearest the gradient is that of one of them.
  std::shared_ptr<const ScalarField> distance;
  /// Content of the file that it was found in, so that another process can find it, too.
  std::shared_ptr<const std::string> shape{};
};

}  // namespace fgmesh
