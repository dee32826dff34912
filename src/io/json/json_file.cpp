// SPDX-License-Identifier: Apache-2.0
#include "io/json/json_file.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

void check_finite(const nlohmann::ordered_json& value, const std::string& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw Error(ErrorKind::kLimit,
                {"", path, "is not a finite number and cannot be reported", Remedy::kReportModel});
  if (!value.is_structured()) return;
  for (const auto& [key, member] : value.items()) check_finite(member, path + "/" + key);
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value) {
  check_finite(value, "");
  constexpr int kIndent = 2;
  return value.dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_json(OutputFile& file, const nlohmann::ordered_json& value) {
  file.write(json_text(value));
}

}  // namespace crossgrain
