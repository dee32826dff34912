// SPDX-License-Identifier: Apache-2.0
// A level of the octree as the graph that the solver sees.
#pragma once

#include "crossgrain/monitor.hpp"
#include "field/field_graph.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// How the leaves of a level hang together.
struct LeafConnections {
  std::vector<WeightedEdge> edges;  ///< through faces; field/leaf_stencil.hpp makes diagonals of some

  /// Bit f of open_faces[i]: there is an edge from leaf i to Octree::neighbour(i, f). Every edge has this bit
  /// on one of its two leaves: the smaller, of two equal ones the lower, or the one that was tied. So who
  /// asks for a leaf's neighbours looks at the bits of both sides.
  std::vector<std::uint8_t> open_faces;

  /// Leaves that no open face joined to the rest of the solid, and that were tied to a neighbour by the
  /// smallest one there can be.
  std::size_t tied_leaves = 0;
};

/// One edge for each open face between leaves, of weight (open area) / (distance of the centres along the
/// normal).
///
/// Where one leaf of size H meets four of size H/2, the centres are off each other along the face too, so
/// that a field that varies along the face would cost more than it should: by the variance of the four. For a
/// field linear along the face the four edges between those leaves cost three times that variance times H/2 *
/// ..., so each of them gives up a third of its weight for every such face that its two leaves share. Linear
/// fields then cost what the integral says.
LeafConnections connect_leaves(const GridLevel& level, const Solid& solid, const Monitor& monitor = {});

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
