// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// What can be wrong with a surface.
enum class FindingKind : int {
  kTriangleSoup,           ///< no two triangles share an edge; counts triangles
  kHole,                   ///< connected open edges that are not a crack; length: around the largest
  kCrack,                  ///< open edges along others across a small gap; length: the widest gap
  kNonmanifoldEdge,        ///< edges of more than two triangles
  kDegenerateTriangle,     ///< triangles without area
  kDuplicatedTriangle,     ///< more triangles on the same three vertices
  kInternalSheet,          ///< pairs of triangles in opposite orientations, as between two parts that touch
  kFlippedFacet,           ///< triangles oriented against the larger part of their patch
  kInsideOutPart,          ///< patches with reversed orientation
  kOneSidedSheet,          ///< patches that cannot be oriented, such as a Moebius band
  kOpenSheet,              ///< patches that bound nothing
  kStrayFacet,             ///< triangles that bound nothing, attached to others or alone
  kSelfIntersection,       ///< pairs of triangles that cross, except those of kOverlappingComponents
  kOverlappingComponents,  ///< pairs of closed parts that cross, or of which one lies inside the other
  kTouchingComponents      ///< pairs of closed parts that meet without crossing
};

/// What a solve does about a finding.
enum class FindingOutcome : int {
  kJoined,         ///< open edges that run along each other count as joined
  kHoleBridged,    ///< the winding number closes the surface, not necessarily as intended
  kFilled,         ///< triangles close the surface, not necessarily as intended
  kBridged,        ///< the winding number closes the surface
  kUnchanged,      ///< nothing
  kLeftOut,        ///< they are not part of the surface that is solved
  kFollowed,       ///< they are kept and constrain frames
  kReoriented,     ///< they are reoriented
  kLeftOutIfOpen,  ///< they are left out where they bound nothing
  kAllInside,      ///< nothing; all that they enclose is inside
  kMerged,         ///< parts are made one: their surfaces inside each other are left out
  kUnited          ///< the parts are one solid; their surfaces inside it constrain frames
};

/// Returns the name in report.json, a plural in plain words: "holes".
const char* name_of(FindingKind kind);

/// Returns the name in report.json: "left_out_if_open".
const char* name_of(FindingOutcome outcome);

/// Returns the outcome in words: "left out where they bound nothing". Names do not change with the words.
const char* words_of(FindingOutcome outcome);

/// @}

}  // namespace crossgrain
