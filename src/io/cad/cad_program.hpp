// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace crossgrain {

/// Of the program that reads CAD files.
inline constexpr const char* kCadProgramName = "crossgrain_cad";

/// Where that program is: in the nearest folder libexec/crossgrain (CROSSGRAIN_HELPER_FOLDER) beside or above
/// this library, as a shared one, or the program that it is part of; otherwise in a folder that the linker of
/// that program has noted down for libraries (its run path), among which the CMake package of a static
/// library puts it. Empty where it is nowhere.
std::filesystem::path find_cad_program();

}  // namespace crossgrain
