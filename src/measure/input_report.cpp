// SPDX-License-Identifier: Apache-2.0
#include "measure/input_report.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstddef>
#include <iterator>

#include "crossgrain/place.hpp"

namespace crossgrain {
namespace {

/// The text after the number of a finding, and what is done about it.
struct Treatment {
  FindingKind kind;
  const char* detail;
  FindingOutcome done;
};

constexpr Treatment kTreatments[] = {
    {FindingKind::kTriangleSoup, " triangles, no two of which share an edge", FindingOutcome::kJoined},
    {FindingKind::kHole, "", FindingOutcome::kHoleBridged},
    {FindingKind::kCrack, " where open edges run along each other", FindingOutcome::kBridged},
    {FindingKind::kNonmanifoldEdge, " of more than two triangles", FindingOutcome::kUnchanged},
    {FindingKind::kDegenerateTriangle, " without area", FindingOutcome::kLeftOut},
    {FindingKind::kDuplicatedTriangle, " repeated", FindingOutcome::kLeftOut},
    {FindingKind::kInternalSheet, " present in both orientations, between parts that touch",
     FindingOutcome::kFollowed},
    {FindingKind::kFlippedFacet, " oriented against neighbours", FindingOutcome::kReoriented},
    {FindingKind::kInsideOutPart, "", FindingOutcome::kReoriented},
    {FindingKind::kOneSidedSheet, ", such as a Moebius band", FindingOutcome::kLeftOutIfOpen},
    {FindingKind::kOpenSheet, ", bounding nothing", FindingOutcome::kLeftOut},
    {FindingKind::kStrayFacet, ", bounding nothing", FindingOutcome::kLeftOut},
    {FindingKind::kSelfIntersection, " of one triangle with another", FindingOutcome::kAllInside},
    {FindingKind::kOverlappingComponents, "", FindingOutcome::kUnited},
    {FindingKind::kTouchingComponents, "", FindingOutcome::kUnchanged},
};

constexpr bool has_all_in_order() {
  for (std::size_t k = 0; k < std::size(kTreatments); ++k)
    if (kTreatments[k].kind != static_cast<FindingKind>(k)) return false;
  return kTreatments[std::size(kTreatments) - 1].kind == FindingKind::kTouchingComponents;
}
static_assert(has_all_in_order());

const Treatment& treatment_of(FindingKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  assert(index < std::size(kTreatments));
  return kTreatments[index];
}

}  // namespace

SolveReport::Input input_report(const MendedSurface& mended, const SurfaceFindings& findings) {
  SolveReport::Input input;
  input.triangles_solved = mended.surface.size();
  input.closed = mended.closed;
  for (const Finding& finding : findings)
    input.findings.push_back({finding.kind, finding.count, finding.at_least, finding.place, finding.length,
                              treatment_of(finding.kind).done});
  return input;
}

std::string sentence_of(const SolveReport::Finding& finding) {
  return sentence_of(finding, 0);
}

std::string sentence_of(const SolveReport::Finding& finding, double size) {
  const char* which = finding.count > 1 ? "the first at" : "at";
  std::string length;
  if (finding.length) {
    const bool is_hole = finding.kind == FindingKind::kHole;
    length = fmt::format("{}{:.3g} {}, ", finding.count > 1 ? "the largest " : "", *finding.length,
                         is_hole ? "around" : "across");
    which = "at";
  }
  return fmt::format("{}: {}{}{}, {}{} {}; {}", name_of(finding.kind), finding.at_least ? "at least " : "",
                     finding.count, treatment_of(finding.kind).detail, length, which,
                     words_of_place(finding.place, size), words_of(finding.done));
}

}  // namespace crossgrain
