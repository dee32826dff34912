// SPDX-License-Identifier: Apache-2.0
// report.json, to and from SolveReport.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "crossgrain/report.hpp"

namespace crossgrain {

/// Counts up when a key is removed or changes its meaning; new keys leave it as it is.
inline constexpr int kReportSchema = 4;

/// The report as docs/report.md describes it, with the schema number and the version of this library.
nlohmann::ordered_json json_of(const SolveReport& report);

/// Adds a warning on the numbers of the report that are not finite, where there are any: report.json has null
/// for them.
void warn_of_numbers_not_finite(SolveReport& report);

/// A report.json of schema kReportSchema; keys that are not known are passed over, and null is NaN where
/// a number should stand. Throws Error(kInput).
SolveReport read_report(const std::filesystem::path& path);

}  // namespace crossgrain
