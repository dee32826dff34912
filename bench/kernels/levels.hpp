// SPDX-License-Identifier: Apache-2.0
// What kernels run on: levels of generated parts as a solve makes them, and a box of cells that are all
// inside. Each is made once. Of the headers of src/grid and src/field that hold levels, graphs and states,
// the benchmarks look into them here and in levels.cpp only.
#pragma once

#include <cstddef>
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
  kTorus     ///< curved everywhere: every cell with surface has several normals
};

/// The finest level of a part, and the one that it was refined from.
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

/// A graph to sweep over, and a state to begin with: frames a tenth of a radian off a constant field, so that
/// cells take real steps as they do in a solve; at rest they would spend their time halving steps that gain
/// nothing.
template <int D>
struct SweptField {
  FieldGraph<D> graph;
  FieldState<D> start;
};

/// 96 cells across: but for the sides of the box all have eighteen neighbours of one weight, and no form.
template <int D>
const SweptField<D>& box_field();

template <int D>
const SweptField<D>& part_field(Part part);

/// The mean over the cells of a graph: flops as flops_of tells for each kind of cell, bytes of the graph and,
/// read and written, of what a sweep changes.
enum class SweptData { kCoefficients, kFramesAndCoefficients };
template <int D>
ItemCost sweep_cost(const FieldGraph<D>& graph, double (*flops_of)(const CellKind&), SweptData changed);

/// Bytes of the arrays of a level (with neighbours and parents), of faces between leaves, and of the lists
/// that a graph makes of them.
double bytes_of(const GridLevel& level);
double bytes_of(const LeafConnections& connections);
double bytes_of(const Adjacency& adjacency);

/// Faces between two leaves of `level` that both hold surface, for which connect_leaves takes samples, times
/// the pieces that each sample looks at.
double sampled_pieces(const PartLevel& part);

/// Pieces that refining `part.before` clips, and those of them that something was left of.
struct ClippedPieces {
  double tried = 0, kept = 0;
};
ClippedPieces clipped_pieces(const PartLevel& part);

}  // namespace crossgrain::bench
