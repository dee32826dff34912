// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "files/temporary_folder.hpp"

namespace crossgrain {

#ifdef CROSSGRAIN_CAD_FILES

/// A folder of CAD files, made once for all tests by tests/io/cad/make_cad_files.cpp.
inline const std::filesystem::path& cad_files() {
  static const TemporaryFolder folder;
  static const int status =
      std::system(fmt::format("'{}' '{}' > /dev/null", CROSSGRAIN_CAD_FILES, folder.path().string()).c_str());
  if (status != 0) throw std::runtime_error("the CAD files could not be made");
  return folder.path();
}

#endif

}  // namespace crossgrain
