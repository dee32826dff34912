// SPDX-License-Identifier: Apache-2.0
// Numbers by which frame fields on tet meshes are compared, whatever program computed them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/quaternion.hpp"
#include "crossgrain/report.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/stiffness.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Of a field with one frame per vertex; h are the unit degree-4 coefficients of the frames.
struct VertexFieldEvaluation {
  double dirichlet = 0;  ///< 1/2 integral of |grad h|^2, h linear in every tet; model units
  double edge_sum = 0;   ///< sum over edges of |h_i - h_j|^2
  SolveReport::Onto::Singular singular;

  /// Between axis and area-weighted normal at the smooth boundary vertices: those with a spread below 15
  /// degrees (BoundaryVertexOptions::smooth_spread_deg).
  SolveReport::AngleSummary normal_deg;

  /// Between axis and each adjoining face's normal at all other boundary vertices.
  SolveReport::AngleSummary crease_deg;
};

/// Of a field with one frame per tet.
struct CellFieldEvaluation {
  double dirichlet = 0;  ///< 1/2 sum over inner faces of (area / distance of centroids) |h_i - h_j|^2
  SolveReport::AngleSummary normal_deg;  ///< between axis and normal, over boundary faces
};

/// A face is singular where the matchings around its three vertices compose to more than the identity.
/// `boundary` and `edges` are those of `solid`, frames one per vertex. Angles are arc cosines in double
/// precision: below 2e-6 degrees they are rounding. The same to the bit for any number of threads.
VertexFieldEvaluation evaluate_vertex_field(const TetSolid& solid, const BoundaryVertices& boundary,
                                            std::span<const StiffnessEdge> edges,
                                            std::span<const Quaternion> frames);

/// Between the directions of edges, as pairs of vertices, and the nearest axis at both of their ends; none
/// where there are no edges.
std::optional<SolveReport::AngleSummary> angles_along(const TetSolid& solid,
                                                      std::span<const std::array<std::uint32_t, 2>> edges,
                                                      std::span<const Quaternion> frames);

/// Frames one per tet of `solid`. Faces of tets that are left out do not count.
CellFieldEvaluation evaluate_cell_field(const TetSolid& solid, std::span<const Quaternion> frames);

}  // namespace crossgrain
