// SPDX-License-Identifier: Apache-2.0
#include "solve/carried_frames.hpp"

#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"
#include "sampling/nearest_leaf.hpp"
#include "solve/leaf_components.hpp"

namespace crossgrain {
namespace {

/// Pairs of a component of tets and a component of leaves that contains a vertex of it.
class SharedComponents {
 public:
  explicit SharedComponents(std::vector<std::uint32_t> of_leaf) : of_leaf_(std::move(of_leaf)) {}

  void add(std::uint32_t tet_component, CellIndex leaf) { pairs_.emplace(tet_component, of_leaf_[leaf]); }

  bool has(std::uint32_t tet_component, CellIndex leaf) const {
    return pairs_.contains({tet_component, of_leaf_[leaf]});
  }

  bool has_any(std::uint32_t tet_component) const {
    const auto first = pairs_.lower_bound({tet_component, 0});
    return first != pairs_.end() && first->first == tet_component;
  }

 private:
  std::vector<std::uint32_t> of_leaf_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace

CarriedFrames carried_frames(const GridFrames& field, const TetSolid& solid) {
  const std::vector<Vector3>& points = solid.mesh.vertices;
  const LeafFinder finder(field.tree);
  CarriedFrames result;
  result.frames.resize(points.size());
  std::vector<CellIndex> leaf(points.size());
  parallel_for(points.size(), [&](std::size_t i) {
    const auto address = field.tree.root().locate(points[i]);
    leaf[i] = address ? finder.containing(*address) : kNoCell;
    const CellIndex source = leaf[i] == kNoCell ? nearest_leaf(field.tree, points[i]) : leaf[i];
    result.frames[i] = from_stored(field.frames[source]);
  });

  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (leaf[i] == kNoCell && solid.vertex_components[i] != kNoComponent) outside.push_back(i);
  }
  result.outside = outside.size();
  if (outside.empty()) return result;

  SharedComponents shared(leaf_components(field.tree, field.open_faces));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (leaf[i] != kNoCell && solid.vertex_components[i] != kNoComponent)
      shared.add(solid.vertex_components[i], leaf[i]);
  }
  parallel_for(outside.size(), [&](std::size_t k) {
    const std::size_t i = outside[k];
    const std::uint32_t component = solid.vertex_components[i];
    if (!shared.has_any(component)) return;
    const CellIndex nearest =
        nearest_leaf(field.tree, points[i], [&](CellIndex j) { return shared.has(component, j); });
    result.frames[i] = from_stored(field.frames[nearest]);
  });
  return result;
}

}  // namespace crossgrain
