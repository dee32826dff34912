// SPDX-License-Identifier: Apache-2.0
// Loops of edges, and which lie within others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {

/// An edge in a direction.
struct DirectedEdge {
  std::uint32_t from, to;
  std::uint32_t across = 0;  ///< triangle on the other side, where it matters
};

/// Joins edges, of which as many begin as end at every vertex, to loops that pass each vertex once.
std::vector<std::vector<DirectedEdge>> loops_of(std::vector<DirectedEdge> edges);

/// A closed loop of edges. Edge k goes from vertex k to the next one.
struct EdgeLoop {
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3> across;  ///< unit normal of the triangle beyond each edge; zero where there is none
};

struct JoinedLoop {
  EdgeLoop loop;
  std::vector<std::size_t> of;  ///< loops it is made of
};

/// Returns loops with those in their planes that lie within them, and go the other way round, joined to them
/// by edges there and back: the border of a face with holes in one loop. Each loop is in one of the results.
std::vector<JoinedLoop> joined_loops(const std::vector<EdgeLoop>& loops,
                                     const std::vector<Vector3>& vertices);

/// How far a loop may be off a plane to be in it, relative to the square root of its area.
inline constexpr double kInPlane = 1e-3;

}  // namespace crossgrain
