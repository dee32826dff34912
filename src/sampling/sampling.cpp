// SPDX-License-Identifier: Apache-2.0
#include "sampling/sampling.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/parallel.hpp"
#include "sampling/frame_blend.hpp"
#include "sampling/nearest_leaf.hpp"

namespace crossgrain {

Sampler::Sampler(const Octree& tree, std::span<const StoredQuaternion> frames,
                 std::span<const std::uint8_t> open_faces, Turns turns)
    : field_{tree, frames, open_faces}, turns_(turns == Turns::kOfAll ? tree.size() : 0) {
  parallel_for_chunks(turns_.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    LeafSurroundings around(tree, field_.finder);
    for (std::size_t i = begin; i < end; ++i) {
      around.move_to(static_cast<CellIndex>(i));
      turns_[i] = leaf_turn(field_, around);
    }
  });
}

/// Samples points in order, blending up to kPoints of them side by side.
template <std::size_t kPoints>
class Sampler::Run {
 public:
  explicit Run(const Sampler& sampler)
      : field_(sampler.field_),
        turns_(sampler.turns_),
        around_(field_.tree, field_.finder),
        around_turned_(field_.tree, field_.finder) {}

  void answer(std::span<const Vector3> points, std::span<Result> results) {
    // Searches come first, so that none waits for the blending of another point.
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CellIndex before = k > 0 ? results[k - 1].leaf : kNoCell;
      results[k].leaf = leaf_at(points[k], before);
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CellIndex leaf = results[k].leaf;
      if (leaf == kNoCell) {
        const CellIndex nearest = nearest_leaf(field_.tree, points[k]);
        assert(nearest != kNoCell);
        results[k] = {from_stored(field_.frames[nearest]), nearest, false, 0};
        continue;
      }
      if (point_count_ == kPoints || term_count_ + LeavesAround::kMost > kTerms) blend();
      results[k].in_active_cell = true;
      add(points[k], leaf, results[k]);
    }
    blend();
  }

  Quaternion in_leaf(CellIndex leaf, const Vector3& point) {
    Result result;
    add(point, leaf, result);
    blend();
    return result.frame;
  }

 private:
  /// Room for a point with all terms and, for the others, twice the terms between cells of one size.
  static constexpr std::size_t kTerms = LeavesAround::kMost + 16 * (kPoints - 1);

  /// Number of leaves tried after the last one: consecutive points are about as far apart as leaves.
  static constexpr CellIndex kLeavesTried = 4;

  CellIndex leaf_at(const Vector3& point, CellIndex likely) const {
    const auto address = field_.tree.root().locate(point);
    if (!address) return kNoCell;
    if (likely == kNoCell) return field_.finder.containing(*address);
    // Usually in the same leaf or one of the next.
    const std::size_t end = std::min<std::size_t>(likely + kLeavesTried, field_.tree.size());
    for (CellIndex i = likely; i < end; ++i) {
      if (field_.tree[i].contains(*address)) return i;
    }
    return field_.finder.containing(*address);
  }

  void add(const Vector3& point, CellIndex leaf, Result& result) {
    if (leaf != around_.leaf()) around_.move_to(leaf);
    const RootCube& root = field_.tree.root();
    const LeavesAround around(field_, around_, 1 / root.unit() * (point - root.origin));
    const auto known_turn = [&](CellIndex i) -> const LeafTurn& { return turns_[i]; };
    const auto turn_on_demand = [&](CellIndex i) -> const LeafTurn& {
      auto& [of, turn] = latest_[i % kPoints];
      if (of != i) {
        around_turned_.move_to(i);
        turn = leaf_turn(field_, around_turned_);
        of = i;
      }
      return turn;
    };
    BlendTerm* const terms = &terms_[term_count_];
    blends_[point_count_] = turns_.empty() ? frame_blend(field_, around, turn_on_demand, terms)
                                           : frame_blend(field_, around, known_turn, terms);
    term_count_ += blends_[point_count_].terms.size();
    results_[point_count_++] = &result;
  }

  void blend() {
    blend_frames({blends_.data(), point_count_}, {frames_.data(), point_count_},
                 {deviations_.data(), point_count_});
    for (std::size_t p = 0; p < point_count_; ++p) {
      results_[p]->frame = frames_[p];
      results_[p]->deviation = deviations_[p];
    }
    point_count_ = term_count_ = 0;
  }

  /// The latest turn on demand of the leaves with one remainder: points near each other share leaves.
  struct Turned {
    CellIndex leaf = kNoCell;
    LeafTurn turn;
  };

  const LeafField& field_;
  std::span<const LeafTurn> turns_;
  LeafSurroundings around_, around_turned_;
  std::array<Turned, kPoints> latest_;
  std::size_t point_count_ = 0, term_count_ = 0;
  std::array<Result*, kPoints> results_;
  std::array<FrameBlend, kPoints> blends_;
  std::array<Quaternion, kPoints> frames_;
  std::array<double, kPoints> deviations_;
  std::array<BlendTerm, kTerms> terms_;
};

Sampler::Result Sampler::at(const Vector3& point) const {
  Result result;
  Run<1>(*this).answer({&point, 1}, {&result, 1});
  return result;
}

Quaternion Sampler::in_leaf(CellIndex leaf, const Vector3& point) const {
  return Run<1>(*this).in_leaf(leaf, point);
}

void Sampler::at(std::span<const Vector3> points, std::span<Result> results) const {
  Run<32>(*this).answer(points, results);
}

}  // namespace crossgrain
