// SPDX-License-Identifier: Apache-2.0
#include "results/report_file.hpp"

#include <fmt/format.h>

#include <cassert>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/version.hpp"
#include "crossgrain/writing.hpp"
#include "files/crc32.hpp"
#include "files/file_seal.hpp"
#include "files/input_file.hpp"
#include "files/read_memory.hpp"
#include "results/json_members.hpp"
#include "results/report_members.hpp"
#include "results/result_files.hpp"
#include "results/solve_id.hpp"
#include "text/json_file.hpp"

namespace crossgrain {
namespace {

using Json = nlohmann::ordered_json;

/// With its key it is kJsonMark.
constexpr const char* kProgram = "Crossgrain";

/// With its value it is kJsonSolve.
constexpr const char* kSolveKey = "solve";

/// Throws unless the places in lists of a report are in them; 0 may be that of an empty list.
void check_places_in_lists(const InputFile& file, const HexReport& report) {
  const auto check = [&](const char* name, std::size_t place, std::size_t size) {
    if (place > 0 && place >= size)
      fail_input(file, {}, fmt::format("'{}' is {} in a list of {}", name, place, size), Remedy::kSolveAgain);
  };
  check("best_attempt", report.best_attempt, report.attempts.size());
  check("best_fit", report.best_fit, report.fit_tries.size());
}

}  // namespace

bool is_without_field(const SolveReport& report) {
  return report.hexahedra && report.levels.empty() && !report.onto;
}

std::string report_json(const SolveReport& report) {
  return json_text(json_of(report));
}

Json json_of(const SolveReport& report) {
  Json json;
  json["schema"] = kReportSchema;
  json["program"] = kProgram;
  JsonWriter writer(json);
  writer.text(kSolveKey, report.solve);
  describe_results(writer, report);
  json["version"] = kVersion;
  describe_doubts(writer, report);
  return json;
}

void warn_of_numbers_not_finite(SolveReport& report) {
  const std::vector<std::string> places = numbers_not_finite(json_of(report));
  if (places.empty()) return;
  report.warnings.emplace_back(
      WarningKind::kNotFinite,
      fmt::format("{} of the report {} not finite and null in report.json, the first is {}",
                  counted(places.size(), "number"), is_or_are(places.size()), places.front()),
      Remedy::kReportModel);
}

std::string check_json(const SolveReport& report) {
  Json json;
  JsonWriter writer(json);
  if (report.hexahedra) {
    writer.member("hexahedra", report.hexahedra);
    writer.optional_list("faces", report.faces);
  }
  if (is_without_field(report)) {
    writer.member("warnings", report.warnings);
    return json_text(json);
  }
  describe(writer, report.answer);
  writer.member("grid", report.singularity);
  if (report.onto) writer.member("tets", report.onto->singularity);
  writer.member("coarser", report.coarser);
  return json_text(json);
}

std::string sealed_report_json(const SolveReport& report) {
  std::string text = report_json(report);
  constexpr std::string_view kEnd = "\n}\n";
  assert(text.ends_with(kEnd));
  text.resize(text.size() - kEnd.size());
  Crc32 crc;
  crc.add(text);
  return text + seal_text(SealForm::kJson, crc.value());
}

std::vector<ResultInventory::File> files_of_report(const std::filesystem::path& path) {
  ResultInventory report;
  if (!has_whole_seal(path)) return {};
  try {
    const InputFile file(path);
    const Json json = Json::parse(file.bytes(), nullptr, false);
    JsonReader(json, file).optional_list("files", report.files);
  } catch (const Error&) {
    report.files.clear();
  }
  return std::move(report.files);
}

std::optional<std::string> model_of_result(const std::filesystem::path& folder) {
  try {
    const InputFile file(folder / kReportFile);
    const Json json = Json::parse(file.bytes(), nullptr, false);
    SolveReport report;
    JsonReader(json, file).object("model", [&](auto& model) { model.member("path", report.model.path); });
    return report.model.path;
  } catch (const Error&) {
    return std::nullopt;
  }
}

SolveReport report_of_result(const std::filesystem::path& folder) {
  return read_report(folder / kReportFile);
}

SolveReport read_report(const std::filesystem::path& path) {
  const InputFile file(path);
  // A value of two characters takes this much in the worst case, while its array grows.
  constexpr double kMemoryOverFile = 32;
  require_read_memory(file.name(), kMemoryOverFile * static_cast<double>(file.bytes().size()));
  Checkpoint checkpoint;
  const auto watch = [&](int, Json::parse_event_t, Json&) { return checkpoint.pass(), true; };
  const Json json = Json::parse(file.bytes(), watch, false);
  if (json.is_discarded()) fail_input(file, {}, "is not JSON", Remedy::kCopyOrSolveAgain);
  JsonReader reader(json, file);
  int schema = 0;
  reader.member("schema", schema);
  if (schema != kReportSchema)
    fail_input(file, {}, fmt::format("has schema {} and this program reads {}", schema, kReportSchema),
               Remedy::kSolveAgain);
  SolveReport report;
  reader.text(kSolveKey, report.solve);
  if (!report.solve.empty() && !is_solve_id(report.solve))
    fail_input(file, {}, "names no solve", Remedy::kCopyOrSolveAgain);
  describe_results(reader, report);
  describe_doubts(reader, report);
  if (report.hexahedra) check_places_in_lists(file, *report.hexahedra);
  report.answer.is_meshed = report.hexahedra.has_value();
  return report;
}

}  // namespace crossgrain
