// SPDX-License-Identifier: Apache-2.0
// Answers as crossgrain_netgen writes them.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "process/answer_stream.hpp"
#include "process/helper_program.hpp"
#include "tet_making/netgen_messages.hpp"

namespace crossgrain {

/// What the program writes for an answer.
inline std::string written(const NetgenAnswer& answer) {
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* file = ::open_memstream(&bytes, &size);
  write_greeting(file, kNetgenProgramName);
  write_netgen_answer(file, answer);
  std::fclose(file);
  const std::string copy(bytes, size);
  std::free(bytes);
  return copy;
}

inline NetgenAnswer some_netgen_answer() {
  NetgenAnswer answer;
  answer.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
  answer.mesh.tets = {{0, 1, 2, 3}};
  answer.mesh.regions = {1};
  answer.mesh.feature_faces = {{{0, 2, 1}, 3}};
  answer.mesh.feature_edges = {{{0, 1}, 5, false}};
  return answer;
}

}  // namespace crossgrain
