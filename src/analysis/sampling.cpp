// SPDX-License-Identifier: Apache-2.0
// Notation: x the point, A the leaf that holds it; h the blend of coefficients.
#include "analysis/sampling.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/nearest_leaf.hpp"
#include "base/parallel.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

/// Where h . h(R) reaches this share of |h| at a local maximum R, that is the nearest frame: any other as
/// near would be within 0.36 rad of R, where there is one maximum only. Else the blend is far from all frames
/// (at a singular line).
constexpr double kCertainlyNearest = 0.95;

/// Leaves around a point whose hats reach it: 8 of one size; with smaller ones at most 4 behind each of three
/// faces and 2 behind each of three edges, and larger ones instead of those on the other sides.
constexpr int kMostAround = 64;

/// The leaves around x that have a weight there; A is the first.
class LeavesAround {
 public:
  struct Member {
    PlacedLeaf leaf;
    Vector3 offset;  ///< of x from the leaf's centre, in its cells
    double weight;
  };

  /// `point` in units of the smallest possible cell.
  LeavesAround(const LeafField& field, const Vector3& point) : field_(field), point_(point) {}

  const Member* begin() const { return members_.data(); }
  const Member* end() const { return members_.data() + size_; }
  int size() const { return size_; }

  void add(CellIndex i) {
    const PlacedLeaf leaf = placed(field_, i);
    const Vector3 offset = leaf.offset_of(point_);
    const Vector3 hat{1 - std::abs(offset[0]), 1 - std::abs(offset[1]), 1 - std::abs(offset[2])};
    if (!(hat[0] > 0 && hat[1] > 0 && hat[2] > 0) || size_ == kMostAround) return;
    // A leaf larger than A lies over several cells next to A.
    for (const Member& member : *this) {
      if (member.leaf.index == i) return;
    }
    members_[static_cast<std::size_t>(size_++)] = {leaf, offset, hat[0] * hat[1] * hat[2]};
  }

  /// Keeps what is joined to A through open faces between leaves that are here.
  void keep_joined() {
    int kept = 1;
    // Members [0, kept) are joined to A; those from `next` on have not been asked yet what they are joined
    // to.
    for (int next = 0; next < kept && kept < size_; ++next) {
      for (int k = kept; k < size_; ++k) {
        if (joined(members_[next].leaf, members_[k].leaf)) std::swap(members_[k], members_[kept++]);
      }
    }
    size_ = kept;
  }

  /// Weighted mean of x - c over the leaves, in units of the smallest possible cell.
  Vector3 mean_offset() const {
    Vector3 sum{0, 0, 0};
    double total = 0;
    for (const auto& [leaf, offset, weight] : *this) {
      sum += weight * leaf.width * offset;
      total += weight;
    }
    return 1 / total * sum;
  }

 private:
  const LeafField& field_;
  Vector3 point_;
  int size_ = 0;
  std::array<Member, kMostAround> members_;
};

void add_even_surroundings(const LeafField& field, CellIndex leaf, LeavesAround& around) {
  // Only the seven on the near side of A have a weight.
  const Vector3 offset = around.begin()->offset;
  for (int corner = 1; corner < 8; ++corner) {
    std::array<int, 3> step;
    for (int axis = 0; axis < 3; ++axis) step[axis] = (corner >> axis & 1) * (offset[axis] < 0 ? -1 : 1);
    const auto across = moved(field.tree[leaf], step);
    const CellIndex other = across ? field.finder.containing(*across) : kNoCell;
    if (other != kNoCell) around.add(other);
  }
}

void add_uneven_surroundings(const LeafField& field, CellIndex leaf, LeavesAround& around) {
  const Vector3 offset = around.begin()->offset;
  const CellAddress own = field.tree[leaf];
  for (int number = 0; number < 27; ++number) {
    const std::array<int, 3> step{number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
    const auto across = moved(own, step);
    if (!across) continue;
    const auto [first, last] = field.finder.over(*across);
    // Across the far side of A, more than half a cell away, only a leaf larger than A has a weight.
    const bool far_side = step[0] * offset[0] < 0 || step[1] * offset[1] < 0 || step[2] * offset[2] < 0;
    if (far_side && (first == last || field.tree[first].depth() >= own.depth())) continue;
    for (CellIndex i = first; i < last; ++i) around.add(i);
  }
}

}  // namespace

Sampler::Sampler(const Octree& tree, std::span<const StoredQuaternion> frames,
                 std::span<const std::uint8_t> open_faces)
    : field_{tree, frames, open_faces}, turns_(tree.size()) {
  parallel_for(turns_.size(),
               [&](std::size_t i) { turns_[i] = leaf_turn(field_, static_cast<CellIndex>(i)); });
}

Quaternion Sampler::in_leaf(CellIndex leaf, const Vector3& point) const {
  const RootCube& root = field_.tree.root();
  LeavesAround around(field_, 1 / root.unit() * (point - root.origin));
  around.add(leaf);
  const bool even = turns_[leaf].even_surroundings;
  if (even) {
    add_even_surroundings(field_, leaf, around);
  } else {
    add_uneven_surroundings(field_, leaf, around);
  }
  const bool all_open =
      even && around.size() == 8 && std::all_of(around.begin(), around.end(), [&](const auto& member) {
        return turns_[member.leaf.index].open_all_around;
      });
  if (!all_open) around.keep_joined();

  const Vector3 lopsided = around.mean_offset();
  Coefficients<4> h{};
  for (const auto& [other, offset, weight] : around) {
    const Vector3 half_way = 0.5 * (offset + 1.0 / other.width * lopsided);
    const Quaternion extended = extended_frame(field_.frames[other.index], turns_[other.index], half_way);
    add_scaled(h, weight, frame_coefficients<4>(extended));
  }
  const Quaternion own = extended_frame(field_.frames[leaf], turns_[leaf], around.begin()->offset);
  const Quaternion nearby = refine_frame<4>(h, normalised(own));
  const double reached = dot(h, frame_coefficients<4>(nearby));
  return reached > kCertainlyNearest * std::sqrt(squared_norm(h)) ? nearby : nearest_frame<4>(h);
}

Sampler::Result Sampler::at(const Vector3& point) const {
  const auto address = field_.tree.root().locate(point);
  const CellIndex leaf = address ? field_.finder.containing(*address) : kNoCell;
  if (leaf != kNoCell) return {in_leaf(leaf, point), leaf, true};
  const CellIndex nearest = nearest_leaf(field_.tree, point);
  assert(nearest != kNoCell);
  return {from_stored(field_.frames[nearest]), nearest, false};
}

}  // namespace crossgrain
