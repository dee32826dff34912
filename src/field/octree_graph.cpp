// SPDX-License-Identifier: Apache-2.0
#include "field/octree_graph.hpp"

#include "base/parallel.hpp"
#include "field/leaf_connector.hpp"
#include "field/speck_ties.hpp"
#include "grid/cell_constraints.hpp"

namespace crossgrain {

LeafConnections connect_leaves(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                               const Solid& solid, const Monitor& monitor) {
  const LeafConnector connector(level, neighbours, solid);
  LeafConnections result;
  result.open_faces.resize(level.size());
  result.weights = sized_vector<FaceWeights>(level.size());
  parallel_for_chunks(level.size(), level.leaves_per_task(), [&](std::size_t begin, std::size_t end) {
    monitor.check_stop();
    for (std::size_t i = begin; i < end; ++i) {
      result.weights[i] = connector.owned(static_cast<CellIndex>(i));
      for (int face = 0; face < kFaceCount; ++face)
        result.open_faces[i] |= static_cast<std::uint8_t>(result.weights[i][face].joined() << face);
    }
  });
  // Both leaves of one size store the weight of their common face.
  parallel_for(level.size(), [&](std::size_t i) {
    for (int face = 0; face < kFaceCount; face += 2) {
      const CellIndex j = neighbours[i][face];
      if (j != kNoCell && connector.is_equal(static_cast<CellIndex>(i), j))
        result.weights[i][face] = result.weights[j][opposite_face(face)];
    }
  });
  tie_specks(level, neighbours, connector, result);
  return result;
}

template <int D>
CellForms<D> boundary_forms(const GridLevel& level, const Solid& solid, double boundary_weight) {
  CellForms<D> forms(level.size());
  const double degree_factor = D == 3 ? 5.0 / 3 : 1.0;
  const auto scale_of = [&](CellIndex i) {
    return degree_factor * boundary_weight / level.tree.cell_size(i);
  };
  std::vector<std::uint8_t> is_plane(level.size());
  parallel_for(
      level.size(),
      [&](std::size_t i) { is_plane[i] = has_single_normal(level, solid, static_cast<CellIndex>(i)); },
      level.leaves_per_task());
  std::vector<CellIndex> planes, generals;
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (level.is_constrained(i)) (is_plane[i] ? planes : generals).push_back(i);
  }
  forms.reserve_planes(planes);
  parallel_for(planes.size(), [&](std::size_t k) {
    forms.set_plane(planes[k], first_normal(level, solid, planes[k]),
                    scale_of(planes[k]) * constrained_area(level, planes[k]));
  });
  forms.reserve_general(generals);
  parallel_for(
      generals.size(),
      [&](std::size_t k) {
        forms.set_general(generals[k], cell_form<D>(level, solid, generals[k]), scale_of(generals[k]));
      },
      level.leaves_per_task());
  return forms;
}

template CellForms<3> boundary_forms<3>(const GridLevel&, const Solid&, double);
template CellForms<4> boundary_forms<4>(const GridLevel&, const Solid&, double);

}  // namespace crossgrain
