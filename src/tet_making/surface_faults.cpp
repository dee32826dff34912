// SPDX-License-Identifier: Apache-2.0
#include "tet_making/surface_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "measure/input_report.hpp"
#include "surface/self_intersections.hpp"

namespace crossgrain {
namespace {

/// Longer lists of places do not help to find them.
constexpr std::size_t kMostPlaces = 5;

/// Returns "2 holes: of 4 edges around 0 0 1 and of 3 edges around 5 0 1", the longest first.
std::string holes_in_words(std::vector<OpenLoop> loops) {
  std::erase_if(loops, [](const OpenLoop& loop) { return !loop.is_hole(); });
  if (loops.empty()) return "";
  std::stable_sort(loops.begin(), loops.end(),
                   [](const OpenLoop& a, const OpenLoop& b) { return a.length > b.length; });
  std::string text = counted(loops.size(), "hole") + ":";
  for (std::size_t k = 0; k < std::min(loops.size(), kMostPlaces); ++k)
    text += fmt::format("{} {} around {}", k == 0 ? "" : ",", counted(loops[k].edges, "edge"),
                        words_of_place(loops[k].middle));
  if (loops.size() > kMostPlaces) text += fmt::format(", and {} smaller", loops.size() - kMostPlaces);
  return text;
}

[[noreturn]] void refuse(const std::string& text, Remedy remedy) {
  throw Error(ErrorKind::kInput, text, remedy);
}

void refuse_open(const MendedSurface& mended) {
  const std::string holes = holes_in_words(mended.open_loops);
  if (!holes.empty()) refuse("the surface is not closed, it has " + holes, Remedy::kCloseHoles);
  const Finding* crack = find(mended.findings, FindingKind::kCrack);
  if (crack != nullptr)
    refuse(fmt::format("the surface is not closed, it has {} along cracks, the widest {:.3g} across at {}",
                       counted(crack->count, "open edge"), crack->length.value_or(0),
                       words_of_place(crack->place)),
           Remedy::kCloseHoles);
  const Finding* edges = find(mended.findings, FindingKind::kNonmanifoldEdge);
  refuse(fmt::format("the surface is not closed{}",
                     edges == nullptr
                         ? std::string()
                         : fmt::format(": {} of more than two triangles, the first at {}",
                                       counted(edges->count, "edge"), words_of_place(edges->place))),
         Remedy::kCloseSurface);
}

constexpr std::array kCrossings{FindingKind::kSelfIntersection, FindingKind::kOverlappingComponents};

void refuse_if_crossing(const SurfaceFindings& findings) {
  for (const FindingKind kind : kCrossings) {
    const Finding* finding = find(findings, kind);
    if (finding == nullptr) continue;
    const bool is_within = kind == FindingKind::kSelfIntersection;
    refuse(fmt::format("{}: {}{}, the first at {}",
                       is_within ? "the surface cuts through itself" : "closed parts of the surface overlap",
                       finding->at_least ? "at least " : "", counted(finding->count, "pair"),
                       words_of_place(finding->place)),
           Remedy::kUniteParts);
  }
}

}  // namespace

SurfaceFindings all_findings(const SearchableSurface& surface) {
  SurfaceFindings findings = surface.mended().findings;
  find_self_intersections(surface.mended(), surface.bvh(), surface.winding(), findings);
  return findings;
}

bool has_crossings(const SurfaceFindings& findings) {
  constexpr std::array kKinds{FindingKind::kSelfIntersection, FindingKind::kOverlappingComponents,
                              FindingKind::kTouchingComponents};
  return std::ranges::any_of(kKinds, [&](FindingKind kind) { return find(findings, kind) != nullptr; });
}

bool may_be_united(const SurfaceFindings& findings) {
  return has_crossings(findings) || find(findings, FindingKind::kNonmanifoldEdge) != nullptr;
}

void check_closed(const MendedSurface& mended) {
  if (!mended.closed) refuse_open(mended);
}

void check_bounds_solid(const SearchableSurface& surface) {
  check_closed(surface.mended());
  refuse_if_crossing(all_findings(surface));
}

std::vector<Warning> warnings_of_faults(const MendedSurface& mended, const SurfaceFindings& findings) {
  std::vector<Warning> warnings;
  for (SolveReport::Finding finding : input_report(mended, findings).findings) {
    // What they separate is cut into tets as one solid.
    if (finding.kind == FindingKind::kInternalSheet) finding.done = FindingOutcome::kLeftOut;
    if (finding.kind == FindingKind::kHole || finding.kind == FindingKind::kCrack)
      finding.done = FindingOutcome::kFilled;
    const bool is_united = std::ranges::count(kCrossings, finding.kind) > 0;
    if (is_united || finding.kind == FindingKind::kTouchingComponents) finding.done = FindingOutcome::kMerged;
    warnings.emplace_back(WarningKind::kSurfaceFinding,
                          sentence_of(finding, longest_side(mended.surface.box)));
  }
  return warnings;
}

}  // namespace crossgrain
