// SPDX-License-Identifier: Apache-2.0
#include "version_text.hpp"

#include <fmt/format.h>

#include "crossgrain/features.hpp"
#include "crossgrain/version.hpp"

namespace crossgrain::app {

namespace {

std::string tets_text() {
  std::string programs;
  for (const std::string& program : {gmsh_program().string(), netgen_program().string()})
    if (!program.empty()) programs += (programs.empty() ? "made by " : " and ") + program;
  return programs.empty() ? "read only; gmsh and crossgrain_netgen, which make them, are missing" : programs;
}

}  // namespace

std::string version_text(Program program) {
  const bool has_mpi = program == Program::kProcesses;
  const std::string cad = cad_program().string();
  return fmt::format(
      "{} {}\n"
      "harmonics          of degree 3 or 4\n"
      "CAD files          {}\n"
      "tets               {}\n"
      "pages, pictures    yes\n"
      "several processes  {}\n"
      "vectors            {} doubles ({})\n"
      "threads            {}",
      has_mpi ? "crossgrain-mpi" : "crossgrain", kVersion,
      cad.empty() ? "no; the program crossgrain_cad is missing" : "yes, by " + cad, tets_text(),
      has_mpi ? "yes, through MPI" : "no; crossgrain-mpi does that", vector_doubles(), instruction_set(),
      thread_library());
}

}  // namespace crossgrain::app
