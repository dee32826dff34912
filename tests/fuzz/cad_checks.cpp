// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/cad_checks.hpp"

#include "cad_reading/cad_messages.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"
#include "process/answer_stream.hpp"
#include "tet_making/netgen_messages.hpp"

namespace crossgrain {
namespace {

void require_line(std::string_view text) {
  require(text.size() <= kMostTextBytes, "a text of " + std::to_string(text.size()) + " bytes");
  require(std::ranges::none_of(text, [](unsigned char c) { return c < ' ' || c == 0x7f; }),
          "a text with control characters");
}

}  // namespace

bool check_cad(std::string_view bytes) {
  const auto path = as_file("input.cad", bytes);
  bool passed = false;
  for (auto* check : {check_step_file, check_iges_file, check_brep_file})
    passed |= succeeds([&] { check(InputFile(path)); });
  return passed;
}

bool check_cad_answer(std::string_view bytes) {
  const std::optional<CadAnswer> answer = cad_answer_in(bytes);
  if (!answer) return false;
  const TriangleMesh& mesh = answer->mesh;
  require_triangles(mesh);
  for (const auto& normals : mesh.corner_normals) require_finite({normals.begin(), normals.end()});
  for (const CreaseCurve& crease : mesh.creases) {
    require(crease.points.size() == crease.tangents.size(), "not a tangent for each point");
    require_finite(crease.points);
    require_finite(crease.tangents);
  }
  for (const ModelFace& face : mesh.face_list) {
    require(face.area >= 0 && name_of(face.kind)[0] != '\0', "a face without an area or a kind");
    require_finite({face.centre});
  }
  for (const std::string& text : {answer->fault.text, mesh.unit, mesh.file_unit}) require_line(text);
  require(mesh.warnings.size() <= kMostCadWarnings, "too many warnings");
  for (const Warning& warning : mesh.warnings) {
    require_line(warning.text);
    require(name_of(warning.kind) != nullptr, "an unknown warning");
  }
  return true;
}

bool check_netgen_answer(std::string_view bytes) {
  const std::optional<NetgenAnswer> answer = netgen_answer_in(bytes);
  if (!answer) return false;
  require_line(answer->fault);
  if (!answer->mesh.tets.empty()) require_tets(answer->mesh);
  return true;
}

}  // namespace crossgrain
