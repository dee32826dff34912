// SPDX-License-Identifier: Apache-2.0
#include "field/octree_graph.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "constraint/spectral_shift.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/open_faces.hpp"

namespace crossgrain {
namespace {

using FaceWeights = std::array<FaceWeight, kFaceCount>;

/// Steps of weight per open sample of a face.
constexpr int kStepsOfSample = FaceWeight::kFullFace / kOpenFaceSamples;

class LeafConnector {
 public:
  LeafConnector(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid)
      : level_(level), neighbours_(neighbours), tree_(level.tree), solid_(solid) {}

  /// Returns the weights of the edges that leaf i owns: to larger leaves, and to leaves of its size on its
  /// high side.
  FaceWeights owned(CellIndex i) const {
    FaceWeights weights;
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = neighbours_[i][face];
      if (j == kNoCell || (is_equal(i, j) && face_sign(face) < 0)) continue;
      weights[face] = weight(i, face, j, kStepsOfSample * samples_between(i, face, j));
    }
    return weights;
  }

  /// Returns the face behind which the solid most likely continues: the one with the largest component of the
  /// inward normal of leaf i, among those with an admissible leaf behind and a component above `least`. -1 if
  /// there is none.
  template <class Admissible>
  int tie_face(CellIndex i, double least, const Admissible& admissible) const {
    Vector3 inward{0, 0, 0};
    for (const SurfacePiece& piece : level_.pieces_of(i))
      inward += -piece.area * solid_.outward_normal(piece.triangle);
    int best_face = -1;
    for (int face = 0; face < kFaceCount; ++face) {
      const double along = face_sign(face) * inward[face_axis(face)];
      if (along <= least) continue;
      const CellIndex j = neighbours_[i][face];
      if (j == kNoCell || !admissible(j)) continue;
      least = along;
      best_face = face;
    }
    return best_face;
  }

  /// Returns the smallest possible edge: half a sample.
  FaceWeight tie(CellIndex i, int face) const {
    return weight(i, face, neighbours_[i][face], kStepsOfSample / 2);
  }

  bool is_equal(CellIndex i, CellIndex j) const { return tree_[i].depth() == tree_[j].depth(); }

 private:
  int samples_between(CellIndex i, int face, CellIndex j) const {
    // The surface does not cross a face of a leaf without surface, so the face is fully open.
    if (!level_.holds_surface(i) || !level_.holds_surface(j)) return kOpenFaceSamples;
    return open_samples(level_, solid_, i, face);
  }

  /// `steps` is the open area in parts of the face.
  FaceWeight weight(CellIndex i, int face, CellIndex j, int steps) const {
    // The centres of leaves of two sizes are 1.5 times as far apart.
    if (!is_equal(i, j)) return {steps * 2 / 3, true};
    return {steps * (3 - shared_hanging_faces(i, face, j)) / 3, false};
  }

  /// Returns how many leaves of twice the size touch both i and its neighbour j across `face`. Each takes
  /// away a third of the edge's weight; see connect_leaves.
  int shared_hanging_faces(CellIndex i, int face, CellIndex j) const {
    if (tree_[i].depth() == 0 || tree_[i].parent() != tree_[j].parent()) return 0;
    int shared = 0;
    for (int other = 0; other < kFaceCount; ++other) {
      if (face_axis(other) == face_axis(face)) continue;
      const CellIndex k = neighbours_[i][other];
      shared += k != kNoCell && tree_[k].depth() < tree_[i].depth();
    }
    return shared;
  }

  const GridLevel& level_;
  std::span<const FaceNeighbours> neighbours_;
  const Octree& tree_;
  const Solid& solid_;
};

static_assert(FaceWeight::kFullFace % kOpenFaceSamples == 0 && kStepsOfSample / 2 * 2 % 3 == 0 &&
                  kStepsOfSample / 2 * 2 == kStepsOfSample,
              "weights of faces must be whole");

/// Ties isolated leaves that the surface barely cuts, mostly one or two together, to the rest of the solid.
class SpeckTies {
 public:
  SpeckTies(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
            const LeafConnector& connector, LeafConnections& connections)
      : level_(level), neighbours_(neighbours), connector_(connector), connections_(connections) {
    // Leaves that are connected to a leaf with its centre inside are part of the solid; few leaves are not.
    std::vector<std::uint8_t> inside(level.size());
    parallel_for(level.size(),
                 [&](std::size_t i) { inside[i] = level.centre_inside(static_cast<CellIndex>(i)); });
    const std::vector<std::uint8_t> beside_inside = spread(inside);
    const std::vector<std::uint8_t> near_inside = spread(beside_inside);
    for (CellIndex i = 0; i < level.size(); ++i) {
      if (beside_inside[i]) continue;
      loose_.push_back(i);
      components_.push_back({1, near_inside[i] != 0});
    }
    sets_ = DisjointSets(loose_.size());
    for (const CellIndex i : loose_) {
      for (int face = 0; face < kFaceCount; ++face) {
        if (connections.weights[i][face].joined()) join(i, neighbours[i][face]);
      }
    }
  }

  /// Ties specks inwards, beginning at the rest of the solid, so that no speck is tied only to another speck.
  /// Single leaves that this does not reach are tied to any neighbour.
  void tie_all() {
    std::vector<CellIndex> specks;
    for (const CellIndex i : loose_) {
      if (is_speck(i)) specks.push_back(i);
    }
    bool inwards = true;
    while (!specks.empty()) {
      std::vector<CellIndex> waiting;
      for (const CellIndex i : specks) {
        if (inwards ? !is_speck(i) : !is_alone(i)) continue;
        const int face = connector_.tie_face(i, inwards ? 0 : -INFINITY,
                                             [&](CellIndex j) { return !inwards || !is_speck(j); });
        if (face < 0) {
          waiting.push_back(i);
        } else {
          tie(i, face);
        }
      }
      if (waiting.size() == specks.size()) {
        if (!inwards) break;  // leaves without any neighbour
        inwards = false;
      }
      specks = std::move(waiting);
    }
  }

 private:
  /// Maximum number of leaves of a speck; a component of many more is a thin plate of its own.
  static constexpr std::uint32_t kLargestSpeck = 8;

  /// Loose leaves that are connected with each other.
  struct Component {
    std::uint32_t size;
    bool part_of_solid;
  };

  /// Returns `marked` extended by the leaves that are joined to a marked one.
  std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& marked) const {
    std::vector<std::uint8_t> result = marked;
    const auto mark = [&](CellIndex i) { std::atomic_ref(result[i]).store(1, std::memory_order_relaxed); };
    parallel_for(level_.size(), [&](std::size_t at) {
      const auto i = static_cast<CellIndex>(at);
      for (int face = 0; face < kFaceCount; ++face) {
        if (!connections_.weights[i][face].joined()) continue;
        const CellIndex j = neighbours_[i][face];
        if (marked[i]) mark(j);
        if (marked[j]) mark(i);
      }
    });
    return result;
  }

  /// Returns the root of a loose leaf's set; nothing for any other leaf, which is part of the solid.
  std::optional<std::uint32_t> root(CellIndex i) {
    const auto found = std::lower_bound(loose_.begin(), loose_.end(), i);
    if (found == loose_.end() || *found != i) return std::nullopt;
    return sets_.root(static_cast<std::uint32_t>(found - loose_.begin()));
  }

  void join(CellIndex a, CellIndex b) {
    std::optional<std::uint32_t> first = root(a), second = root(b);
    if (first == second) return;
    if (!first) std::swap(first, second);
    if (!second) {
      components_[*first].part_of_solid = true;
      return;
    }
    sets_.join(*first, *second);
    const Component &one = components_[*first], &other = components_[*second];
    components_[sets_.root(*first)] = {one.size + other.size, one.part_of_solid || other.part_of_solid};
  }

  bool is_speck(CellIndex i) {
    const auto at = root(i);
    return at && !components_[*at].part_of_solid && components_[*at].size <= kLargestSpeck;
  }
  bool is_alone(CellIndex i) {
    const auto at = root(i);
    return at && !components_[*at].part_of_solid && components_[*at].size == 1;
  }

  void tie(CellIndex i, int face) {
    const CellIndex j = neighbours_[i][face];
    join(i, j);
    const FaceWeight weight = connector_.tie(i, face);
    connections_.weights[i][face] = weight;
    if (weight.joins_equal()) connections_.weights[j][opposite_face(face)] = weight;
    connections_.open_faces[i] |= static_cast<std::uint8_t>(1u << face);
    ++connections_.tied_leaves;
  }

  const GridLevel& level_;
  std::span<const FaceNeighbours> neighbours_;
  const LeafConnector& connector_;
  LeafConnections& connections_;
  std::vector<CellIndex> loose_;       ///< leaves not joined to any leaf with its centre inside, ascending
  DisjointSets sets_{0};               ///< over indices into loose_
  std::vector<Component> components_;  ///< valid at the roots of the sets
};

}  // namespace

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
  SpeckTies(level, neighbours, connector, result).tie_all();
  return result;
}

template <int D>
CellForms<D> boundary_forms(const GridLevel& level, const Solid& solid, double boundary_weight, Shift shift) {
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
        const QuadraticForm<D> form = cell_form<D>(level, solid, generals[k]);
        forms.set_general(generals[k], shift == Shift::kSpectral ? shifted(form) : form,
                          scale_of(generals[k]));
      },
      level.leaves_per_task());
  return forms;
}

template CellForms<3> boundary_forms<3>(const GridLevel&, const Solid&, double, Shift);
template CellForms<4> boundary_forms<4>(const GridLevel&, const Solid&, double, Shift);

}  // namespace crossgrain
