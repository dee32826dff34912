// SPDX-License-Identifier: Apache-2.0
// Compiled into both the library and the program crossgrain_cad.
//
// Layout of an answer (process/answer_stream.hpp): a CadEnd; the fault; the vectors of the mesh and of the
// solids in the order of `exchange_cad`.
#include "cad_reading/cad_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "process/answer_stream.hpp"
#include "process/helper_program.hpp"

namespace crossgrain {
namespace {

/// Bytes of a face; of a crease and of a warning without points and text: numbers of items, tag, kind and
/// remedy.
constexpr std::size_t kFaceBytes = sizeof(ModelFace::number) + sizeof(ModelFace::kind) +
                                   sizeof(ModelFace::area) + sizeof(ModelFace::centre) +
                                   sizeof(ModelFace::solids);
constexpr std::size_t kCountBytes = sizeof(std::uint64_t);
constexpr std::size_t kLeastCreaseBytes = 2 * kCountBytes + sizeof(CreaseCurve::tag);
constexpr std::size_t kLeastWarningBytes = 3 * kCountBytes + sizeof(WarningKind) + sizeof(Remedy);

/// Defines the contents of an answer and their order, for reading and writing.
template <class Stream, class Answer>
void exchange_cad(Stream& stream, Answer& answer) {
  stream.value(answer.end);
  stream.items(answer.fault.text);
  stream.value(answer.fault.remedy);
  auto& mesh = answer.mesh;
  stream.items(mesh.vertices);
  stream.items(mesh.triangles);
  stream.items(mesh.faces);
  stream.items(mesh.solids);
  stream.items(mesh.corner_normals);
  stream.list(mesh.creases, kLeastCreaseBytes, [&stream](auto& crease) {
    stream.items(crease.points);
    stream.items(crease.tangents);
    stream.value(crease.tag);
  });
  stream.list(mesh.face_list, kFaceBytes, [&stream](auto& face) {
    stream.value(face.number);
    stream.value(face.kind);
    stream.value(face.area);
    stream.value(face.centre);
    stream.value(face.solids);
  });
  stream.value(mesh.exact_size);
  stream.value(mesh.exact_box);
  stream.items(mesh.unit);
  stream.items(mesh.file_unit);
  stream.list(mesh.warnings, kLeastWarningBytes, [&stream](auto& warning) {
    stream.value(warning.kind);
    stream.items(warning.file);
    stream.items(warning.place);
    stream.items(warning.text);
    stream.value(warning.remedy);
  });
  stream.items(answer.solids.brep);
  stream.items(answer.solids.solid_numbers);
  stream.items(answer.solids.face_numbers);
  stream.items(answer.solids.edge_numbers);
}

bool is_known(Remedy remedy) {
  return remedy >= Remedy::kNone && remedy <= Remedy::kReportModel;
}

bool is_sound(const Warning& warning) {
  return warning.kind >= WarningKind{} && warning.kind <= WarningKind::kNotFinite &&
         is_known(warning.remedy) && is_line(warning.file) && is_line(warning.place) && is_line(warning.text);
}

bool is_sound(const CreaseCurve& crease) {
  return crease.points.size() == crease.tangents.size() && are_finite(crease.points) &&
         are_finite(crease.tangents);
}

bool is_size(double value) {
  return std::isfinite(value) && value >= 0;
}

bool is_sound(const ModelFace& face) {
  return face.kind >= FaceKind{} && face.kind <= FaceKind::kOther && is_size(face.area) &&
         are_finite(std::span(&face.centre, 1));
}

bool is_sound(const Box& box) {
  return are_finite(std::array{box.low, box.high}) && box.low <= box.high;
}

bool are_numbers(const std::vector<std::int32_t>& items) {
  return std::all_of(items.begin(), items.end(), [](std::int32_t item) { return item >= 0; });
}

/// Returns whether a mesh is consistent with the documentation of TriangleMesh.
bool is_consistent(const TriangleMesh& mesh) {
  const std::size_t triangles = mesh.triangles.size();
  const auto belongs = [triangles](const auto& items) { return items.empty() || items.size() == triangles; };
  return belongs(mesh.faces) && belongs(mesh.solids) && belongs(mesh.corner_normals) &&
         are_numbers(mesh.faces) && are_numbers(mesh.solids) && are_finite(mesh.vertices) &&
         std::all_of(mesh.corner_normals.begin(), mesh.corner_normals.end(), are_finite) &&
         std::all_of(mesh.creases.begin(), mesh.creases.end(),
                     [](const CreaseCurve& crease) { return is_sound(crease); }) &&
         std::all_of(mesh.face_list.begin(), mesh.face_list.end(),
                     [](const ModelFace& face) { return is_sound(face); }) &&
         is_size(mesh.exact_size.volume) && is_size(mesh.exact_size.area) && is_sound(mesh.exact_box) &&
         is_line(mesh.unit) && is_line(mesh.file_unit) && mesh.warnings.size() <= kMostCadWarnings &&
         std::all_of(mesh.warnings.begin(), mesh.warnings.end(),
                     [](const Warning& warning) { return is_sound(warning); }) &&
         are_in_range(mesh.triangles, mesh.vertices.size());
}

bool is_consistent(const CadSolids& solids) {
  return are_numbers(solids.solid_numbers) && are_numbers(solids.face_numbers) &&
         are_numbers(solids.edge_numbers);
}

}  // namespace

std::vector<std::string> arguments_of(const CadRequest& request) {
  const CadReading& options = request.options;
  // fmt writes the shortest text that restores the same double.
  return {kVersion,
          fmt::to_string(request.asking_process),
          fmt::to_string(static_cast<int>(request.format)),
          fmt::to_string(options.resolution),
          fmt::format("{}", options.cell_size),
          fmt::format("{}", options.facet_angle_deg),
          fmt::format("{}", options.crease_angle_deg),
          fmt::to_string(static_cast<int>(options.glue)),
          fmt::format("{}", options.glue_gap),
          fmt::to_string(options.max_memory_bytes),
          fmt::to_string(static_cast<int>(request.with_solids)),
          request.path};
}

std::optional<CadRequest> cad_request_of(const std::vector<std::string>& arguments) {
  constexpr std::size_t kCount = 12;
  if (arguments.size() != kCount || arguments[0] != kVersion) return std::nullopt;
  CadRequest request;
  CadReading& options = request.options;
  int format = 0, glue = 0, with_solids = 0;
  const bool sound =
      parse_number(arguments[1], request.asking_process) && parse_number(arguments[2], format) &&
      parse_number(arguments[3], options.resolution) && parse_number(arguments[4], options.cell_size) &&
      parse_number(arguments[5], options.facet_angle_deg) &&
      parse_number(arguments[6], options.crease_angle_deg) && parse_number(arguments[7], glue) &&
      parse_number(arguments[8], options.glue_gap) && parse_number(arguments[9], options.max_memory_bytes) &&
      parse_number(arguments[10], with_solids);
  if (!sound || format < 0 || format > static_cast<int>(CadFormat::kFreeCad)) return std::nullopt;
  request.format = static_cast<CadFormat>(format);
  options.glue = glue != 0;
  request.with_solids = with_solids != 0;
  request.path = arguments[11];
  return request;
}

bool write_cad_answer(std::FILE* out, const CadAnswer& answer) {
  AnswerWriter writer(out);
  exchange_cad(writer, answer);
  return writer.end();
}

std::optional<CadAnswer> cad_answer_in(std::string_view written) {
  const std::string greeting = greeting_of(kCadProgramName);
  if (!written.starts_with(greeting)) return std::nullopt;
  AnswerReader reader(written.substr(greeting.size()));
  CadAnswer answer;
  exchange_cad(reader, answer);
  if (!reader.ends_with(kAnswerTrailer) || answer.end > CadEnd::kOutOfMemory ||
      !is_known(answer.fault.remedy) || !is_line(answer.fault.text) || !is_consistent(answer.mesh) ||
      !is_consistent(answer.solids))
    return std::nullopt;
  return answer;
}

}  // namespace crossgrain
