// SPDX-License-Identifier: Apache-2.0
#include "display/cell_sizes.hpp"

#include <algorithm>

namespace crossgrain {
namespace {

double smallest_cell(const Octree& tree) {
  int depth = 0;
  for (const CellAddress leaf : tree.leaves()) depth = std::max(depth, leaf.depth());
  return tree.root().cell_size(depth);
}

std::vector<double> mean_edges(const TetDomainData& tets) {
  const std::vector<Vector3>& places = tets.solid.mesh.vertices;
  std::vector<double> sums(places.size(), 0), counts(places.size(), 0);
  for (const StiffnessEdge& edge : tets.edges) {
    const double length = norm(places[edge.j] - places[edge.i]);
    for (const std::uint32_t end : {edge.i, edge.j}) sums[end] += length, counts[end] += 1;
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (counts[v] > 0) sums[v] /= counts[v];
  return sums;
}

}  // namespace

CellSizes::CellSizes(const ShownField& field)
    : field_(field),
      of_vertices_(field.is_on_tets() ? mean_edges(field.tets()) : std::vector<double>{}),
      usual_(field.is_on_tets() ? field.tets().typical_edge_length : smallest_cell(field.grid().tree)) {}

double CellSizes::at(const Vector3& place, std::int64_t vertex) const {
  if (field_.is_on_tets()) {
    const bool is_known = vertex >= 0 && static_cast<std::size_t>(vertex) < of_vertices_.size();
    return is_known && of_vertices_[static_cast<std::size_t>(vertex)] > 0
               ? of_vertices_[static_cast<std::size_t>(vertex)]
               : usual_;
  }
  const Octree& tree = field_.grid().tree;
  const auto cell = tree.root().locate(place);
  const CellIndex leaf = cell ? tree.find_containing(*cell) : kNoCell;
  return leaf == kNoCell ? usual_ : tree.cell_size(leaf);
}

}  // namespace crossgrain
