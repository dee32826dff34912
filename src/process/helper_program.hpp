// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace crossgrain {

/// Names of the programs of our own that the library runs: one reads CAD files, one makes tets with Netgen.
inline constexpr const char* kCadProgramName = "crossgrain_cad";
inline constexpr const char* kNetgenProgramName = "crossgrain_netgen";

/// Returns a program of our own; empty if it is not installed. Searches the nearest folder libexec/crossgrain
/// (CROSSGRAIN_HELPER_FOLDER) beside or above the shared library or the program that contains this code; then
/// the run path of that program, where the CMake package of a static library puts it.
std::filesystem::path helper_program(const std::string& name);

/// Returns a program of others by the environment variable PATH; empty if there is none.
std::filesystem::path program_in_path(const std::string& name);

}  // namespace crossgrain
