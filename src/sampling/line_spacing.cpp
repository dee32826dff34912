// SPDX-License-Identifier: Apache-2.0
#include "sampling/line_spacing.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Cosine of 45 degrees: lines at smaller angles are along like axes.
constexpr double kLikeCosine = 0.7071067811865476;

/// Distance between samples along a line, in spacings: those of a straight line are off by at most 1 / 32 of
/// half the spacing.
constexpr double kSampleSpacing = 0.25;

/// Distance at which lines end, in spacings: less than that of seeds, so that most lines stay whole.
constexpr double kEndSpacing = 0.5;

using Cube = std::array<std::int64_t, 3>;

Cube cube_of(const Vector3& point, double side) {
  Cube cube;
  for (std::size_t k = 0; k < 3; ++k) cube[k] = static_cast<std::int64_t>(std::floor(point[k] / side));
  return cube;
}

/// Far cubes may share a key.
std::uint64_t key_of(const Cube& cube) {
  constexpr std::int64_t kMask = (std::int64_t{1} << 21) - 1;
  std::uint64_t key = 0;
  for (const std::int64_t x : cube) key = key << 21 | static_cast<std::uint64_t>(x & kMask);
  return key;
}

}  // namespace

bool LineSpacing::is_near(const Sample& of, double distance, bool is_closed) const {
  const Cube middle = cube_of(of.point, spacing_);
  for (int number = 0; number < 27; ++number) {
    const Cube cube{middle[0] + number % 3 - 1, middle[1] + number / 3 % 3 - 1, middle[2] + number / 9 - 1};
    const auto found = at_.find(key_of(cube));
    if (found == at_.end()) continue;
    for (const std::uint32_t k : found->second) {
      const Sample& other = samples_[k];
      if (other.line == of.line && (is_closed || std::abs(other.along - of.along) <= spacing_)) continue;
      if (std::abs(dot(other.direction, of.direction)) < kLikeCosine) continue;
      if (norm(other.point - of.point) < distance) return true;
    }
  }
  return false;
}

bool LineSpacing::has_room(const Vector3& point, const Vector3& direction) const {
  return !is_near({point, direction, lines_, 0}, spacing_);
}

void LineSpacing::remember(const Sample& sample) {
  at_[key_of(cube_of(sample.point, spacing_))].push_back(static_cast<std::uint32_t>(samples_.size()));
  samples_.push_back(sample);
}

void LineSpacing::forget_from(std::size_t first) {
  for (; samples_.size() > first; samples_.pop_back())
    at_[key_of(cube_of(samples_.back().point, spacing_))].pop_back();
}

LineSpacing::End LineSpacing::follow(const Streamline& line, int step) {
  const bool is_closed = line.last_end == StreamlineEnd::kClosed;
  const std::size_t last = step > 0 ? line.points.size() - 1 : 0;
  double along = 0;
  for (std::size_t i = line.seed_point; i != last;) {
    const std::size_t next = step > 0 ? i + 1 : i - 1;
    const Vector3 way = line.points[next] - line.points[i], bend = line.tangents[next] - line.tangents[i];
    const double parts = std::max(1.0, std::ceil(norm(way) / (kSampleSpacing * spacing_)));
    for (double part = 1; part <= parts; ++part) {
      along += step * norm(way) / parts;
      const Sample sample{line.points[i] + part / parts * way,
                          normalised(line.tangents[i] + part / parts * bend), lines_, along};
      if (is_near(sample, kEndSpacing * spacing_, is_closed)) return {i, sample};
      remember(sample);
    }
    i = next;
  }
  return {last};
}

bool LineSpacing::take(Streamline& line) {
  const Vector3 seed = line.points[line.seed_point], direction = line.tangents[line.seed_point];
  if (!has_room(seed, direction)) return false;
  const std::size_t before = samples_.size();
  remember({seed, direction, lines_, 0});
  const End last = follow(line, 1), first = follow(line, -1);
  Streamline kept;
  const auto add = [&](const Vector3& point, const Vector3& tangent) {
    if (!kept.points.empty()) kept.length += norm(point - kept.points.back());
    kept.points.push_back(point);
    kept.tangents.push_back(tangent);
  };
  if (first.cut) add(first.cut->point, first.cut->direction);
  for (std::size_t i = first.point; i <= last.point; ++i) {
    if (i == line.seed_point) kept.seed_point = kept.points.size();
    add(line.points[i], line.tangents[i]);
  }
  if (last.cut) add(last.cut->point, last.cut->direction);
  kept.first_end = first.cut ? StreamlineEnd::kCrowded : line.first_end;
  kept.last_end = last.cut ? StreamlineEnd::kCrowded : line.last_end;
  if ((first.cut || last.cut) && kept.length < spacing_) {
    forget_from(before);
    return false;
  }
  kept.seed = line.seed;
  kept.axis = line.axis;
  line = std::move(kept);
  ++lines_;
  return true;
}

}  // namespace crossgrain
