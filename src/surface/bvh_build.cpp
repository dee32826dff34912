// SPDX-License-Identifier: Apache-2.0
// Builds the tree: binned surface area heuristic, after Wald, "On fast construction of SAH-based bounding
// volume hierarchies" (2007). The two halves of a large node are built in parallel into separate arrays,
// which are then joined, so the result does not depend on the number of threads.
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

using Node = TriangleBvh::Node;

constexpr std::uint32_t kLeafTriangles = 4;
constexpr std::uint32_t kParallelTriangles = 8192;
constexpr std::size_t kBins = 16;

/// Below this depth nodes are halved by count, which bounds the stacks of the queries (2^32 triangles add 30
/// levels).
constexpr int kMostHeuristicDepth = 60;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kEmptyBox{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

void extend(Box& box, const Box& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], other.low[k]);
    box.high[k] = std::max(box.high[k], other.high[k]);
  }
}

double half_area(const Box& box) {
  const Vector3 size = box.high - box.low;
  return size[0] < 0 ? 0 : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

struct Bin {
  Box box = kEmptyBox;
  std::uint32_t count = 0;
};

struct Split {
  std::size_t axis = 0;
  std::size_t bin = 0;  ///< the first bin of the upper half
  double cost = kInfinity;
};

class Builder {
 public:
  Builder(const Surface& surface, std::vector<std::uint32_t>& order)
      : boxes_(surface.size()), centres_(surface.size()), order_(order) {
    parallel_for(surface.size(), [&](std::size_t t) {
      const auto corners = surface.corners(t);
      boxes_[t] = {corners[0], corners[0]};
      for (const Vector3& corner : corners) extend(boxes_[t], {corner, corner});
      centres_[t] = 0.5 * (boxes_[t].low + boxes_[t].high);
    });
  }

  /// Builds the subtree over order[first, first + count); its `skip` counts from its own first node.
  std::vector<Node> build(std::uint32_t first, std::uint32_t count, int depth) const {
    std::vector<Node> nodes;
    if (count < kParallelTriangles) {
      nodes.reserve(count);
      append_subtree(first, count, depth, nodes);
      return nodes;
    }
    const std::uint32_t lower = divide(first, count, depth);
    std::array<std::vector<Node>, 2> halves;
    parallel_for(
        2,
        [&](std::size_t upper) {
          halves[upper] =
              upper ? build(first + lower, count - lower, depth + 1) : build(first, lower, depth + 1);
        },
        1);
    nodes.reserve(1 + halves[0].size() + halves[1].size());
    nodes.push_back({box_of_range(first, count), 0, first, count});
    for (const auto& half : halves) {
      const auto offset = static_cast<std::uint32_t>(nodes.size());
      for (const Node& node : half) nodes.push_back({node.box, offset + node.skip, node.first, node.count});
    }
    nodes[0].skip = static_cast<std::uint32_t>(nodes.size());
    return nodes;
  }

 private:
  void append_subtree(std::uint32_t first, std::uint32_t count, int depth, std::vector<Node>& nodes) const {
    const std::size_t index = nodes.size();
    nodes.push_back({box_of_range(first, count), 0, first, count});
    if (count > kLeafTriangles) {
      const std::uint32_t lower = divide(first, count, depth);
      append_subtree(first, lower, depth + 1, nodes);
      append_subtree(first + lower, count - lower, depth + 1, nodes);
    }
    nodes[index].skip = static_cast<std::uint32_t>(nodes.size());
  }

  Box box_of_range(std::uint32_t first, std::uint32_t count) const {
    Box box = kEmptyBox;
    for (std::uint32_t i = first; i < first + count; ++i) extend(box, boxes_[order_[i]]);
    return box;
  }

  Box centre_box(std::uint32_t first, std::uint32_t count) const {
    Box box = kEmptyBox;
    for (std::uint32_t i = first; i < first + count; ++i)
      extend(box, {centres_[order_[i]], centres_[order_[i]]});
    return box;
  }

  static std::size_t bin_of(const Vector3& centre, const Box& centres, std::size_t axis) {
    const double position = (centre[axis] - centres.low[axis]) / (centres.high[axis] - centres.low[axis]);
    return std::min(kBins - 1, static_cast<std::size_t>(position * kBins));
  }

  Split best_split(std::uint32_t first, std::uint32_t count, const Box& centres, std::size_t axis) const {
    std::array<Bin, kBins> bins{};
    for (std::uint32_t i = first; i < first + count; ++i) {
      Bin& bin = bins[bin_of(centres_[order_[i]], centres, axis)];
      extend(bin.box, boxes_[order_[i]]);
      ++bin.count;
    }
    std::array<double, kBins> upper_cost{};
    Bin upper;
    for (std::size_t b = kBins - 1; b > 0; --b) {
      extend(upper.box, bins[b].box);
      upper.count += bins[b].count;
      upper_cost[b] = half_area(upper.box) * upper.count;
    }
    Split best;
    Bin lower;
    for (std::size_t b = 1; b < kBins; ++b) {
      extend(lower.box, bins[b - 1].box);
      lower.count += bins[b - 1].count;
      if (lower.count == 0 || lower.count == count) continue;
      const double cost = half_area(lower.box) * lower.count + upper_cost[b];
      if (cost < best.cost) best = {axis, b, cost};
    }
    return best;
  }

  /// Reorders order[first, first + count) into two halves and returns the size of the lower one, neither 0
  /// nor count.
  std::uint32_t divide(std::uint32_t first, std::uint32_t count, int depth) const {
    const Box centres = centre_box(first, count);
    Split best;
    for (std::size_t axis = 0; axis < 3 && depth < kMostHeuristicDepth; ++axis) {
      if (!(centres.low[axis] < centres.high[axis])) continue;
      const Split split = best_split(first, count, centres, axis);
      if (split.cost < best.cost) best = split;
    }
    if (best.cost == kInfinity) return count / 2;
    const auto begin = order_.begin() + first;
    const auto middle = std::partition(begin, begin + count, [&](std::uint32_t t) {
      return bin_of(centres_[t], centres, best.axis) < best.bin;
    });
    return static_cast<std::uint32_t>(middle - begin);
  }

  std::vector<Box> boxes_;
  std::vector<Vector3> centres_;
  std::vector<std::uint32_t>& order_;
};

}  // namespace

TriangleBvh::TriangleBvh(const Surface& surface) : surface_(&surface), triangle_order_(surface.size()) {
  std::iota(triangle_order_.begin(), triangle_order_.end(), 0u);
  nodes_ = Builder(surface, triangle_order_).build(0, static_cast<std::uint32_t>(surface.size()), 0);
}

}  // namespace crossgrain
