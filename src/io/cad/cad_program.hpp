// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace crossgrain {

/// Name of the program that reads CAD files.
inline constexpr const char* kCadProgramName = "crossgrain_cad";

/// Returns the path of that program; empty if it is not found. Searches the nearest folder libexec/crossgrain
/// (CROSSGRAIN_HELPER_FOLDER) beside or above this shared library or the program that contains this code;
/// then the run path of that program, where the CMake package of a static library puts it.
std::filesystem::path find_cad_program();

}  // namespace crossgrain
