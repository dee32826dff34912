// SPDX-License-Identifier: Apache-2.0
#include "surface/findings.hpp"

#include <algorithm>
#include <array>

#include "base/names.hpp"

namespace crossgrain {

const char* name_of(FindingKind kind) {
  constexpr std::array kNames{"triangle soup",
                              "holes",
                              "cracks",
                              "non-manifold edges",
                              "degenerate triangles",
                              "duplicated triangles",
                              "internal sheets",
                              "flipped facets",
                              "inside-out parts",
                              "one-sided sheets",
                              "open sheets",
                              "stray facets",
                              "self-intersections",
                              "overlapping components",
                              "touching components"};
  return name_among<FindingKind::kTouchingComponents>(kNames, kind);
}

const char* name_of(FindingOutcome outcome) {
  constexpr std::array kNames{"joined",           "hole_bridged", "filled",   "bridged",
                              "unchanged",        "left_out",     "followed", "reoriented",
                              "left_out_if_open", "all_inside",   "merged",   "united"};
  return name_among<FindingOutcome::kUnited>(kNames, outcome);
}

const char* words_of(FindingOutcome outcome) {
  constexpr std::array kWords{"joined where edges run along each other",
                              "bridged by the winding number; close them if the surface there matters",
                              "filled with triangles; close them if the surface there matters",
                              "bridged by the winding number",
                              "left as they are",
                              "left out",
                              "kept: frames follow them",
                              "reoriented",
                              "left out where they bound nothing",
                              "left as they are: all that they enclose is inside",
                              "merged into the surface around all that they enclose",
                              "taken as one inside; frames follow their surfaces there too"};
  return name_among<FindingOutcome::kUnited>(kWords, outcome);
}

const Finding* find(const SurfaceFindings& findings, FindingKind kind) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

}  // namespace crossgrain
