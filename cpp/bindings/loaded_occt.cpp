// SPDX-License-Identifier: GPL-3.0-or-later
#include <link.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "bindings/bindings.hpp"

namespace fgmesh::bindings {
namespace {

/// OpenCASCADE has no function that tells its version; the file behind the link libTKernel.so.7 does.
int note_version(dl_phdr_info* info, std::size_t, void* data) {
  auto& versions = *static_cast<std::vector<std::string>*>(data);
  const std::string loaded = info->dlpi_name ? info->dlpi_name : "";
  if (loaded.find("libTKernel.so") == std::string::npos) return 0;
  char* const resolved = realpath(loaded.c_str(), nullptr);
  const std::string path = resolved ? resolved : loaded;
  std::free(resolved);
  constexpr char kSuffix[] = ".so.";
  const std::size_t suffix = path.rfind(kSuffix);
  if (suffix == std::string::npos) return 0;
  const std::string version = path.substr(suffix + sizeof kSuffix - 1);
  if (std::find(versions.begin(), versions.end(), version) == versions.end()) versions.push_back(version);
  return 0;
}

}  // namespace

std::vector<std::string> loaded_occt_versions() {
  std::vector<std::string> versions;
  dl_iterate_phdr(note_version, &versions);
  return versions;
}

}  // namespace fgmesh::bindings
