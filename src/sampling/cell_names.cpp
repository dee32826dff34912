// SPDX-License-Identifier: Apache-2.0
#include "sampling/cell_names.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "base/parallel.hpp"
#include "grid/merged_depth.hpp"

namespace crossgrain {
namespace {

/// Largest number of frames that are named one by one: they take a few hundredths of a second and megabytes.
constexpr std::size_t kMostNamed = 20000;

/// Groups of leaves: those in one cell of a coarse level, or a larger leaf.
struct LeafGroups {
  std::vector<std::uint32_t> of_leaf;
  std::vector<CellIndex> middle;  ///< for each group, the leaf nearest to its middle

  LeafGroups(const Octree& tree, int depth) : of_leaf(tree.size()) {
    double nearest = 0;
    for (CellIndex i = 0; i < tree.size(); ++i) {
      const CellAddress cell = tree[i].ancestor_at(depth);
      const double off = norm(tree.centre(i) - tree.root().centre(cell));
      if (i == 0 || cell != tree[i - 1].ancestor_at(depth)) {
        middle.push_back(i);
        nearest = off;
      } else if (off < nearest) {
        middle.back() = i;
        nearest = off;
      }
      of_leaf[i] = static_cast<std::uint32_t>(middle.size() - 1);
    }
  }
};

struct GroupFace {
  std::uint32_t a, b;
  double area;
  auto operator<=>(const GroupFace&) const = default;
};

/// The open faces from one leaf to leaves of other groups that are as large or larger, the same only across
/// high faces. Returns whether nothing is behind one of its faces.
bool add_faces(const LeafField& field, const LeafGroups& groups, CellIndex leaf,
               std::vector<GroupFace>& faces) {
  const Octree& tree = field.tree;
  bool is_outer = false;
  for (int face = 0; face < kFaceCount; ++face) {
    const auto across = adjacent(tree[leaf], face);
    const auto [first, last] = across ? field.finder.over(*across) : std::pair<CellIndex, CellIndex>{0, 0};
    is_outer = is_outer || first == last;
    if (last - first != 1 || tree[first].depth() > tree[leaf].depth()) continue;
    if (tree[first].depth() == tree[leaf].depth() && face_sign(face) < 0) continue;
    const std::uint32_t a = groups.of_leaf[leaf], b = groups.of_leaf[first];
    if (a == b || !joined(placed(field, leaf), placed(field, first))) continue;
    const double side = tree.cell_size(leaf);
    faces.push_back({std::min(a, b), std::max(a, b), side * side});
  }
  return is_outer;
}

std::vector<FrameLink> links_of(std::vector<GroupFace> faces, const std::vector<Vector3>& places) {
  std::sort(faces.begin(), faces.end());
  std::vector<FrameLink> links;
  for (const auto& [a, b, area] : faces) {
    if (!links.empty() && links.back().a == a && links.back().b == b)
      links.back().width += area;
    else
      links.push_back({a, b, norm(places[b] - places[a]), area});
  }
  return links;
}

}  // namespace

CellNames::CellNames(std::vector<Quaternion> frames, std::span<const FrameLink> links,
                     std::span<const std::uint8_t> is_outer, std::vector<std::uint32_t> named_by)
    : frames_(std::move(frames)), named_by_(std::move(named_by)) {
  if (frames_.empty()) return;
  names_ = name_axes(frames_, links, deepest_inside(links, is_outer));
}

CellNames cell_names(const LeafField& field, std::span<const std::uint8_t> on_boundary) {
  const Octree& tree = field.tree;
  if (tree.size() == 0) return CellNames({}, {}, {});
  LeafGroups groups(tree, merged_depth(tree, kMostNamed));
  std::vector<std::uint8_t> is_outer(groups.middle.size(), 0);
  std::vector<GroupFace> faces;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const bool ends = add_faces(field, groups, i, faces);
    if (ends || on_boundary[i]) is_outer[groups.of_leaf[i]] = 1;
  }
  std::vector<Quaternion> frames;
  std::vector<Vector3> places;
  for (const CellIndex leaf : groups.middle) {
    frames.push_back(from_stored(field.frames[leaf]));
    places.push_back(tree.centre(leaf));
  }
  return CellNames(std::move(frames), links_of(std::move(faces), places), is_outer,
                   std::move(groups.of_leaf));
}

std::uint32_t deepest_inside(std::span<const FrameLink> links, std::span<const std::uint8_t> is_outer) {
  std::vector<std::vector<std::pair<std::uint32_t, double>>> linked(is_outer.size());
  for (const FrameLink& link : links) {
    linked[link.a].emplace_back(link.b, link.distance);
    linked[link.b].emplace_back(link.a, link.distance);
  }
  std::vector<double> depth(is_outer.size(), std::numeric_limits<double>::infinity());
  using Step = std::pair<double, std::uint32_t>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
  const auto reach = [&](std::uint32_t i, double way) {
    if (!(way < depth[i])) return;
    depth[i] = way;
    steps.emplace(way, i);
  };
  for (std::uint32_t i = 0; i < is_outer.size(); ++i)
    if (is_outer[i]) reach(i, 0);
  std::uint32_t deepest = 0;
  double most = -1;
  while (!steps.empty()) {
    const auto [way, i] = steps.top();
    steps.pop();
    if (way > depth[i]) continue;
    if (way > most) {
      most = way;
      deepest = i;
    }
    for (const auto& [next, length] : linked[i]) reach(next, way + length);
  }
  return deepest;
}

}  // namespace crossgrain
