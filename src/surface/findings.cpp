// SPDX-License-Identifier: Apache-2.0
#include "surface/findings.hpp"

#include <algorithm>

namespace crossgrain {

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::kTriangleSoup:
      return "triangle soup";
    case FindingKind::kHole:
      return "holes";
    case FindingKind::kCrack:
      return "cracks";
    case FindingKind::kNonmanifoldEdge:
      return "non-manifold edges";
    case FindingKind::kDegenerateTriangle:
      return "degenerate triangles";
    case FindingKind::kDuplicatedTriangle:
      return "duplicated triangles";
    case FindingKind::kInternalSheet:
      return "internal sheets";
    case FindingKind::kFlippedFacet:
      return "flipped facets";
    case FindingKind::kInsideOutPart:
      return "inside-out parts";
    case FindingKind::kOneSidedSheet:
      return "one-sided sheets";
    case FindingKind::kOpenSheet:
      return "open sheets";
    case FindingKind::kStrayFacet:
      return "stray facets";
    case FindingKind::kSelfIntersection:
      return "self-intersections";
    case FindingKind::kOverlappingComponents:
      return "overlapping components";
    case FindingKind::kTouchingComponents:
      return "touching components";
  }
  return "";
}

const Finding* find(const SurfaceFindings& findings, FindingKind kind) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

}  // namespace crossgrain
