// SPDX-License-Identifier: Apache-2.0
#include "measure/input_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain {
namespace {

/// What stands behind the number of a finding, and what became of the things.
struct Wording {
  FindingKind kind;
  const char* detail;
  const char* done;
};

constexpr Wording kWordings[] = {
    {FindingKind::kTriangleSoup, " triangles, no two of which share an edge",
     "joined where edges run along each other"},
    {FindingKind::kHole, "", "bridged by the winding number; close them where the surface matters there"},
    {FindingKind::kCrack, " where open edges run along each other", "bridged by the winding number"},
    {FindingKind::kNonmanifoldEdge, " of more than two triangles", "left as they are"},
    {FindingKind::kDegenerateTriangle, " without area", "left out"},
    {FindingKind::kDuplicatedTriangle, " drawn again", "left out"},
    {FindingKind::kInternalSheet, " drawn from both sides, between parts that touch",
     "kept: frames follow them"},
    {FindingKind::kFlippedFacet, " turned against their neighbours", "turned round"},
    {FindingKind::kInsideOutPart, "", "turned round"},
    {FindingKind::kOneSidedSheet, ", such as a Moebius band", "left out where they bound nothing"},
    {FindingKind::kOpenSheet, " that bound nothing", "left out"},
    {FindingKind::kStrayFacet, " that bound nothing", "left out"},
    {FindingKind::kSelfIntersection, " of one triangle with another",
     "left as they are: all that is enclosed is inside"},
    {FindingKind::kOverlappingComponents, "",
     "taken as one solid; what lies inside it of their surfaces still guides frames"},
    {FindingKind::kTouchingComponents, "", "left as they are"},
};

/// Of a kind of this list.
const Wording& wording_of(const std::string& kind) {
  return *std::find_if(std::begin(kWordings), std::end(kWordings) - 1,
                       [&](const Wording& wording) { return kind == name_of(wording.kind); });
}

}  // namespace

SolveReport::Input input_report(const MendedSurface& mended, const SurfaceFindings& findings) {
  SolveReport::Input input;
  input.triangles_solved = mended.surface.size();
  input.closed = mended.closed;
  for (const Finding& finding : findings) {
    const std::string kind = name_of(finding.kind);
    input.findings.push_back(
        {kind, finding.count, finding.at_least, finding.place, finding.length, wording_of(kind).done});
  }
  return input;
}

std::string sentence_of(const SolveReport::Finding& finding) {
  const char* which = finding.count > 1 ? "the first at" : "at";
  std::string size;
  if (finding.length) {
    const bool is_hole = finding.kind == name_of(FindingKind::kHole);
    size = fmt::format("{}{:.3g} {}, ", finding.count > 1 ? "the largest " : "", *finding.length,
                       is_hole ? "around" : "across");
    which = "at";
  }
  const auto& [x, y, z] = finding.place;
  return fmt::format("{}: {}{}{}, {}{} {:.6g} {:.6g} {:.6g}; {}", finding.kind,
                     finding.at_least ? "at least " : "", finding.count, wording_of(finding.kind).detail,
                     size, which, x, y, z, finding.done);
}

}  // namespace crossgrain
