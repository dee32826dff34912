// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// What can be wrong with a surface.
enum class FindingKind : int {
  kTriangleSoup,           ///< no two triangles share an edge; counts triangles
  kHole,                   ///< open edges that hang together and are no crack; length: around the largest
  kCrack,                  ///< open edges along others within a small gap; length: the widest gap
  kNonmanifoldEdge,        ///< edges of more than two triangles
  kDegenerateTriangle,     ///< triangles without area
  kDuplicatedTriangle,     ///< more triangles on the same three vertices
  kInternalSheet,          ///< triangles drawn from both sides, as between two parts that touch
  kFlippedFacet,           ///< triangles turned against the larger part of their patch
  kInsideOutPart,          ///< patches turned as a whole
  kOneSidedSheet,          ///< patches that cannot be oriented, such as a Moebius band
  kOpenSheet,              ///< patches that bound nothing
  kStrayFacet,             ///< triangles that bound nothing and hang on others, or lie there alone
  kSelfIntersection,       ///< pairs of triangles that cross, but for those of kOverlappingComponents
  kOverlappingComponents,  ///< pairs of closed parts that cross, or of which one lies inside the other
  kTouchingComponents      ///< pairs of closed parts that meet without crossing
};

/// What a solve does about what is wrong.
enum class FindingOutcome : int {
  kJoined,         ///< open edges that run along each other count as joined
  kHoleBridged,    ///< the winding number closes the surface, not necessarily as it was meant
  kBridged,        ///< the winding number closes the surface
  kUnchanged,      ///< nothing
  kLeftOut,        ///< they are not part of the surface that is solved
  kFollowed,       ///< they are kept and constrain frames
  kReoriented,     ///< triangles are turned round
  kLeftOutIfOpen,  ///< they are left out where they bound nothing
  kAllInside,      ///< nothing; all that they enclose is inside
  kUnited          ///< the parts are one solid; their surfaces inside it constrain frames
};

/// Returns the name in report.json, a plural in plain words: "holes".
const char* name_of(FindingKind kind);

/// Returns the text in report.json: "left out".
const char* name_of(FindingOutcome outcome);

}  // namespace crossgrain
