// SPDX-License-Identifier: Apache-2.0
#include "io/result/report_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/version.hpp"
#include "files/input_file.hpp"
#include "io/json/json_file.hpp"
#include "io/result/json_members.hpp"
#include "io/result/report_members.hpp"

namespace crossgrain {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string report_json(const SolveReport& report) {
  return json_text(json_of(report));
}

Json json_of(const SolveReport& report) {
  Json json;
  json["schema"] = kReportSchema;
  JsonWriter writer(json);
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
      fmt::format("{} numbers of the report are not finite and are null in report.json, the first is {}",
                  places.size(), places.front()),
      Remedy::kReportModel);
}

std::string check_json(const SolveReport& report) {
  Json json;
  JsonWriter writer(json);
  describe_answer(writer, report.answer);
  describe_singularity(writer, "grid", report.singularity);
  if (report.onto) describe_singularity(writer, "tets", report.onto->singularity);
  writer.optional_object("coarser", report.coarser,
                         [](auto& inner, auto& coarser) { describe_coarser(inner, coarser); });
  return json_text(json);
}

SolveReport read_report(const std::filesystem::path& path) {
  const InputFile file(path);
  const Json json = Json::parse(file.bytes(), nullptr, false);
  if (json.is_discarded()) fail_input(file, {}, "is not JSON", Remedy::kCopyOrSolveAgain);
  JsonReader reader(json, file);
  int schema = 0;
  reader.member("schema", schema);
  if (schema != kReportSchema)
    fail_input(file, {}, fmt::format("has schema {} and this program reads {}", schema, kReportSchema),
               Remedy::kSolveAgain);
  SolveReport report;
  describe_results(reader, report);
  describe_doubts(reader, report);
  return report;
}

}  // namespace crossgrain
