// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/names.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/message.hpp"

namespace crossgrain {

const char* name_of(HexOutcome outcome) {
  constexpr std::array kNames{"all-hex", "flawed", "partial", "none"};
  return name_among<HexOutcome::kNone>(kNames, outcome);
}

std::string sentence_of(const HexReport& report) {
  return sentence_of(report, report.remedy);
}

std::string sentence_of(const HexReport& report, const std::string& remedy) {
  std::string text = name_of(report.outcome);
  if (report.hexahedra > 0) {
    const Vector3& at = report.quality.worst_place;
    const std::string bodies =
        report.bodies > 1 ? fmt::format(" in {}", counted(report.bodies, "body", "bodies")) : "";
    text = fmt::format("{}, {}{}, worst scaled Jacobian {:.2f} at {:.4g} {:.4g} {:.4g}, {:.2f} in the mean",
                       text, counted(report.hexahedra, "hexahedron", "hexahedra"), bodies,
                       report.quality.least, at[0], at[1], at[2], report.quality.mean);
  }
  if (report.is_coarse)
    text += fmt::format(", though about {:.0f} of size {:.3g} would fill the model",
                        report.model_volume / std::pow(report.size, 3), report.size);
  return report.reason.empty() ? text : fmt::format("{}: {}; try {}", text, report.reason, remedy);
}

}  // namespace crossgrain
