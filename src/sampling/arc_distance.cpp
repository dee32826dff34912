// SPDX-License-Identifier: Apache-2.0
#include "sampling/arc_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kLeafSegments = 4;

/// Enlargement of boxes, as a share of the size of all, and of the best distance below which boxes are
/// visited: far more than rounding, so that the result is the smallest computed distance to any segment,
/// whichever are visited.
constexpr double kMargin = 1e-12;

template <class Real>
Real larger(const Real& a, const Real& b) {
  return select(a > b, a, b);
}

/// A vector of in_every_lane of three numbers.
template <class Real>
BasicVector3<Real> vector_at(const double* x) {
  return {in_every_lane<Real>(x), in_every_lane<Real>(x + 1), in_every_lane<Real>(x + 2)};
}

}  // namespace

/// Builds the tree by halving the segments at the median of their centres, along the longest side.
class ArcDistance::Builder {
 public:
  Builder(std::vector<Segment> segments, ArcDistance& result)
      : segments_(std::move(segments)), result_(result) {
    const Box all = box_of_run(0, segments_.size());
    double size = longest_side(all);
    for (int axis = 0; axis < 3; ++axis) size = std::max({size, -all.low[axis], all.high[axis]});
    margin_ = kMargin * size;
  }

  void build() {
    add_node(0, segments_.size());
    for (const Segment& segment : segments_) {
      const Vector3 way = segment.end - segment.start;
      const double square = dot(way, way);
      add_row(result_.segments_, segment.start, way, square > 0 ? 1 / square : 0);
    }
    result_.boxes_.resize(result_.boxes_.size() + kRow);
    result_.segments_.resize(result_.segments_.size() + kRow);
  }

 private:
  static void add_row(std::vector<double>& rows, const Vector3& first, const Vector3& second, double last) {
    rows.insert(rows.end(), {first[0], first[1], first[2], second[0], second[1], second[2], last, 0});
  }

  Box box_of_run(std::size_t begin, std::size_t end) const {
    Box box = empty_box();
    for (std::size_t k = begin; k < end; ++k) {
      include(box, segments_[k].start);
      include(box, segments_[k].end);
    }
    return box;
  }

  void add_node(std::size_t begin, std::size_t end) {
    const Box box = box_of_run(begin, end);
    const Vector3 margin{margin_, margin_, margin_};
    const std::size_t node = result_.nodes_.size();
    result_.nodes_.push_back({0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)});
    add_row(result_.boxes_, box.low - margin, box.high + margin, 0);
    if (end - begin > kLeafSegments) {
      const Vector3 extent = box.high - box.low;
      const auto axis = static_cast<std::size_t>(std::ranges::max_element(extent) - extent.begin());
      const std::size_t middle = begin + (end - begin) / 2;
      const auto at = [&](std::size_t k) { return segments_.begin() + static_cast<std::ptrdiff_t>(k); };
      std::nth_element(at(begin), at(middle), at(end), [&](const Segment& a, const Segment& b) {
        return a.start[axis] + a.end[axis] < b.start[axis] + b.end[axis];
      });
      add_node(begin, middle);
      add_node(middle, end);
    }
    result_.nodes_[node].skip = static_cast<std::uint32_t>(result_.nodes_.size());
  }

  std::vector<Segment> segments_;
  ArcDistance& result_;
  double margin_ = 0;
};

/// Searches the nearest segments of as many points as Real has lanes.
template <class Real>
class ArcDistance::Search {
 public:
  explicit Search(const ArcDistance& tree) : tree_(tree) {}

  /// Distances of the points, at any distance from each other; `first` is the one in the first lane.
  Real distance(const BasicVector3<Real>& point, const Vector3& first) {
    using std::sqrt;
    best_ = std::numeric_limits<double>::infinity();
    // Starts with the last best segment and with the leaf that the nearest boxes lead to.
    visit_segment(point, hint_);
    visit_leaf(point, leaf_towards(first));
    for (std::uint32_t i = 0; i < tree_.nodes_.size();) {
      const Node& node = tree_.nodes_[i];
      if (!any(squared_distance_to_box(point, i) < best_ * Real(1 + kMargin))) {
        i = node.skip;
        continue;
      }
      if (node.skip == ++i) visit_leaf(point, i - 1);
    }
    return sqrt(best_);
  }

 private:
  template <class Number>
  Number squared_distance_to_box(const BasicVector3<Number>& point, std::uint32_t node) const {
    const double* const row = &tree_.boxes_[kRow * node];
    Number sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const Number off = larger(larger(Number(in_every_lane<Number>(row + axis) - point[axis]),
                                       Number(point[axis] - in_every_lane<Number>(row + 3 + axis))),
                                Number(0.0));
      sum += off * off;
    }
    return sum;
  }

  std::uint32_t leaf_towards(const Vector3& point) const {
    std::uint32_t node = 0;
    while (tree_.nodes_[node].skip != node + 1) {
      const std::uint32_t first = node + 1, second = tree_.nodes_[first].skip;
      node = squared_distance_to_box(point, second) < squared_distance_to_box(point, first) ? second : first;
    }
    return node;
  }

  void visit_leaf(const BasicVector3<Real>& point, std::uint32_t leaf) {
    const Node& node = tree_.nodes_[leaf];
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) visit_segment(point, k);
  }

  void visit_segment(const BasicVector3<Real>& point, std::uint32_t segment) {
    const double* const row = &tree_.segments_[kRow * segment];
    const BasicVector3<Real> off = point - vector_at<Real>(row), way = vector_at<Real>(row + 3);
    const Real share = dot(off, way) * in_every_lane<Real>(row + 6);
    const Real inside = select(share > 0.0, select(share > 1.0, Real(1.0), share), Real(0.0));
    const BasicVector3<Real> rest = off - inside * way;
    const Real squared_distance = dot(rest, rest);
    const auto is_nearer = squared_distance < best_;
    if (!any(is_nearer)) return;
    best_ = select(is_nearer, squared_distance, best_);
    hint_ = segment;
  }

  const ArcDistance& tree_;
  std::uint32_t hint_ = 0;
  Real best_ = 0.0;
};

ArcDistance::ArcDistance(std::span<const SingularityGraph::Arc> arcs) {
  std::vector<Segment> segments;
  for (const SingularityGraph::Arc& arc : arcs) {
    for (std::size_t k = 0; k + 1 < arc.points.size(); ++k)
      segments.push_back({arc.points[k], arc.points[k + 1]});
    if (arc.points.size() == 1) segments.push_back({arc.points[0], arc.points[0]});
  }
  if (!segments.empty()) Builder(std::move(segments), *this).build();
}

double ArcDistance::at(const Vector3& point) const {
  if (nodes_.empty()) return std::numeric_limits<double>::infinity();
  return Search<double>(*this).distance(point, point);
}

void ArcDistance::at(std::span<const Vector3> points, std::span<double> distances) const {
  if (nodes_.empty()) {
    std::ranges::fill(distances, std::numeric_limits<double>::infinity());
    return;
  }
  run_in_lanes([&]<int W>() {
    Search<Lanes<W>> search(*this);
    for (std::size_t begin = 0; begin < points.size(); begin += W) {
      const std::size_t count = std::min<std::size_t>(W, points.size() - begin);
      BasicVector3<Lanes<W>> point;
      for (std::size_t lane = 0; lane < W; ++lane)
        set_lane(point, static_cast<int>(lane), points[begin + std::min(lane, count - 1)]);
      const Lanes<W> result = search.distance(point, points[begin]);
      for (std::size_t lane = 0; lane < count; ++lane)
        distances[begin + lane] = result[static_cast<int>(lane)];
    }
  });
}

}  // namespace crossgrain
