// SPDX-License-Identifier: Apache-2.0
// Answers as crossgrain_cad writes them.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "cad_reading/cad_messages.hpp"
#include "process/answer_stream.hpp"
#include "process/helper_program.hpp"

namespace crossgrain {

/// What the program writes for an answer.
inline std::string written(const CadAnswer& answer) {
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* file = ::open_memstream(&bytes, &size);
  write_greeting(file, kCadProgramName);
  write_cad_answer(file, answer);
  std::fclose(file);
  const std::string copy(bytes, size);
  std::free(bytes);
  return copy;
}

inline CadAnswer some_answer() {
  CadAnswer answer;
  answer.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
  answer.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  answer.mesh.faces = {1, 2, 3, 4};
  answer.mesh.solids = {0, 0, 0, 0};
  answer.mesh.creases = {{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, 5}};
  answer.mesh.face_list = {{1, FaceKind::kPlane, 0.5, {1, 2, 3}}, {2, FaceKind::kTorus, 1.5, {4, 5, 6}, 2}};
  answer.mesh.exact_size = {1.5, 2.5};
  answer.mesh.exact_box = {{0, 0, 0}, {1, 1, 0.125}};
  answer.mesh.unit = "mm";
  answer.mesh.file_unit = "inch";
  answer.mesh.warnings = {{WarningKind::kUnknownUnit, "one"},
                          {WarningKind::kMissingFaces, {"", "face 3", "another", Remedy::kRepairFile}}};
  answer.solids = {"CASCADE Topology V1", {0}, {1, 2, 3, 4}, {1, 2, 3, 4, 5, 6}};
  return answer;
}

}  // namespace crossgrain
