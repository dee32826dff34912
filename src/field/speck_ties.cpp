// SPDX-License-Identifier: Apache-2.0
#include "field/speck_ties.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

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

/// Returns `marked` extended by the leaves that are joined to a marked one.
std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& marked,
                                 std::span<const FaceNeighbours> neighbours,
                                 const LeafConnections& connections) {
  std::vector<std::uint8_t> result = marked;
  const auto mark = [&](CellIndex i) { std::atomic_ref(result[i]).store(1, std::memory_order_relaxed); };
  parallel_for(marked.size(), [&](std::size_t at) {
    const auto i = static_cast<CellIndex>(at);
    for (int face = 0; face < kFaceCount; ++face) {
      if (!connections.weights[i][face].joined()) continue;
      const CellIndex j = neighbours[i][face];
      if (marked[i]) mark(j);
      if (marked[j]) mark(i);
    }
  });
  return result;
}

/// A leaf that is not joined to any leaf with its centre inside. Leaves have their numbers in the level.
struct LooseLeaf {
  std::uint64_t number;
  std::array<std::uint64_t, kFaceCount> neighbours;
  Vector3 inward;
  std::uint8_t joined;  ///< bit of each face
  bool near_inside;

  bool is_joined(int face) const { return joined >> face & 1; }
};

/// Returns the loose leaves of all processes, by number. Leaves that are connected to a leaf with its centre
/// inside are part of the solid; few leaves are not.
std::vector<LooseLeaf> loose_leaves(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                                    const LeafConnector& connector, const LeafConnections& connections) {
  std::vector<std::uint8_t> inside(level.size());
  parallel_for(level.size(),
               [&](std::size_t i) { inside[i] = level.centre_inside(static_cast<CellIndex>(i)); });
  const std::vector<std::uint8_t> beside_inside = spread(inside, neighbours, connections);
  const std::vector<std::uint8_t> near_inside = spread(beside_inside, neighbours, connections);
  const Share share = level.share();
  std::vector<LooseLeaf> loose;
  // Exactly as many: of a plate thinner than its cells all leaves are loose.
  loose.reserve(static_cast<std::size_t>(
      std::count(beside_inside.begin() + share.begin, beside_inside.begin() + share.end, 0)));
  for (CellIndex i = share.begin; i < share.end; ++i) {
    if (beside_inside[i]) continue;
    LooseLeaf& leaf = loose.emplace_back(
        LooseLeaf{level.ghosts.number(share, i), {}, connector.inward(i), 0, near_inside[i] != 0});
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = neighbours[i][face];
      leaf.neighbours[face] = j == kNoCell ? kNoNumber : level.ghosts.number(share, j);
      leaf.joined |= static_cast<std::uint8_t>(connections.weights[i][face].joined() << face);
    }
  }
  return of_all(share, std::move(loose));
}

struct Tie {
  std::size_t loose;
  int face;
};

/// Finds how to tie isolated leaves that the surface barely cuts, mostly one or two together, to the rest of
/// the solid.
class SpeckTies {
 public:
  explicit SpeckTies(std::span<const LooseLeaf> loose) : loose_(loose), sets_(loose.size()) {
    for (std::size_t k = 0; k < loose.size(); ++k) components_.push_back({1, loose[k].near_inside});
    for (std::size_t k = 0; k < loose.size(); ++k) {
      for (int face = 0; face < kFaceCount; ++face) {
        if (loose[k].is_joined(face)) join(k, loose[k].neighbours[face]);
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
          join(k, loose_[k].neighbours[face]);
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
    const Vector3 inward = loose_[k].inward;
    int best_face = -1;
    for (int face = 0; face < kFaceCount; ++face) {
      const double along = face_sign(face) * inward[face_axis(face)];
      if (along <= least) continue;
      const std::uint64_t neighbour = loose_[k].neighbours[face];
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
    const auto at = std::lower_bound(loose_.begin(), loose_.end(), number,
                                     [](const LooseLeaf& leaf, std::uint64_t n) { return leaf.number < n; });
    return at != loose_.end() && at->number == number ? root_of(static_cast<std::size_t>(at - loose_.begin()))
                                                      : Root{};
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

  std::span<const LooseLeaf> loose_;
  DisjointSets sets_;
  std::vector<Component> components_;  ///< valid at the roots of the sets
};

}  // namespace

void tie_specks(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                const LeafConnector& connector, LeafConnections& connections) {
  const std::vector<LooseLeaf> loose = loose_leaves(level, neighbours, connector, connections);
  const std::vector<Tie> found = SpeckTies(loose).all();
  Ties ties(neighbours, connector, connections);
  for (const Tie& tie : found) {
    const auto leaf = level.ghosts.leaf_of(level.share(), loose[tie.loose].number);
    if (leaf && neighbours[*leaf][tie.face] != kNoCell) ties.add(*leaf, tie.face);
  }
  connections.tied_leaves = found.size();
}

}  // namespace crossgrain
