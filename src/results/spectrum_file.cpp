// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "crossgrain/writing.hpp"
#include "text/json_file.hpp"

namespace crossgrain {

std::string spectrum_json(const SpectrumReport& report) {
  nlohmann::ordered_json json;
  json["degree"] = report.degree;
  json["matrix"] = report.matrix;
  json["eigenvalues"] = report.eigenvalues;
  json["null_space"] = report.null_space;
  json["linear"] = report.linear;
  json["constant"] = report.constant;
  return json_text(json);
}

}  // namespace crossgrain
