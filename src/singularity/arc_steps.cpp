// SPDX-License-Identifier: Apache-2.0
#include "singularity/arc_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace crossgrain {
namespace {

/// Number of edges on either side of a point whose axes are averaged: as for the direction of an arc.
constexpr std::ptrdiff_t kAveragedEdges = 2;

/// Rounds of power iteration. Axes that agree within 30 degrees leave a ratio of eigenvalues of at most 1/3,
/// of which the 32nd power is below rounding.
constexpr int kPowerRounds = 32;

/// sum w a a^T of axes: their mean as lines.
class MeanLine {
 public:
  void add(const Vector3& axis, double weight) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum_[i][j] += weight * axis[i] * axis[j];
  }

  /// The line nearest to all, found from a vector that is not across it.
  Vector3 direction(Vector3 start) const {
    for (int round = 0; round < kPowerRounds; ++round)
      start = normalised({dot(sum_[0], start), dot(sum_[1], start), dot(sum_[2], start)});
    return start;
  }

 private:
  std::array<Vector3, 3> sum_{};
};

template <class Visit>
void for_steps_near(std::span<const ArcStep> steps, std::size_t point, bool is_closed, const Visit& visit) {
  const auto count = static_cast<std::ptrdiff_t>(steps.size()), middle = static_cast<std::ptrdiff_t>(point);
  for (std::ptrdiff_t k = middle - kAveragedEdges; k < middle + kAveragedEdges; ++k) {
    if (is_closed)
      visit(steps[static_cast<std::size_t>((k % count + count) % count)]);
    else if (k >= 0 && k < count)
      visit(steps[static_cast<std::size_t>(k)]);
  }
}

/// The axis at a point, turned along the arc.
Vector3 axis_near(std::span<const ArcStep> steps, std::size_t point, bool is_closed) {
  MeanLine mean;
  Vector3 direction{0, 0, 0}, longest{0, 0, 0};
  double with_axis = 0, without = 0, length = 0;
  for_steps_near(steps, point, is_closed, [&](const ArcStep& step) {
    direction += step.direction;
    (step.turn.is_about_an_axis() ? with_axis : without) += step.length;
    if (!step.turn.is_about_an_axis()) return;
    mean.add(step.turn.axis, step.length);
    if (step.length > length) length = step.length, longest = step.turn.axis;
  });
  if (!(with_axis > without)) return {0, 0, 0};
  const Vector3 axis = mean.direction(longest);
  return dot(axis, direction) < 0 ? -axis : axis;
}

/// A part of an arc along which one sense lasts.
struct Part {
  bool is_positive;
  std::size_t first, last;  ///< steps
};

std::vector<Part> lasting_parts(std::span<const ArcStep> steps, const SingularityTuning& options) {
  std::vector<Part> parts;
  Part now{true, 0, 0};
  double cells = 0;
  const auto end_part = [&] {
    if (cells >= options.sign_cells) parts.push_back(now);
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double cosine = steps[k].cosine();
    if (!steps[k].turn.is_about_an_axis() || std::abs(cosine) < options.sign_cosine) continue;
    if (cells == 0 || (cosine > 0) != now.is_positive) {
      end_part();
      now = {cosine > 0, k, k};
      cells = 0;
    }
    now.last = k;
    cells += steps[k].cell_count;
  }
  end_part();
  return parts;
}

/// The point between two parts of different sense, as an index that may be beyond the end of a closed arc.
std::size_t point_between(std::span<const ArcStep> steps, const Part& before, const Part& after) {
  const std::size_t begin = before.last + 1;
  const std::size_t end = after.first + (after.first < begin ? steps.size() : 0);
  const double sense = before.is_positive ? 1 : -1;
  double sum = 0, best = 0;
  std::size_t point = begin;
  for (std::size_t k = begin; k < end; ++k) {
    const ArcStep& step = steps[k % steps.size()];
    if (step.turn.is_about_an_axis()) sum += sense * step.cosine() * step.length;
    if (sum > best) best = sum, point = k + 1;
  }
  return point;
}

}  // namespace

std::vector<Vector3> axes_along(std::span<const ArcStep> steps, bool is_closed) {
  std::vector<Vector3> axes;
  for (std::size_t point = 0; point <= steps.size(); ++point)
    axes.push_back(axis_near(steps, is_closed ? point % steps.size() : point, is_closed));
  return axes;
}

std::vector<std::uint32_t> turning_points(std::span<const ArcStep> steps, bool is_closed,
                                          const SingularityTuning& options) {
  const std::vector<Part> parts = lasting_parts(steps, options);
  std::vector<std::uint32_t> points;
  const auto add_between = [&](const Part& before, const Part& after) {
    if (before.is_positive == after.is_positive) return;
    const std::size_t point = point_between(steps, before, after);
    points.push_back(static_cast<std::uint32_t>(is_closed ? point % steps.size() : point));
  };
  for (std::size_t k = 1; k < parts.size(); ++k) add_between(parts[k - 1], parts[k]);
  if (is_closed && parts.size() > 1) add_between(parts.back(), parts.front());
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace crossgrain
