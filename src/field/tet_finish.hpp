// SPDX-License-Identifier: Apache-2.0
// Final optimisation of a field on the vertices of a tet mesh: the sweeps of the grid on the graph of linear
// elements, with exact boundary constraints.
#pragma once

#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"
#include "field/solve_tuning.hpp"
#include "field/vertex_guides.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/stiffness.hpp"

namespace crossgrain {

/// Volume of a part and the longest side of its bounding box.
struct Extent {
  double volume = 0;
  double side = 1;
};

struct TetFrames {
  std::vector<Quaternion> frames;  ///< unit, one per vertex
  bool settled = false;            ///< false: the sweeps ran out
  int sweeps = 0;                  ///< relaxation and manifold sweeps
  std::size_t start = 0;           ///< number of the start that they come from
};

/// Returns frames on the vertices of a tet mesh that lower the Dirichlet energy of the linear elements,
/// from the one of `starts` that ends lowest (OntoTuning::race_margin); there is at least one. Smooth
/// boundary vertices have an axis along their area-weighted normal, to rounding, and rotate about it only;
/// with a tagged edge through them, they do not rotate. Vertices of tagged edges inside have an axis along
/// the edge and rotate about it. Creases and corners follow the summed form of their faces, creases also
/// their tangent. Vertices inside follow their guides, which must be ordered by vertex; those of `boundary`
/// must have none. `extent` is that of the tets. Bitwise identical for any number of threads. Throws
/// Error(kLimit) for a graph beyond the limits of Adjacency and greedy_colouring.
TetFrames finish_on_tets(const std::vector<StiffnessEdge>& edges, const BoundaryVertices& boundary,
                         std::vector<std::vector<Quaternion>> starts, Degree degree,
                         const TetFinishing& options, const Monitor& monitor,
                         const std::vector<VertexGuide>& guides = {}, const Extent& extent = {});

/// Returns the frame rotated by the smallest angle that puts one of its axes along a unit vector.
Quaternion with_axis_along(const Quaternion& frame, const Vector3& direction);

}  // namespace crossgrain
