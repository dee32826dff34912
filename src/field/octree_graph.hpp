// SPDX-License-Identifier: Apache-2.0
// Converts a level of the octree into the solver's graph.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "field/field_graph.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Weight of the edge from a leaf through one of its faces to the leaf of the same size or larger behind it;
/// zero if they are not joined.
class FaceWeight {
 public:
  /// Weight in steps of a fully open face between two leaves of one size, chosen so that all possible weights
  /// are whole.
  static constexpr int kFullFace = 96;

  FaceWeight() = default;
  FaceWeight(int steps, bool to_larger)
      : packed_(static_cast<std::uint8_t>(steps | (steps > 0 && to_larger ? kToLarger : 0))) {}

  bool joined() const { return packed_ != 0; }
  bool joins_equal() const { return packed_ != 0 && !(packed_ & kToLarger); }
  bool joins_larger() const { return (packed_ & kToLarger) != 0; }

  /// Weight in units of the leaf's size over kFullFace.
  int steps() const { return packed_ & ~kToLarger; }

 private:
  static constexpr unsigned kToLarger = 128;

  std::uint8_t packed_ = 0;
};

/// Connections of the leaves of a level through their faces; field/leaf_stencil.hpp derives diagonals from
/// them.
struct LeafConnections {
  /// Weight per leaf and face. Two leaves of the same size both store the weight of their common face.
  std::vector<std::array<FaceWeight, kFaceCount>> weights;

  /// Bit f of open_faces[i]: there is an edge from leaf i to Octree::neighbour(i, f). Only one of the two
  /// leaves of an edge has this bit: the smaller one, of two equal ones the lower, or the one that was tied.
  /// To find all neighbours of a leaf, check the bits of both sides.
  std::vector<std::uint8_t> open_faces;

  /// Number of leaves that no open face joined to the rest of the solid, and that were tied to a neighbour by
  /// the smallest possible weight.
  std::size_t tied_leaves = 0;
};

/// Joins leaves through each open face between them by an edge of weight (open area) / (distance of the
/// centres along the normal). `neighbours` are those of RefinedLevel.
///
/// If one leaf of size H meets four of size H/2, their centres are also offset along the face, so that the
/// energy of a field that varies along the face would be too large, by the variance of the four. For a field
/// linear along the face the four edges between those leaves cost three times that variance times H/2 * ...,
/// so each of them loses a third of its weight for every such face that its two leaves share. The energy of
/// linear fields then equals the integral.
LeafConnections connect_leaves(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                               const Solid& solid, const Monitor& monitor = {});

/// Returns the boundary forms of a level times `boundary_weight` / (cell size) (times 5/3 in degree 3).
template <int D>
CellForms<D> boundary_forms(const GridLevel& level, const Solid& solid, double boundary_weight);

}  // namespace crossgrain
