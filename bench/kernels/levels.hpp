// SPDX-License-Identifier: Apache-2.0
// Input of kernels: levels of generated parts, as a solve makes them, and a box of cells that are all inside.
// Each is made once. Only this file and levels.cpp include the headers of src/grid and src/field for levels,
// graphs and states.
#pragma once

#include <vector>

#include "field/field_state.hpp"
#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "kernels/item_cost.hpp"
#include "kernels/update_flops.hpp"

namespace crossgrain::bench {

enum class Part {
  kBracket,  ///< flat faces, creases, a fillet and a hole
  kTorus     ///< curved everywhere, so every cell with surface has several normals
};

/// The finest level of a part, and the previous one.
struct PartLevel {
  testing::TestSolid solid;
  GridLevel before;
  std::vector<FaceNeighbours> neighbours_before;
  Marks marks;  ///< leaves of `before` that were split
  GridLevel level;
  std::vector<FaceNeighbours> neighbours;
  std::vector<CellIndex> parent;
  LeafConnections connections;

  explicit PartLevel(TriangleMesh mesh);
};

const PartLevel& part_level(Part part);

/// A graph for sweeps, and an initial state: frames a tenth of a radian off a constant field, so that cells
/// take steps of realistic size. At a minimum they would only halve steps that gain nothing.
template <int D>
struct SweptField {
  FieldGraph<D> graph;
  FieldState<D> start;
};

/// Returns a box of 96 cells across. Except at its sides, all cells have eighteen neighbours of equal weight
/// and no form.
template <int D>
const SweptField<D>& box_field();

template <int D>
const SweptField<D>& part_field(Part part);

/// Returns the mean cost of a cell of a graph: flops by `flops_of` for each kind of cell; bytes of the graph
/// and, read and written, of the state that a sweep changes.
enum class SweptData { kCoefficients, kFramesAndCoefficients };
template <int D>
ItemCost sweep_cost(const FieldGraph<D>& graph, double (*flops_of)(const CellKind&), SweptData changed);

/// Returns the bytes of the arrays of a level (with neighbours and parents), of faces between leaves, and of
/// the lists that a graph makes of them.
double bytes_of(const GridLevel& level);
double bytes_of(const LeafConnections& connections);
double bytes_of(const Adjacency& adjacency);

/// Returns the number of faces between leaves of `level` that both hold surface, for which connect_leaves
/// takes samples, times the number of pieces that each sample tests.
double sampled_pieces(const PartLevel& part);

/// Returns the number of pieces that refining `part.before` clips, and of those that are not empty
/// afterwards.
struct ClippedPieces {
  double tried = 0, kept = 0;
};
ClippedPieces clipped_pieces(const PartLevel& part);

}  // namespace crossgrain::bench
