// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Name of the program that reads CAD files.
inline constexpr const char* kCadProgramName = "crossgrain_cad";

}  // namespace crossgrain
