// SPDX-License-Identifier: Apache-2.0
// Numbers for comparing frame fields on tet meshes, whatever program computed them.
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

/// Evaluation of a field with one frame per vertex; h are the unit degree-4 coefficients of the frames.
struct VertexFieldEvaluation {
  double dirichlet = 0;  ///< 1/2 integral of |grad h|^2, h linear in every tet; model units
  double edge_sum = 0;   ///< sum over edges of |h_i - h_j|^2
  SolveReport::Onto::Singular singular;

  /// Angle between axis and area-weighted normal at the smooth boundary vertices: those with a spread below
  /// 15 degrees (BoundaryVertexOptions::smooth_spread_deg).
  SolveReport::AngleSummary normal_deg;

  /// Angle between axis and the normal of each adjoining face at all other boundary vertices.
  SolveReport::AngleSummary crease_deg;
};

/// Evaluation of a field with one frame per tet.
struct CellFieldEvaluation {
  double dirichlet = 0;  ///< 1/2 sum over inner faces of (area / distance of centroids) |h_i - h_j|^2
  SolveReport::AngleSummary normal_deg;  ///< angle between axis and normal, over boundary faces
};

/// Evaluates a field with one frame per vertex. A face is singular if the product of the matchings around its
/// three vertices is not the identity. `boundary` and `edges` are those of `solid`. Angles are arc cosines in
/// double precision: below 2e-6 degrees they are rounding. Bitwise identical for any number of threads.
VertexFieldEvaluation evaluate_vertex_field(const TetSolid& solid, const BoundaryVertices& boundary,
                                            std::span<const StiffnessEdge> edges,
                                            std::span<const Quaternion> frames);

/// Angles between the directions of edges, as pairs of vertices, and the nearest axis at both of their ends;
/// none without edges.
std::optional<SolveReport::AngleSummary> angles_along(const TetSolid& solid,
                                                      std::span<const std::array<std::uint32_t, 2>> edges,
                                                      std::span<const Quaternion> frames);

/// Returns the share of the boundary's area where the normal is more than `limit_deg` off the nearest axis of
/// the frame of its tet. Faces of dropped tets are ignored.
double unfollowed_share(const TetSolid& solid, std::span<const Quaternion> frames, double limit_deg);

/// Evaluates a field with one frame per tet of `solid`. Faces of dropped tets are ignored.
CellFieldEvaluation evaluate_cell_field(const TetSolid& solid, std::span<const Quaternion> frames);

}  // namespace crossgrain
