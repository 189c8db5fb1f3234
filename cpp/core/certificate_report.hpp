// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace fgmesh {

/// What is proved of the material threshold over the whole of each tetrahedron.
struct CertificateReport {
  bool made = false;         ///< false: not asked for
  std::size_t tets = 0;      ///< that were looked at: all
  std::size_t broken = 0;    ///< those in which two points are known to differ by more than the threshold
  std::size_t unproved = 0;  ///< those neither proved nor broken
  double bound = 0.0;        ///< no tetrahedron that is proved varies by more
  double seconds = 0.0;      ///< for the proofs, and for mending what was broken

  bool holds() const { return made && broken == 0 && unproved == 0; }
};

}  // namespace fgmesh
