// SPDX-License-Identifier: Apache-2.0
// Names of the files in a result folder; crossgrain/io.hpp has those that programs need.
#pragma once

#include "crossgrain/io.hpp"

namespace crossgrain {

inline constexpr const char* kSurfaceFile = "surface.vtu";
inline constexpr const char* kReportFile = "report.json";

inline constexpr const char* kTetFramesFile = "onto.frames";
inline constexpr const char* kTetGridFile = "onto.vtu";

}  // namespace crossgrain
