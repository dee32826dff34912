// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "crossgrain/reading.hpp"

namespace crossgrain {

/// ReadOptions of CAD files with what only tests set.
struct CadReading : ReadOptions {
  double glue_gap = 1e-6;  ///< largest gap between faces that are glued, relative to the longest side

  /// The program crossgrain_cad; if empty, that of `cad_program`.
  std::filesystem::path cad_program = {};
};

TriangleMesh read_surface(const std::filesystem::path& path, const CadReading& options,
                          const Monitor& monitor = {});

}  // namespace crossgrain
