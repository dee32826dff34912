// SPDX-License-Identifier: Apache-2.0
#include "fit/curve_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kRun = 8;  // segments of a leaf

double distance_to_box(const Box& box, const Vector3& p) {
  Vector3 off{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    off[axis] = std::max({box.low[axis] - p[axis], 0.0, p[axis] - box.high[axis]});
  return norm(off);
}

}  // namespace

CurveLine::CurveLine(const FeatureComplex& features, std::uint32_t curve)
    : is_closed_(features.curves[curve].is_closed()) {
  for (const std::uint32_t vertex : features.curves[curve].vertices) {
    points_.push_back(features.vertices[vertex]);
    const std::size_t k = points_.size() - 1;
    lengths_.push_back(k == 0 ? 0 : lengths_.back() + norm(points_[k] - points_[k - 1]));
  }
  while (runs_ * kRun < points_.size() - 1) runs_ *= 2;
  boxes_.assign(2 * runs_, empty_box());
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    include(boxes_[runs_ + k / kRun], points_[k]);
    include(boxes_[runs_ + k / kRun], points_[k + 1]);
  }
  for (std::size_t node = runs_ - 1; node > 0; --node) {
    boxes_[node] = boxes_[2 * node];
    include(boxes_[node], boxes_[2 * node + 1].low);
    include(boxes_[node], boxes_[2 * node + 1].high);
    if (boxes_[2 * node + 1].low[0] > boxes_[2 * node + 1].high[0]) boxes_[node] = boxes_[2 * node];
  }
}

Vector3 CurveLine::at(double arc_length) const {
  const double whole = length();
  if (is_closed_ && whole > 0) arc_length -= whole * std::floor(arc_length / whole);
  const auto next = std::ranges::upper_bound(lengths_, arc_length);
  const auto k = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - lengths_.begin(), 1, std::ssize(lengths_) - 1));
  const double step = lengths_[k] - lengths_[k - 1];
  const double t = step > 0 ? std::clamp((arc_length - lengths_[k - 1]) / step, 0.0, 1.0) : 0;
  return points_[k - 1] + t * (points_[k] - points_[k - 1]);
}

CurveLine::Nearest CurveLine::nearest(const Vector3& p, double low, double high) const {
  Nearest best{INFINITY, low, {}};
  const double whole = length();
  if (!is_closed_ || !(whole > 0)) {
    search(p, std::clamp(low, 0.0, whole), std::clamp(high, 0.0, whole), best);
    return best;
  }
  const double before = whole * std::floor(low / whole);
  high = std::min(high, low + whole);
  search(p, low - before, std::min(high - before, whole), best);
  if (high - before > whole) search(p, 0, high - before - whole, best);
  return best;
}

void CurveLine::search(const Vector3& p, double low, double high, Nearest& best) const {
  std::array<std::size_t, 128> open;  // two of each level
  std::size_t count = 0;
  open[count++] = 1;
  while (count > 0) {
    const std::size_t node = open[--count];
    if (distance_to_box(boxes_[node], p) >= best.distance) continue;
    if (node < runs_) {
      const bool is_first_nearer =
          distance_to_box(boxes_[2 * node], p) <= distance_to_box(boxes_[2 * node + 1], p);
      open[count++] = 2 * node + (is_first_nearer ? 1 : 0);
      open[count++] = 2 * node + (is_first_nearer ? 0 : 1);
      continue;
    }
    const std::size_t first = (node - runs_) * kRun, end = std::min(first + kRun, points_.size() - 1);
    for (std::size_t k = first; k < end; ++k) {
      const double step = lengths_[k + 1] - lengths_[k];
      if (!(step > 0) || lengths_[k + 1] < low || lengths_[k] > high) continue;
      const Vector3 along = (1 / step) * (points_[k + 1] - points_[k]);
      const double least = std::max(low - lengths_[k], 0.0), most = std::min(high - lengths_[k], step);
      const double t = std::clamp(dot(p - points_[k], along), least, std::max(least, most));
      const double distance = norm(points_[k] + t * along - p);
      if (distance < best.distance) best = {distance, lengths_[k] + t, along};
    }
  }
}

}  // namespace crossgrain
