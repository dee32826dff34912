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

}  // namespace

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

}  // namespace crossgrain
