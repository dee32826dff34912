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

  /// Returns the inward normals of the surface in leaf i, times their areas.
  Vector3 inward(CellIndex i) const {
    Vector3 sum{0, 0, 0};
    for (const SurfacePiece& piece : level_.pieces_of(i))
      sum += -piece.area * solid_.outward_normal(piece.triangle);
    return sum;
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

/// Ties leaves to neighbours, by the smallest possible weight.
class Ties {
 public:
  Ties(std::span<const FaceNeighbours> neighbours, const LeafConnector& connector,
       LeafConnections& connections)
      : neighbours_(neighbours), connector_(connector), connections_(connections) {}

  void add(CellIndex i, int face) {
    const CellIndex j = neighbours_[i][face];
    const FaceWeight weight = connector_.tie(i, face);
    connections_.weights[i][face] = weight;
    if (weight.joins_equal()) connections_.weights[j][opposite_face(face)] = weight;
    connections_.open_faces[i] |= static_cast<std::uint8_t>(1u << face);
  }

 private:
  std::span<const FaceNeighbours> neighbours_;
  const LeafConnector& connector_;
  LeafConnections& connections_;
};

constexpr std::uint64_t kNoNumber = ~std::uint64_t{0};

/// Leaves that are not joined to any leaf with its centre inside, in a level that this process has as a
/// whole.
class LooseLeaves {
 public:
  LooseLeaves(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
              const LeafConnector& connector, const LeafConnections& connections)
      : neighbours_(neighbours), connector_(connector), connections_(connections) {
    // Leaves that are connected to a leaf with its centre inside are part of the solid; few leaves are not.
    std::vector<std::uint8_t> inside(level.size());
    parallel_for(level.size(),
                 [&](std::size_t i) { inside[i] = level.centre_inside(static_cast<CellIndex>(i)); });
    const std::vector<std::uint8_t> beside_inside = spread(inside);
    const std::vector<std::uint8_t> near_inside = spread(beside_inside);
    const Share share = level.share();
    for (CellIndex i = share.begin; i < share.end; ++i) {
      if (beside_inside[i]) continue;
      leaves_.push_back(i);
      near_inside_.push_back(near_inside[i]);
    }
  }

  std::size_t size() const { return leaves_.size(); }

  /// Number of leaf k among all of the level, loose or not; ascending.
  std::uint64_t number(std::size_t k) const { return leaves_[k]; }
  std::uint64_t neighbour(std::size_t k, int face) const {
    const CellIndex j = neighbours_[leaves_[k]][face];
    return j == kNoCell ? kNoNumber : j;
  }

  CellIndex leaf(std::size_t k) const { return leaves_[k]; }
  bool is_near_inside(std::size_t k) const { return near_inside_[k] != 0; }
  bool is_joined(std::size_t k, int face) const { return connections_.weights[leaves_[k]][face].joined(); }
  Vector3 inward(std::size_t k) const { return connector_.inward(leaves_[k]); }

 private:
  /// Returns `marked` extended by the leaves that are joined to a marked one.
  std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& marked) const {
    std::vector<std::uint8_t> result = marked;
    const auto mark = [&](CellIndex i) { std::atomic_ref(result[i]).store(1, std::memory_order_relaxed); };
    parallel_for(marked.size(), [&](std::size_t at) {
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

  std::span<const FaceNeighbours> neighbours_;
  const LeafConnector& connector_;
  const LeafConnections& connections_;
  std::vector<CellIndex> leaves_;
  std::vector<std::uint8_t> near_inside_;
};

/// The loose leaves of all processes that share a level.
class LooseLeavesOfAll {
 public:
  LooseLeavesOfAll(const GridLevel& level, const LooseLeaves& own) {
    const Share share = level.share();
    const auto number_of = [&](std::uint64_t leaf) {
      return leaf == kNoNumber ? kNoNumber : level.ghosts.number(share, leaf);
    };
    std::vector<Record> records(own.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      Record& record = records[k];
      record = {number_of(own.number(k)), {}, own.inward(k), 0, own.is_near_inside(k)};
      for (int face = 0; face < kFaceCount; ++face) {
        record.neighbours[face] = number_of(own.neighbour(k, face));
        record.joined |= static_cast<std::uint8_t>(own.is_joined(k, face) << face);
      }
    }
    records_ = gathered_values<Record>(*share.exchange, records);
  }

  std::size_t size() const { return records_.size(); }
  std::uint64_t number(std::size_t k) const { return records_[k].number; }
  std::uint64_t neighbour(std::size_t k, int face) const { return records_[k].neighbours[face]; }
  bool is_near_inside(std::size_t k) const { return records_[k].near_inside; }
  bool is_joined(std::size_t k, int face) const { return records_[k].joined >> face & 1; }
  Vector3 inward(std::size_t k) const { return records_[k].inward; }

 private:
  struct Record {
    std::uint64_t number;
    std::array<std::uint64_t, kFaceCount> neighbours;
    Vector3 inward;
    std::uint8_t joined;  ///< bit of each face
    bool near_inside;
  };
  std::vector<Record> records_;
};

/// A loose leaf and the face to tie.
struct Tie {
  std::size_t loose;
  int face;
};

/// Finds how to tie isolated leaves that the surface barely cuts, mostly one or two together, to the rest of
/// the solid. `Leaves` is LooseLeaves or LooseLeavesOfAll.
template <class Leaves>
class SpeckTies {
 public:
  explicit SpeckTies(const Leaves& loose) : loose_(loose), sets_(loose.size()) {
    for (std::size_t k = 0; k < loose.size(); ++k) components_.push_back({1, loose.is_near_inside(k)});
    for (std::size_t k = 0; k < loose.size(); ++k) {
      for (int face = 0; face < kFaceCount; ++face) {
        if (loose.is_joined(k, face)) join(k, loose.neighbour(k, face));
      }
    }
  }

  /// Ties specks inwards, beginning at the rest of the solid, so that no speck is tied only to another speck.
  /// Single leaves that this does not reach are tied to any neighbour.
  std::vector<Tie> all() {
    std::vector<Tie> ties;
    std::vector<std::size_t> specks;
    for (std::size_t k = 0; k < loose_.size(); ++k) {
      if (is_speck(root_of(k))) specks.push_back(k);
    }
    bool inwards = true;
    while (!specks.empty()) {
      std::vector<std::size_t> waiting;
      for (const std::size_t k : specks) {
        if (inwards ? !is_speck(root_of(k)) : !is_alone(k)) continue;
        const int face = tie_face(k, inwards ? 0 : -INFINITY, [&](std::uint64_t neighbour) {
          return !inwards || !is_speck(root(neighbour));
        });
        if (face < 0) {
          waiting.push_back(k);
        } else {
          join(k, loose_.neighbour(k, face));
          ties.push_back({k, face});
        }
      }
      if (waiting.size() == specks.size()) {
        if (!inwards) break;  // leaves without any neighbour
        inwards = false;
      }
      specks = std::move(waiting);
    }
    return ties;
  }

 private:
  /// Maximum number of leaves of a speck; a component of many more is a thin plate of its own.
  static constexpr std::uint32_t kLargestSpeck = 8;

  /// Loose leaves that are connected with each other.
  struct Component {
    std::uint32_t size;
    bool part_of_solid;
  };

  /// Returns the face behind which the solid most likely continues: the one with the largest component of the
  /// inward normal of a loose leaf, among those with an admissible leaf behind and a component above `least`.
  /// -1 if there is none.
  template <class Admissible>
  int tie_face(std::size_t k, double least, const Admissible& admissible) const {
    const Vector3 inward = loose_.inward(k);
    int best_face = -1;
    for (int face = 0; face < kFaceCount; ++face) {
      const double along = face_sign(face) * inward[face_axis(face)];
      if (along <= least) continue;
      const std::uint64_t neighbour = loose_.neighbour(k, face);
      if (neighbour == kNoNumber || !admissible(neighbour)) continue;
      least = along;
      best_face = face;
    }
    return best_face;
  }

  using Root = std::optional<std::uint32_t>;

  Root root_of(std::size_t k) { return sets_.root(static_cast<std::uint32_t>(k)); }

  /// Returns the root of a loose leaf's set; nothing for any other leaf, which is part of the solid.
  Root root(std::uint64_t number) {
    std::size_t first = 0, last = loose_.size();
    while (first < last) {
      const std::size_t middle = first + (last - first) / 2;
      if (loose_.number(middle) < number) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    return first < loose_.size() && loose_.number(first) == number ? root_of(first) : Root{};
  }

  void join(std::size_t k, std::uint64_t neighbour) {
    const Root first = root_of(k), second = root(neighbour);
    if (first == second) return;
    if (!second) {
      components_[*first].part_of_solid = true;
      return;
    }
    sets_.join(*first, *second);
    const Component &one = components_[*first], &other = components_[*second];
    components_[sets_.root(*first)] = {one.size + other.size, one.part_of_solid || other.part_of_solid};
  }

  bool is_speck(const Root& at) const {
    return at && !components_[*at].part_of_solid && components_[*at].size <= kLargestSpeck;
  }
  bool is_alone(std::size_t k) {
    const Root at = root_of(k);
    return !components_[*at].part_of_solid && components_[*at].size == 1;
  }

  const Leaves& loose_;
  DisjointSets sets_;
  std::vector<Component> components_;  ///< valid at the roots of the sets
};

/// Ties the specks of a level.
void tie_specks(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                const LeafConnector& connector, LeafConnections& connections) {
  const LooseLeaves loose(level, neighbours, connector, connections);
  Ties ties(neighbours, connector, connections);
  const Share share = level.share();
  if (share.is_whole()) {
    const std::vector<Tie> found = SpeckTies(loose).all();
    for (const Tie& tie : found) ties.add(loose.leaf(tie.loose), tie.face);
    connections.tied_leaves = found.size();
    return;
  }
  const LooseLeavesOfAll all(level, loose);
  const std::vector<Tie> found = SpeckTies(all).all();
  const auto& numbers = level.ghosts.numbers;
  for (const Tie& tie : found) {
    const std::uint64_t number = all.number(tie.loose);
    if (number >= share.before && number < share.before + share.size()) {
      ties.add(share.begin + static_cast<CellIndex>(number - share.before), tie.face);
    } else if (const auto ghost = std::lower_bound(numbers.begin(), numbers.end(), number);
               ghost != numbers.end() && *ghost == number) {
      const auto index = static_cast<CellIndex>(ghost - numbers.begin());
      const CellIndex leaf = index < share.begin ? index : index + static_cast<CellIndex>(share.size());
      if (neighbours[leaf][tie.face] != kNoCell) ties.add(leaf, tie.face);
    }
  }
  connections.tied_leaves = found.size();
}

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
  tie_specks(level, neighbours, connector, result);
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
