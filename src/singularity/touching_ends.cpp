// SPDX-License-Identifier: Apache-2.0
#include "singularity/touching_ends.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/ascending.hpp"
#include "base/disjoint_sets.hpp"

namespace crossgrain {
namespace {

/// How far around two ends leaves may lead from one to the other, in cells.
constexpr int kDetour = 2;

/// The leaves in a box around two ends of lines.
class LeavesNear {
 public:
  LeavesNear(const Octree& tree, const SingularEdges::Point& a, const SingularEdges::Point& b) : tree_(tree) {
    // Beside the cells of the lines there may be some of half their size.
    const double step = std::min(a.cell_size, b.cell_size) / 2;
    std::array<int, 3> counts{};
    Vector3 low{};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(a.place[axis], b.place[axis]) - 2 * kDetour * step;
      counts[axis] =
          static_cast<int>(std::lround(std::abs(a.place[axis] - b.place[axis]) / step)) + 4 * kDetour;
    }
    for (int x = 0; x < counts[0]; ++x)
      for (int y = 0; y < counts[1]; ++y)
        for (int z = 0; z < counts[2]; ++z) add(low + step * Vector3{x + 0.5, y + 0.5, z + 0.5});
    sort_uniquely(leaves_);
  }

  /// The leaves, ascending.
  const std::vector<CellIndex>& leaves() const { return leaves_; }

  /// Whether a way through open faces, within the box, leads from a leaf at one end to one at the other.
  bool join(const SingularEdges::Point& a, const SingularEdges::Point& b,
            std::span<const std::uint8_t> open_faces) const {
    DisjointSets sets(leaves_.size());
    for (std::uint32_t k = 0; k < leaves_.size(); ++k) {
      for (int face = 0; face < kFaceCount; ++face) {
        if (!(open_faces[leaves_[k]] >> face & 1)) continue;
        const auto other = std::ranges::lower_bound(leaves_, tree_.neighbour(leaves_[k], face));
        if (other != leaves_.end() && *other == tree_.neighbour(leaves_[k], face))
          sets.join(k, static_cast<std::uint32_t>(other - leaves_.begin()));
      }
    }
    for (std::uint32_t k = 0; k < leaves_.size(); ++k) {
      if (!touches(k, a)) continue;
      for (std::uint32_t other = 0; other < leaves_.size(); ++other)
        if (sets.root(other) == sets.root(k) && touches(other, b)) return true;
    }
    return false;
  }

 private:
  void add(const Vector3& place) {
    const std::optional<CellAddress> cell = tree_.root().locate(place);
    const CellIndex leaf = cell ? tree_.find_containing(*cell) : kNoCell;
    if (leaf != kNoCell) leaves_.push_back(leaf);
  }

  bool touches(std::uint32_t k, const SingularEdges::Point& end) const {
    const Box box = tree_.root().box(tree_[leaves_[k]]);
    const double rounding = 1e-6 * end.cell_size;
    for (int axis = 0; axis < 3; ++axis) {
      if (end.place[axis] < box.low[axis] - rounding || end.place[axis] > box.high[axis] + rounding)
        return false;
    }
    return true;
  }

  const Octree& tree_;
  std::vector<CellIndex> leaves_;
};

/// Two ends of lines and how far apart they are, in cells.
struct PairOfEnds {
  double cells;
  std::uint32_t a, b;
  auto operator<=>(const PairOfEnds&) const = default;
};

/// Returns the pairs of ends at most kTouchCells apart.
std::vector<PairOfEnds> near_pairs(const SingularEdges& singular) {
  std::vector<std::uint32_t> degrees(singular.points.size(), 0), ends;
  for (const SingularEdge& edge : singular.edges)
    for (const std::uint32_t end : edge.ends) ++degrees[end];
  double largest = 0;
  for (std::uint32_t p = 0; p < degrees.size(); ++p) {
    if (degrees[p] != 1) continue;
    ends.push_back(p);
    largest = std::max(largest, singular.points[p].cell_size);
  }
  const auto place = [&](std::uint32_t p) -> const Vector3& { return singular.points[p].place; };
  std::ranges::sort(ends, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(place(a)[0], a) < std::pair(place(b)[0], b);
  });
  std::vector<PairOfEnds> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const auto [a, b] = std::minmax(ends[i], ends[j]);
      if (place(ends[j])[0] - place(ends[i])[0] > kTouchCells * largest) break;
      const SingularEdges::Point &from = singular.points[a], &to = singular.points[b];
      const double cells = 2 * norm(to.place - from.place) / (from.cell_size + to.cell_size);
      if (cells <= kTouchCells) pairs.push_back({cells, a, b});
    }
  }
  return pairs;
}

struct OpenLeaf {
  CellAddress address;
  std::uint8_t open_faces;
};

/// Returns the leaves of all processes around the pairs, in the order of their addresses.
std::vector<OpenLeaf> leaves_around(std::span<const PairOfEnds> pairs, const SingularEdges& singular,
                                    const Octree& tree, std::span<const std::uint8_t> open_faces,
                                    const Share& share) {
  std::vector<CellIndex> own;
  for (const PairOfEnds& pair : pairs) {
    const LeavesNear near(tree, singular.points[pair.a], singular.points[pair.b]);
    std::copy_if(near.leaves().begin(), near.leaves().end(), std::back_inserter(own),
                 [&](CellIndex leaf) { return share.owns(leaf); });
  }
  sort_uniquely(own);
  std::vector<OpenLeaf> leaves;
  for (const CellIndex leaf : own) leaves.push_back({tree[leaf], open_faces[leaf]});
  return gathered_values<OpenLeaf>(*share.exchange, leaves);
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> touching_ends(const SingularEdges& singular, const Octree& tree,
                                                        std::span<const std::uint8_t> open_faces,
                                                        const Share& part) {
  std::vector<PairOfEnds> pairs = near_pairs(singular);
  if (!part.is_whole()) {
    const auto leaves = leaves_around(pairs, singular, tree, open_faces, part);
    std::vector<CellAddress> addresses;
    std::vector<std::uint8_t> faces;
    for (const OpenLeaf& leaf : leaves) {
      addresses.push_back(leaf.address);
      faces.push_back(leaf.open_faces);
    }
    return touching_ends(singular, Octree(tree.root(), std::move(addresses)), faces);
  }
  std::erase_if(pairs, [&](const PairOfEnds& pair) {
    const SingularEdges::Point &a = singular.points[pair.a], &b = singular.points[pair.b];
    return !LeavesNear(tree, a, b).join(a, b, open_faces);
  });
  std::ranges::sort(pairs);
  std::vector<std::array<std::uint32_t, 2>> result;
  for (const PairOfEnds& pair : pairs) result.push_back({pair.a, pair.b});
  return result;
}

}  // namespace crossgrain
