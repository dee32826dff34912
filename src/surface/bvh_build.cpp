// SPDX-License-Identifier: Apache-2.0
// Builds the tree: binned surface area heuristic, after Wald, "On fast construction of SAH-based bounding
// volume hierarchies" (2007). The two halves of a large node are built in parallel, small ones into arrays of
// their own, which are joined at the end, so the result does not depend on the number of threads.
#include <algorithm>
#include <array>
#include <limits>
#include <span>

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
  explicit Builder(const Surface& surface) : items_(surface.size()) {
    parallel_for(surface.size(), [&](std::size_t t) {
      const auto corners = surface.corners(t);
      Item& item = items_[t];
      item = {{corners[0], corners[0]}, static_cast<std::uint32_t>(t)};
      for (const Vector3& corner : corners) extend(item.box, {corner, corner});
    });
  }

  /// Returns the nodes over all items.
  std::vector<Node> build() {
    const Part root = part_of(0, static_cast<std::uint32_t>(items_.size()), 0);
    auto nodes = sized_vector<Node>(root.size);
    place(root, 0, nodes);
    return nodes;
  }

  /// Returns the triangles in the order of the leaves.
  std::vector<std::uint32_t> order() const {
    std::vector<std::uint32_t> order(items_.size());
    parallel_for(order.size(), [&](std::size_t i) { order[i] = items_[i].triangle; });
    return order;
  }

 private:
  /// A triangle with its box, in one place, since the order of triangles soon has nothing to do with that of
  /// the tree.
  struct Item {
    Box box;
    std::uint32_t triangle;
  };

  /// A subtree: its own nodes if it is small, or two halves below a node.
  struct Part {
    std::uint32_t first, count;
    std::size_t size = 0;          ///< number of nodes
    std::vector<Node> nodes = {};  ///< `skip` counts from the first of them
    std::vector<Part> halves = {};
  };

  Part part_of(std::uint32_t first, std::uint32_t count, int depth) {
    Part part{first, count};
    if (count < kParallelTriangles) {
      part.nodes.reserve(count);
      append_subtree(first, count, depth, part.nodes);
      part.size = part.nodes.size();
      return part;
    }
    const std::uint32_t lower = divide(first, count, depth);
    part.halves.resize(2);
    parallel_for(
        2,
        [&](std::size_t upper) {
          part.halves[upper] =
              upper ? part_of(first + lower, count - lower, depth + 1) : part_of(first, lower, depth + 1);
        },
        1);
    part.size = 1 + part.halves[0].size + part.halves[1].size;
    return part;
  }

  /// Writes the nodes of a part from `begin` on.
  static void place(const Part& part, std::size_t begin, std::vector<Node>& nodes) {
    const auto offset = static_cast<std::uint32_t>(begin);
    if (part.halves.empty()) {
      for (std::size_t k = 0; k < part.size; ++k) {
        const Node& node = part.nodes[k];
        nodes[begin + k] = {node.box, offset + node.skip, node.first, node.count};
      }
      return;
    }
    const std::array<std::size_t, 2> begins{begin + 1, begin + 1 + part.halves[0].size};
    parallel_for(
        2, [&](std::size_t half) { place(part.halves[half], begins[half], nodes); }, 1);
    nodes[begin] = {nodes[begins[0]].box, offset + static_cast<std::uint32_t>(part.size), part.first,
                    part.count};
    extend(nodes[begin].box, nodes[begins[1]].box);
  }

  std::span<const Item> items(std::uint32_t first, std::uint32_t count) const {
    return std::span(items_).subspan(first, count);
  }

  static Vector3 centre_of(const Box& box) { return 0.5 * (box.low + box.high); }

  void append_subtree(std::uint32_t first, std::uint32_t count, int depth, std::vector<Node>& nodes) {
    const std::size_t index = nodes.size();
    nodes.push_back({kEmptyBox, 0, first, count});
    if (count > kLeafTriangles) {
      const std::uint32_t lower = divide(first, count, depth);
      append_subtree(first, lower, depth + 1, nodes);
      const std::size_t upper = nodes.size();
      append_subtree(first + lower, count - lower, depth + 1, nodes);
      extend(nodes[index].box, nodes[index + 1].box);
      extend(nodes[index].box, nodes[upper].box);
    } else {
      for (const Item& item : items(first, count)) extend(nodes[index].box, item.box);
    }
    nodes[index].skip = static_cast<std::uint32_t>(nodes.size());
  }

  static std::size_t bin_of(const Vector3& centre, const Box& centres, std::size_t axis) {
    const double position = (centre[axis] - centres.low[axis]) / (centres.high[axis] - centres.low[axis]);
    return std::min(kBins - 1, static_cast<std::size_t>(position * kBins));
  }

  static Split best_split(const std::array<Bin, kBins>& bins, std::uint32_t count, std::size_t axis) {
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

  Split best_split(std::span<const Item> items, const Box& centres) const {
    std::array<std::array<Bin, kBins>, 3> bins{};
    std::array<bool, 3> is_wide;
    for (std::size_t axis = 0; axis < 3; ++axis) is_wide[axis] = centres.low[axis] < centres.high[axis];
    for (const Item& item : items) {
      const Vector3 centre = centre_of(item.box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!is_wide[axis]) continue;
        Bin& bin = bins[axis][bin_of(centre, centres, axis)];
        extend(bin.box, item.box);
        ++bin.count;
      }
    }
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!is_wide[axis]) continue;
      const Split split = best_split(bins[axis], static_cast<std::uint32_t>(items.size()), axis);
      if (split.cost < best.cost) best = split;
    }
    return best;
  }

  /// Reorders the items [first, first + count) into two halves and returns the size of the lower one, neither
  /// 0 nor count.
  std::uint32_t divide(std::uint32_t first, std::uint32_t count, int depth) {
    if (depth >= kMostHeuristicDepth) return count / 2;
    Box centres = kEmptyBox;
    for (const Item& item : items(first, count)) extend(centres, {centre_of(item.box), centre_of(item.box)});
    const Split best = best_split(items(first, count), centres);
    if (best.cost == kInfinity) return count / 2;
    const auto begin = items_.begin() + first;
    const auto middle = std::partition(begin, begin + count, [&](const Item& item) {
      return bin_of(centre_of(item.box), centres, best.axis) < best.bin;
    });
    return static_cast<std::uint32_t>(middle - begin);
  }

  std::vector<Item> items_;
};

}  // namespace

TriangleBvh::TriangleBvh(const Surface& surface) : surface_(&surface) {
  Builder builder(surface);
  nodes_ = builder.build();
  triangle_order_ = builder.order();
}

}  // namespace crossgrain
