// SPDX-License-Identifier: Apache-2.0
#include "fit/feature_loops.hpp"
#include "fit/nowhere.hpp"

#include <algorithm>

namespace crossgrain {
namespace {

/// One number for each side of each curve.
class CurveSides {
 public:
  explicit CurveSides(const FeatureComplex& features) : features_(features) {
    for (const FeatureComplex::Curve& curve : features.curves) {
      firsts_.push_back(static_cast<std::uint32_t>(count_));
      count_ += curve.sides.size();
    }
  }

  std::size_t count() const { return count_; }

  std::uint32_t number(std::uint32_t curve, std::size_t side) const {
    return firsts_[curve] + static_cast<std::uint32_t>(side);
  }

  /// The side that has this face on the left of a step.
  std::uint32_t find(const LoopStep& step, std::uint32_t face) const {
    const auto& sides = features_.curves[step.curve].sides;
    const auto side = std::ranges::find(sides, FeatureComplex::Side{face, step.is_forward});
    return side == sides.end() ? kNowhere
                               : number(step.curve, static_cast<std::size_t>(side - sides.begin()));
  }

 private:
  const FeatureComplex& features_;
  std::vector<std::uint32_t> firsts_;
  std::size_t count_ = 0;
};

/// The step after one, with the same face on the left; its curve is kNowhere if there is none.
LoopStep next_step(const FeatureComplex& features, const LoopStep& step, std::uint32_t face) {
  const std::uint32_t at = features.curves[step.curve].corners[step.is_forward ? 1 : 0];
  if (at == kNowhere) return step;
  const FeatureComplex::Corner& corner = features.corners[at];
  const auto end = std::ranges::find(corner.ends, FeatureComplex::End{step.curve, step.is_forward});
  const auto k = static_cast<std::uint32_t>(end - corner.ends.begin());
  for (const FeatureComplex::Sector& sector : corner.sectors) {
    if (sector.to != k || sector.face != face || sector.from == kNowhere) continue;
    const FeatureComplex::End& next = corner.ends[sector.from];
    return {next.curve, !next.is_last};
  }
  return {kNowhere, false};
}

}  // namespace

FeatureLoop from_least_step(FeatureLoop loop) {
  std::ranges::rotate(loop, std::ranges::min_element(loop));
  return loop;
}

std::vector<std::vector<FeatureLoop>> loops_of_faces(const FeatureComplex& features) {
  const CurveSides sides(features);
  std::vector<bool> is_seen(sides.count(), false);
  std::vector<std::vector<FeatureLoop>> loops(features.faces.size());
  for (std::uint32_t curve = 0; curve < features.curves.size(); ++curve) {
    for (std::size_t k = 0; k < features.curves[curve].sides.size(); ++k) {
      const FeatureComplex::Side& side = features.curves[curve].sides[k];
      LoopStep step{curve, side.is_left};
      FeatureLoop loop;
      std::uint32_t number = sides.number(curve, k);
      while (number != kNowhere && !is_seen[number]) {
        is_seen[number] = true;
        loop.push_back(step);
        step = next_step(features, step, side.face);
        number = step.curve == kNowhere ? kNowhere : sides.find(step, side.face);
      }
      if (number != kNowhere && !loop.empty() && step == loop.front())
        loops[side.face].push_back(from_least_step(std::move(loop)));
    }
  }
  for (auto& of_face : loops) std::ranges::sort(of_face);
  return loops;
}

}  // namespace crossgrain
