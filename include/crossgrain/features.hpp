// SPDX-License-Identifier: Apache-2.0
// What this build of the library can do on this machine.
#pragma once

#include <filesystem>
#include <string>

namespace crossgrain {

/// Returns how many doubles the solver computes with at once: 2, 4 or 8. The environment variable
/// CROSSGRAIN_VECTOR_DOUBLES may make it fewer than the processor has.
int vector_doubles();

/// Returns the name of the instructions that do so: "AVX-512", "AVX2" or "SSE2"; "baseline" where the
/// processor is no x86.
std::string instruction_set();

/// Returns what runs parallel loops, such as "oneTBB 2021.8" or "std::thread".
std::string thread_library();

/// Returns the program that reads CAD files (STEP, IGES, BREP); empty if it is not installed, and then
/// reading them is an error. Component crossgrain::io.
std::filesystem::path cad_program();

/// Returns the programs that make tets (`make_tets`): gmsh, in PATH, and Crossgrain's own with Netgen inside;
/// empty if they are not installed. Component crossgrain::io.
std::filesystem::path gmsh_program();
std::filesystem::path netgen_program();

}  // namespace crossgrain
