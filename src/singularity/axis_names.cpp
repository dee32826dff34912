// SPDX-License-Identifier: Apache-2.0
#include "singularity/axis_names.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

/// Angle between neighbouring frames at which a path counts as twice its length, as the squared sine of its
/// half: about 10 degrees. Names should not pass next to a singular line, where the matching is uncertain.
constexpr double kTurn = 0.0076;

/// Rounds in which frames take the names that most of their neighbours give them: they straighten seams.
constexpr int kStraighteningRounds = 20;

constexpr std::array<AxisNames, 6> kAllNames{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

/// Where each axis of `from` continues in `to`.
AxisNames axes_through(const CubeRotation& matching) {
  const auto turned = axes_of(to_quaternion(matching));
  AxisNames axes{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::uint8_t j = 0; j < 3; ++j)
      if (std::abs(turned[k][j]) > 0.5) axes[k] = j;
  return axes;
}

AxisNames renamed(const AxisNames& names, const AxisNames& axes) {
  AxisNames out{};
  for (std::size_t k = 0; k < 3; ++k) out[axes[k]] = names[k];
  return out;
}

/// The links at each frame, both ways.
struct Neighbours {
  struct Link {
    std::uint32_t to;
    AxisNames axes;  ///< where each axis continues there
    double cost, width;
  };
  std::vector<std::uint32_t> begin;
  std::vector<Link> links;

  Neighbours(std::span<const Quaternion> frames, std::span<const FrameLink> given) {
    begin.assign(frames.size() + 1, 0);
    for (const FrameLink& link : given) ++begin[link.a + 1], ++begin[link.b + 1];
    for (std::size_t i = 0; i < frames.size(); ++i) begin[i + 1] += begin[i];
    links.resize(2 * given.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const FrameLink& link : given) {
      const Quaternion turn = conjugate(frames[link.b]) * frames[link.a];
      const CubeRotation matching = nearest_cube_rotation(turn);
      const double cosine = (conjugate(to_quaternion(matching)) * turn).w;
      const double cost = link.distance * (1 + std::max(1 - cosine * cosine, 0.0) / kTurn);
      links[next[link.a]++] = {link.b, axes_through(matching), cost, link.width};
      links[next[link.b]++] = {link.a, axes_through(inverse(matching)), cost, link.width};
    }
  }

  std::span<const Link> of(std::uint32_t i) const {
    return std::span(links).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

AxisNames names_by_coordinates(const Quaternion& frame) {
  const auto axes = axes_of(frame);
  AxisNames best = kAllNames[0];
  double most = -1;
  for (const AxisNames& names : kAllNames) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(axes[k][names[k]]);
    if (sum > most) most = sum, best = names;
  }
  return best;
}

/// Names everything that is linked to `start`, nearest first.
void spread(std::uint32_t start, const Neighbours& neighbours, std::vector<AxisNames>& names,
            std::vector<std::uint8_t>& is_named) {
  using Step = std::tuple<double, std::uint32_t, AxisNames>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
  steps.emplace(0, start, names[start]);
  while (!steps.empty()) {
    const auto [way, i, given] = steps.top();
    steps.pop();
    if (is_named[i]) continue;
    is_named[i] = 1;
    names[i] = given;
    for (const auto& link : neighbours.of(i))
      if (!is_named[link.to]) steps.emplace(way + link.cost, link.to, renamed(given, link.axes));
  }
}

/// Gives frames the names that their neighbours give them over the largest width.
class Straightening {
 public:
  Straightening(const Neighbours& neighbours, std::vector<AxisNames>& names)
      : neighbours_(neighbours), names_(names), is_due_(names.size(), 1) {}

  /// Visits all frames with a neighbour that has changed since the last visit, which are all at first.
  /// Returns whether any changed.
  bool round() {
    bool has_changed = false;
    for (std::uint32_t i = 0; i < names_.size(); ++i) {
      if (is_due_[i] == 0) continue;
      is_due_[i] = 0;
      const AxisNames chosen = chosen_for(i);
      if (chosen == names_[i]) continue;
      names_[i] = chosen;
      has_changed = true;
      for (const auto& link : neighbours_.of(i)) is_due_[link.to] = 1;
    }
    return has_changed;
  }

 private:
  static std::size_t number_of(const AxisNames& names) { return 3u * names[0] + names[1]; }

  AxisNames chosen_for(std::uint32_t i) const {
    std::array<double, 9> widths{};  // over which neighbours give these names, by their number
    for (const auto& [to, axes, cost, width] : neighbours_.of(i)) {
      const AxisNames& there = names_[to];
      widths[number_of({there[axes[0]], there[axes[1]], there[axes[2]]})] += width;
    }
    AxisNames chosen = names_[i];
    double most = widths[number_of(chosen)] * (1 + 1e-9);
    for (const AxisNames& other : kAllNames) {
      const double width = widths[number_of(other)];
      if (width <= most) continue;
      most = width * (1 + 1e-9);
      chosen = other;
    }
    return chosen;
  }

  const Neighbours& neighbours_;
  std::vector<AxisNames>& names_;
  std::vector<std::uint8_t> is_due_;
};

}  // namespace

AxisNames names_through(const AxisNames& names, const Quaternion& from, const Quaternion& to) {
  return renamed(names, axes_through(matching(from, to)));
}

std::vector<AxisNames> name_axes(std::span<const Quaternion> frames, std::span<const FrameLink> links,
                                 std::uint32_t start) {
  std::vector<AxisNames> names(frames.size());
  if (frames.empty()) return names;
  const Neighbours neighbours(frames, links);
  std::vector<std::uint8_t> is_named(frames.size(), 0);
  const auto begin_at = [&](std::uint32_t i) {
    if (is_named[i]) return;
    names[i] = names_by_coordinates(frames[i]);
    spread(i, neighbours, names, is_named);
  };
  begin_at(start);
  for (std::uint32_t i = 0; i < frames.size(); ++i) begin_at(i);
  Straightening straightening(neighbours, names);
  for (int round = 0; round < kStraighteningRounds && straightening.round(); ++round) {
  }
  return names;
}

std::vector<std::uint32_t> seams_of(std::span<const AxisNames> names, std::span<const Quaternion> frames,
                                    std::span<const FrameLink> links) {
  std::vector<std::uint32_t> seams;
  for (std::uint32_t k = 0; k < links.size(); ++k) {
    const auto& [a, b, distance, width] = links[k];
    if (names_through(names[a], frames[a], frames[b]) != names[b]) seams.push_back(k);
  }
  return seams;
}

}  // namespace crossgrain
