// SPDX-License-Identifier: Apache-2.0
// The finish of a field on the vertices of a tet mesh: the sweep of the grid on the graph of linear elements,
// with the boundary held exactly.
#pragma once

#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/stiffness.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

struct TetFinishOptions {
  /// Weight of the form of a crease or corner vertex, in units of the sum of its edge weights.
  double crease_weight = 100;

  /// Whether creases and corners are constrained at all, or only smooth boundary vertices.
  bool constrain_creases = true;

  /// Relaxation sweeps before, and the strength of the symmetrisation penalty at their end, as in
  /// SolverOptions.
  int relaxation_sweeps = 0;
  double symmetrisation = 0.5;

  /// Sweeps at most, and the fraction of the energy by which a sweep must lower it for another to follow.
  int most_sweeps = 60;
  double sweep_tolerance = 1e-5;
};

/// Frames on the vertices of `solid.mesh` (unit quaternions, one a vertex) that lower the Dirichlet energy of
/// the linear elements from `start`. Smooth boundary vertices have an axis along their area-weighted normal,
/// to rounding: they turn about it only. Creases and corners follow the summed form of their faces, creases
/// their tangent too. The same to the bit for any number of threads.
std::vector<Quaternion> finish_on_tets(const TetSolid& solid, const std::vector<StiffnessEdge>& edges,
                                       const BoundaryVertices& boundary, const std::vector<Quaternion>& start,
                                       Degree degree, const TetFinishOptions& options,
                                       const Monitor& monitor);

/// The frame turned by the smallest angle that puts one of its axes along a unit vector.
Quaternion with_axis_along(const Quaternion& frame, const Vector3& direction);

}  // namespace crossgrain
