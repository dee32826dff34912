// SPDX-License-Identifier: Apache-2.0
// A level of the octree as the graph that the solver sees.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "field/field_graph.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// The weight of the edge from a leaf through one of its faces to the leaf of the same size or larger behind
/// it: nothing where they are not joined.
class FaceWeight {
 public:
  /// What a wholly open face between two leaves of one size weighs in steps: so many that the weights of all
  /// faces there can be are whole.
  static constexpr int kFullFace = 96;

  FaceWeight() = default;
  FaceWeight(int steps, bool to_larger)
      : packed_(static_cast<std::uint8_t>(steps | (steps > 0 && to_larger ? kToLarger : 0))) {}

  bool joined() const { return packed_ != 0; }
  bool joins_equal() const { return packed_ != 0 && !(packed_ & kToLarger); }
  bool joins_larger() const { return (packed_ & kToLarger) != 0; }

  /// In units of the leaf's size over kFullFace.
  int steps() const { return packed_ & ~kToLarger; }

 private:
  static constexpr unsigned kToLarger = 128;

  std::uint8_t packed_ = 0;
};

/// How the leaves of a level hang together through their faces; field/leaf_stencil.hpp makes diagonals of
/// some.
struct LeafConnections {
  /// Leaves of the same size have the weight of their common face both.
  std::vector<std::array<FaceWeight, kFaceCount>> weights;

  /// Bit f of open_faces[i]: there is an edge from leaf i to Octree::neighbour(i, f). Every edge has this bit
  /// on one of its two leaves: the smaller, of two equal ones the lower, or the one that was tied. So who
  /// asks for a leaf's neighbours looks at the bits of both sides.
  std::vector<std::uint8_t> open_faces;

  /// Leaves that no open face joined to the rest of the solid, and that were tied to a neighbour by the
  /// smallest one there can be.
  std::size_t tied_leaves = 0;
};

/// Joins leaves through each open face between them, by an edge of weight (open area) / (distance of the
/// centres along the normal).
///
/// Where one leaf of size H meets four of size H/2, the centres are off each other along the face too, so
/// that a field that varies along the face would cost more than it should: by the variance of the four. For a
/// field linear along the face the four edges between those leaves cost three times that variance times H/2 *
/// ..., so each of them gives up a third of its weight for every such face that its two leaves share. Linear
/// fields then cost what the integral says.
LeafConnections connect_leaves(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                               const Solid& solid, const Monitor& monitor = {});

/// Whether the forms of cells are shifted so that they penalise only what their constraints exclude
/// (docs/design.md section 3). That changes relaxed coefficients; for frames it changes the energy by a
/// constant.
enum class Shift : bool { kNone, kSpectral };

/// The boundary forms of a level times `boundary_weight` / (cell size) (times 5/3 in degree 3).
template <int D>
CellForms<D> boundary_forms(const GridLevel& level, const Solid& solid, double boundary_weight, Shift shift);

extern template CellForms<3> boundary_forms<3>(const GridLevel&, const Solid&, double, Shift);
extern template CellForms<4> boundary_forms<4>(const GridLevel&, const Solid&, double, Shift);

}  // namespace crossgrain
