// SPDX-License-Identifier: Apache-2.0
// How many hexahedra a field leaves room for at the creases and corners of the surface.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "singularity/solid_creases.hpp"

namespace crossgrain {

/// Returns k, the number of hexahedra that frames make at an edge of the surface: the quarter turns of its
/// solid as they see it. `way` are the frames from beside its first face through the solid to beside its
/// second, right-handed about the unit vector `along`; `normals` those of the faces, outward; `angle_deg` the
/// angle of the solid between them. The axis nearest to the first normal is carried along the way by
/// matchings: k = 2 if it arrives as the axis of the second normal, 0 or 4 as its opposite, otherwise 1 or 3.
int quarter_turns(std::span<const Quaternion> way, const std::array<Vector3, 2>& normals,
                  const Vector3& along, double angle_deg);

/// What the frames say at places along a crease: k, weighted by length.
struct CreaseVote {
  int hexahedra;
  double length;
};

using VotesAlong = std::function<std::vector<CreaseVote>(const SolidCrease& crease)>;

struct SurfaceCells {
  std::function<double(std::uint32_t vertex)> size_at;  ///< model units

  /// Whether hexahedra are to follow each crease, as those of a tet mesh. On a grid a corner all of whose
  /// creases are shorter than a few cells is roughness that the cells do not see.
  bool see_all = false;
};

/// Adds to a summary of a graph what the field makes of the surface: creases with other than two hexahedra,
/// or where rounding decides, and the corners where such creases end.
///
/// k of a crease is its mean angle in quarter turns, rounded. Within 5 degrees of 45,
/// 135, 225 and 315 degrees frames decide, by length. A corner has F = 4 - sum (4 - n) - sum (2 - k)
/// hexahedra over its arcs of n and its creases of k, and needs a link with exactly these
/// (`has_surface_link`), for some of the arcs that end within a few cells: the others may end beside it.
void add_surface(const SolidSurface& surface, const SolidCreases& creases, const VotesAlong& votes_along,
                 const SurfaceCells& cells, const SingularityGraph& graph, SolveReport::Singularity& summary);

}  // namespace crossgrain
