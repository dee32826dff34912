// SPDX-License-Identifier: Apache-2.0
#include "text/json_file.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace crossgrain {
namespace {

void find_not_finite(const nlohmann::ordered_json& value, const std::string& place,
                     std::vector<std::string>& found) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) found.push_back(place);
  if (!value.is_structured()) return;
  for (const auto& [key, member] : value.items()) {
    const std::string step = value.is_array() ? "[" + key + "]" : (place.empty() ? "" : ".") + key;
    find_not_finite(member, place + step, found);
  }
}

}  // namespace

std::vector<std::string> numbers_not_finite(const nlohmann::ordered_json& value) {
  std::vector<std::string> found;
  find_not_finite(value, "", found);
  return found;
}

std::string json_text(const nlohmann::ordered_json& value) {
  constexpr int kIndent = 2;
  return value.dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace crossgrain
