// SPDX-License-Identifier: Apache-2.0
#include "surface/patches.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Union-find over triangles with a sign: whether a triangle is flipped relative to the root of its set. The
/// root is the lowest number.
class SignedSets {
 public:
  explicit SignedSets(std::size_t count) : parent_(count), turned_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// Returns the root, and whether i is flipped relative to it.
  std::pair<std::uint32_t, bool> root(std::uint32_t i) {
    std::uint32_t top = i;
    bool turned = false;
    while (parent_[top] != top) {
      turned ^= turned_[top];
      top = parent_[top];
    }
    // Path compression.
    for (bool rest = turned; parent_[i] != i;) {
      const std::uint32_t next = parent_[i];
      const bool step = turned_[i];
      parent_[i] = top;
      turned_[i] = rest;
      rest ^= step;
      i = next;
    }
    return {top, turned};
  }

  /// Records whether a and b are flipped relative to each other. Returns false if that contradicts earlier
  /// calls.
  bool join(std::uint32_t a, std::uint32_t b, bool against) {
    auto [low, low_turned] = root(a);
    auto [high, high_turned] = root(b);
    const bool apart = low_turned ^ high_turned ^ against;
    if (low == high) return !apart;
    if (low > high) std::swap(low, high);
    parent_[high] = low;
    turned_[high] = apart;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> turned_;
};

class PatchFinder {
 public:
  PatchFinder(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses, const OpenEdges& open,
              std::span<const double> areas)
      : vertices_(vertices), uses_(uses), open_(open), areas_(areas), sets_(areas.size()) {}

  Patches find() {
    join_over_edges();
    join_over_cracks();
    gather();
    describe_borders();
    choose_larger_parts();
    return std::move(result_);
  }

 private:
  struct Contradiction {
    std::uint32_t triangle;
    Vector3 place;
  };

  void join_over_edges() {
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 2) return;
      if (sets_.join(edge[0].triangle, edge[1].triangle, edge[0].forward == edge[1].forward)) return;
      contradictions_.push_back(
          {edge[0].triangle, 0.5 * (vertices_[edge[0].low()] + vertices_[edge[0].high()])});
    });
  }

  void join_over_cracks() {
    std::vector<CrackSide> cracks = open_.cracks;
    std::stable_sort(cracks.begin(), cracks.end(),
                     [](const CrackSide& a, const CrackSide& b) { return a.gap < b.gap; });
    for (const CrackSide& crack : cracks)
      sets_.join(crack.edge.triangle, crack.beside.triangle, crack.same_direction);
  }

  void gather() {
    patch_of_.resize(areas_.size());
    result_.turned.resize(areas_.size());
    std::vector<bool> takes_part(areas_.size());
    for (const EdgeUse& use : uses_) takes_part[use.triangle] = true;
    for (std::uint32_t t = 0; t < areas_.size(); ++t) {
      if (!takes_part[t]) continue;
      const auto [root, turned] = sets_.root(t);
      // The root is the first triangle of its set.
      if (root == t) {
        patch_of_[t] = static_cast<std::uint32_t>(result_.patches.size());
        result_.patches.emplace_back();
      }
      patch_of_[t] = patch_of_[root];
      result_.turned[t] = turned;
      Patch& patch = result_.patches[patch_of_[t]];
      patch.triangles.push_back(t);
      patch.area += areas_[t];
      if (turned) patch.turned_share += areas_[t];
    }
  }

  void describe_borders() {
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 2) return;
      for (const EdgeUse& use : edge) {
        Patch& patch = result_.patches[patch_of_[use.triangle]];
        ++(edge.size() == 1 ? patch.open_edges : patch.nonmanifold_edges);
      }
    });
    for (const CrackSide& crack : open_.cracks)
      ++result_.patches[patch_of_[crack.edge.triangle]].cracks_joined;
    for (const Contradiction& contradiction : contradictions_) {
      Patch& patch = result_.patches[patch_of_[contradiction.triangle]];
      if (!std::exchange(patch.one_sided, true)) patch.one_sided_place = contradiction.place;
    }
  }

  void choose_larger_parts() {
    for (Patch& patch : result_.patches) {
      if (patch.area > 0) patch.turned_share /= patch.area;
      if (patch.turned_share <= 0.5) continue;
      patch.turned_share = 1 - patch.turned_share;
      for (const std::uint32_t t : patch.triangles) result_.turned[t] = !result_.turned[t];
    }
  }

  const std::vector<Vector3>& vertices_;
  std::span<const EdgeUse> uses_;
  const OpenEdges& open_;
  std::span<const double> areas_;
  SignedSets sets_;
  std::vector<Contradiction> contradictions_;
  std::vector<std::uint32_t> patch_of_;
  Patches result_;
};

}  // namespace

Patches find_patches(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses,
                     const OpenEdges& open, std::span<const double> areas) {
  return PatchFinder(vertices, uses, open, areas).find();
}

}  // namespace crossgrain
