// SPDX-License-Identifier: Apache-2.0
#include "picture/answer_marks.hpp"

#include <fmt/format.h>

#include "crossgrain/message.hpp"
#include "picture/mark_shapes.hpp"
#include "picture/singular_lines.hpp"

namespace crossgrain {
namespace {

/// Calls `act(look, name, places)` for each kind of mark: knife edges and corners, impossible and undecided.
template <class Act>
void for_each_kind(const SolveReport& report, const Act& act) {
  const SolveReport::Singularity& judged = report.onto ? report.onto->singularity : report.singularity;
  const auto places_of = [](const auto& parts, Verdict verdict) {
    std::vector<Vector3> places;
    for (const auto& part : parts)
      if (part.verdict == verdict) places.push_back(part.place);
    return places;
  };
  for (const FaultLook& look : kFaultLooks) {
    act(look, "crease", places_of(judged.crease_list, look.verdict));
    act(look, "corner", places_of(judged.corner_list, look.verdict));
  }
}

}  // namespace

void answer_marks(const SolveReport& report, double radius, std::vector<Facet>& facets) {
  constexpr double kSide = 1.7;  // of a cube about as large as a ball of radius 1
  for_each_kind(report, [&](const FaultLook& look, const char*, const std::vector<Vector3>& places) {
    for (const Vector3& place : places) add_cube(place, kSide * look.size * radius, look.colour, facets);
  });
}

LegendBlock answer_legend(const SolveReport& report, bool has_marks) {
  LegendBlock block{fmt::format("Answer: {}", words_of(report.answer.verdict))};
  const std::vector<Answer::Reason>& reasons = report.answer.reasons;
  if (!reasons.empty()) block.notes.push_back(reasons.front().text);
  if (reasons.size() > 1)
    block.notes.push_back(fmt::format("and {}", counted(reasons.size() - 1, "other reason")));
  if (!has_marks) return block;
  for_each_kind(report, [&](const FaultLook& look, const char* name, const std::vector<Vector3>& places) {
    if (!places.empty())
      block.signs.push_back(
          {Sign::Shape::kCube, look.colour, fmt::format("{}, {} ({})", name, look.words, places.size())});
  });
  return block;
}

}  // namespace crossgrain
