// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace fgmesh {

/// All that a user may choose about a mesh. The defaults stand here and nowhere else: bindings,
/// command line and FreeCAD properties read them from here.
struct MeshingOptions {
  /// delta_0: the largest difference of composition allowed inside one tetrahedron, in (0, 1].
  double material_threshold = 0.1;
  /// Largest distance of a boundary facet's centre (or of the middle of a mesh edge that follows a
  /// B-Rep edge) to the true boundary, mm; 0: the diagonal of the part / 2000, or as much less, down to a
  /// twentieth of that, as keeps the volume of each solid within 0.5 %.
  double surface_deviation = 0.0;
  /// No refinement makes edges shorter than this, mm; 0: the diagonal of the part / 2000.
  double min_size = 0.0;
  /// No edge is longer, mm, unless min_size is in the way; 0: elements are at most about the diagonal of the
  /// part / 8 long, a few edges longer.
  double max_size = 0.0;
  /// How many times longer elements may be across the gradient than along it, from 1, isotropic, to 10. They
  /// are less where level sets are bent or max_size is in the way. Angles of 15 to 157 degrees, that
  /// isotropic elements are held to, become wider with it: 10.8 to 163.5 at 3.
  double anisotropy = 1.0;
  /// 1: four-node tetrahedra; 2: ten-node tetrahedra.
  int order = 1;
  /// The material-oriented loop as the paper has it, and M-vertices that never move after it: see
  /// docs/method.md.
  bool paper = false;
  /// Whether the threshold is proved over the whole of each tetrahedron, and not at its corners alone, once
  /// the last stage but "initial" has run; tetrahedra that break it in between are split.
  bool certify = true;
  /// "initial", "material" or "geometry": the last stage to run.
  std::string stop_after = "geometry";
  /// At most as many are used, and no more than there are processors; 0: all of them. The mesh does not
  /// depend on it.
  int threads = 0;
  /// Of random choices; without effect, since nothing is left to chance.
  std::uint32_t seed = 0;

  /// Throws InvalidInput that names the option and its allowed range.
  void validate() const;
};

}  // namespace fgmesh
