// SPDX-License-Identifier: Apache-2.0
// The finish of a field on the vertices of a tet mesh: the sweep of the grid on the graph of linear elements,
// with the boundary held exactly.
#pragma once

#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"
#include "field/vertex_guides.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/stiffness.hpp"

namespace crossgrain {

struct TetFrames {
  std::vector<Quaternion> frames;  ///< unit, one per vertex
  bool settled = false;            ///< false: the sweeps ran out
};

/// Frames on the vertices of a tet mesh that lower the Dirichlet energy of the linear elements from `start`.
/// Smooth boundary vertices have an axis along their area-weighted normal, to rounding: they turn about it
/// only; where a tagged edge runs through them, they do not turn. Vertices of tagged edges inside have an
/// axis along these, and turn about it. Creases and corners follow the summed form of their faces, creases
/// their tangent too. Vertices inside follow their guides, which are ordered by vertex; those of `boundary`
/// must have none. The same to the bit for any number of threads. Throws Error(kLimit) for a graph beyond the
/// limits of Adjacency and greedy_colouring.
TetFrames finish_on_tets(const std::vector<StiffnessEdge>& edges, const BoundaryVertices& boundary,
                         std::vector<Quaternion> start, Degree degree, const OntoOptions& options,
                         const Monitor& monitor, const std::vector<VertexGuide>& guides = {});

/// The frame turned by the smallest angle that puts one of its axes along a unit vector.
Quaternion with_axis_along(const Quaternion& frame, const Vector3& direction);

}  // namespace crossgrain
