// SPDX-License-Identifier: Apache-2.0
// Conversion between SolveReport and report.json.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "crossgrain/report.hpp"

namespace crossgrain {

/// Increases if a key is removed or changes its meaning, not for new keys.
inline constexpr int kReportSchema = 4;

/// Returns the report as docs/report.md describes it, with schema number and version of this library.
nlohmann::ordered_json json_of(const SolveReport& report);

/// Adds a warning if numbers of the report are not finite; report.json has null for them.
void warn_of_numbers_not_finite(SolveReport& report);

/// Returns the text of report.json, which ends with a checksum of what comes before it.
std::string sealed_report_json(const SolveReport& report);

/// Returns SolveReport::files of a report.json of any schema; none if that is not as it was written.
std::vector<ResultInventory::File> files_of_report(const std::filesystem::path& path);

/// Returns the report in a report.json of schema kReportSchema. Unknown keys are ignored; null for a number
/// becomes NaN. Throws Error(kInput).
SolveReport read_report(const std::filesystem::path& path);

}  // namespace crossgrain
