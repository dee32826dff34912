// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// A curve bends at a corner where its direction changes by more.
inline constexpr double kCornerDeg = 45;

/// Which sharp edges count as creases although they fade out: they form a path with an end in the smooth
/// surface, as coarse triangles do where a surface is strongly curved. Closed paths and those between corners
/// always count. The sweep in docs/notes/solver.md chose the values.
struct FadingCreases {
  /// A path counts if some edge of it has a larger angle between its normals.
  double sure_deg = 80;

  /// A path counts if it has at least this length, in radii of the curvature that a smooth surface with the
  /// same triangles would have. 0 counts every path.
  double least_radii = 80;
};

/// Which edges less sharp than a crease close its gaps: a curve that is sharp on most of its length is one.
/// The sweep in docs/notes/solver.md chose the values.
struct CreaseGaps {
  /// Edges of a gap have more than this share of the smallest angle of a crease; 1 closes no gap.
  double share = 0.9;

  /// The gaps of a curve are together at most this long, in lengths of its sharp edges.
  double longest = 1;

  /// A path has gaps closed if it has this length in radii, as FadingCreases::least_radii, or an edge above
  /// FadingCreases::sure_deg: edges along coarse holes and fillets are up to nine radii long.
  double least_radii = 10;
};

/// Which edges of a surface count as creases. Angles are in degrees, above 0 and at most 180.
struct CreaseAngles {
  /// Smallest angle between the normals beside a sharp edge; 180 makes no edge sharp. Ignored for meshes that
  /// bring their creases along (TriangleMesh::creases), such as those of CAD files.
  double least_deg = 35;

  FadingCreases fading = {};
  CreaseGaps gaps = {};
};

}  // namespace crossgrain
