// SPDX-License-Identifier: Apache-2.0
#include "surface/self_intersections.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/boxes.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/triangle_pairs.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<Vector3, 3>;
using PartPair = std::pair<std::uint32_t, std::uint32_t>;

/// Relative to the largest coordinate; single-precision files round by 6e-8.
constexpr double kTolerance = 2.5e-7;

/// Maximum number of pairs of triangles tested, per triangle and in addition, before counting stops. A smooth
/// surface needs about 50 per triangle.
constexpr std::size_t kPairsPerTriangle = 150, kPairsBesides = 4000000;

/// Maximum number of pairs tested for one leaf.
constexpr std::size_t kPairsPerLeaf = 8192;

/// Maximum number of triangles in a leaf of the tree.
constexpr std::size_t kMostInLeaf = 4;

/// Nodes of the tree per task, and per check of the number of tests done by all tasks.
constexpr std::size_t kNodesPerTask = 64, kNodesPerRound = 1024;

/// With more parts than this, containment of parts in others is not tested.
constexpr std::size_t kMostParts = 10000;

struct PartMeeting {
  PartPair parts;
  bool crosses;
  Vector3 place;
};

/// Results of a run of leaves.
struct Found {
  std::size_t crossings = 0, pairs = 0;
  Vector3 first_crossing{};
  bool cut_short = false;
  std::vector<PartMeeting> meetings;

  void add_crossing(const Vector3& place) {
    if (crossings++ == 0) first_crossing = place;
  }
  /// One of each kind is enough for each pair of parts.
  void add_meeting(const PartMeeting& meeting) {
    for (const PartMeeting& m : meetings)
      if (m.parts == meeting.parts && m.crosses == meeting.crosses) return;
    meetings.push_back(meeting);
  }
  void add(const Found& other) {
    if (crossings == 0) first_crossing = other.first_crossing;
    crossings += other.crossings;
    pairs += other.pairs;
    cut_short |= other.cut_short;
    meetings.insert(meetings.end(), other.meetings.begin(), other.meetings.end());
  }
};

Box box_of_corners(const Corners& c, double margin) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min({c[0][k], c[1][k], c[2][k]}) - margin;
    box.high[k] = std::max({c[0][k], c[1][k], c[2][k]}) + margin;
  }
  return box;
}

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
  return largest;
}

class PairFinder {
 public:
  PairFinder(const MendedSurface& mended, const TriangleBvh& bvh)
      : mended_(mended),
        surface_(mended.surface),
        nodes_(bvh.nodes()),
        order_(bvh.triangle_order()),
        tolerance_(kTolerance * largest_coordinate(mended.surface.box)) {}

  Found find() const {
    Found all;
    const std::size_t most_pairs = kPairsPerTriangle * surface_.size() + kPairsBesides;
    for (std::size_t begin = 0; begin < nodes_.size(); begin += kNodesPerRound) {
      const std::size_t count = std::min(kNodesPerRound, nodes_.size() - begin);
      std::vector<Found> found((count + kNodesPerTask - 1) / kNodesPerTask);
      parallel_for_chunks(count, kNodesPerTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          look_from(static_cast<std::uint32_t>(begin + i), found[first / kNodesPerTask]);
      });
      for (const Found& part : found) all.add(part);
      if (all.crossings < kMostCrossings && all.pairs < most_pairs) continue;
      all.cut_short |= begin + count < nodes_.size();
      break;
    }
    return all;
  }

 private:
  struct Side {
    std::uint32_t triangle;
    Corners corners;
    Box box;
  };

  Side side_of(std::uint32_t place, double margin) const {
    const std::uint32_t triangle = order_[place];
    const Corners corners = surface_.corners(triangle);
    return {triangle, corners, box_of_corners(corners, margin)};
  }

  /// Tests pairs of the triangles of a leaf with each other and with those of later leaves.
  void look_from(std::uint32_t leaf, Found& found) const {
    const TriangleBvh::Node& node = nodes_[leaf];
    if (node.skip != leaf + 1) return;
    std::array<Side, kMostInLeaf> sides;
    assert(node.count <= sides.size());
    for (std::uint32_t k = 0; k < node.count; ++k) sides[k] = side_of(node.first + k, tolerance_);
    const std::span<const Side> own(sides.data(), node.count);
    for (std::size_t k = 0; k < own.size(); ++k)
      for (std::size_t m = 0; m < k; ++m) look_at_pair(own[m], own[k], found);

    std::size_t pairs = 0;
    const Vector3 margin{tolerance_, tolerance_, tolerance_};
    const Box box{node.box.low - margin, node.box.high + margin};
    for (std::uint32_t i = leaf + 1; i < nodes_.size() && pairs < kPairsPerLeaf;) {
      const TriangleBvh::Node& other = nodes_[i];
      if (!boxes_meet(box, other.box)) {
        i = other.skip;
      } else if (other.skip == ++i) {
        look_at_leaf(own, other, found);
        pairs += own.size() * other.count;
      }
    }
    found.pairs += pairs;
    found.cut_short |= pairs >= kPairsPerLeaf;
  }

  void look_at_leaf(std::span<const Side> own, const TriangleBvh::Node& leaf, Found& found) const {
    for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place) {
      const Side other = side_of(place, 0);
      for (const Side& side : own)
        if (boxes_meet(side.box, other.box)) look_at_pair(side, other, found);
    }
  }

  void look_at_pair(const Side& a, const Side& b, Found& found) const {
    const auto crossing = crossing_of(a.corners, surface_.normals[a.triangle], b.corners,
                                      surface_.normals[b.triangle], tolerance_);
    const std::uint32_t a_part = part_of(a.triangle), b_part = part_of(b.triangle);
    if (a_part == b_part || a_part == kNoPart || b_part == kNoPart) {
      if (crossing && !are_of_two_solids(a.triangle, b.triangle)) found.add_crossing(*crossing);
      return;
    }
    const PartPair parts = std::minmax(a_part, b_part);
    if (crossing) {
      found.add_meeting({parts, true, *crossing});
    } else if (const auto place = near_point(a.corners, b.corners, tolerance_)) {
      found.add_meeting({parts, false, *place});
    }
  }

  bool are_of_two_solids(std::uint32_t a, std::uint32_t b) const {
    const std::vector<std::int32_t>& solids = surface_.mesh.solids;
    return !solids.empty() && solids[a] != solids[b];
  }

  std::uint32_t part_of(std::uint32_t triangle) const {
    return mended_.part_of.empty() ? kNoPart : mended_.part_of[triangle];
  }

  const MendedSurface& mended_;
  const Surface& surface_;
  const std::vector<TriangleBvh::Node>& nodes_;
  const std::vector<std::uint32_t>& order_;
  double tolerance_;
};

/// Keeps one contact per pair of parts, preferably a crossing.
std::vector<PartMeeting> distinct_meetings(std::vector<PartMeeting> meetings) {
  std::stable_sort(meetings.begin(), meetings.end(), [](const PartMeeting& a, const PartMeeting& b) {
    return std::pair(a.parts, !a.crosses) < std::pair(b.parts, !b.crosses);
  });
  const auto end = std::unique(meetings.begin(), meetings.end(),
                               [](const PartMeeting& a, const PartMeeting& b) { return a.parts == b.parts; });
  meetings.erase(end, meetings.end());
  return meetings;
}

/// What a part's box has in common with the inside of another one's; none if that is nothing.
std::optional<Box> common_box(const Box& own, const Box& other, double margin) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(own.low[axis] - margin, other.low[axis] + margin);
    box.high[axis] = std::min(own.high[axis] + margin, other.high[axis] - margin);
    if (!(box.low[axis] < box.high[axis])) return std::nullopt;
  }
  return box;
}

/// Whether a triangle of a part is inside another one: the winding number is more than 1 on both sides.
bool is_buried(const Surface& surface, std::uint32_t triangle, const WindingNumber& winding) {
  const auto [a, b, c] = surface.corners(triangle);
  const Vector3 centre = (1.0 / 3) * (a + b + c);
  const Vector3 off = 1e-4 * std::sqrt(surface.areas[triangle]) * surface.normals[triangle];
  return winding.at(centre + off) + winding.at(centre - off) > 2.5;
}

std::vector<Box> boxes_of_parts(const MendedSurface& mended) {
  std::vector<Box> boxes(mended.parts, empty_box());
  for (std::uint32_t t = 0; t < mended.surface.size(); ++t)
    if (mended.part_of[t] != kNoPart)
      for (const Vector3& corner : mended.surface.corners(t)) include(boxes[mended.part_of[t]], corner);
  return boxes;
}

/// Makes meetings overlaps of parts that reach into each other, although no triangles cross where their sides
/// are in common planes. Of parts that cross others it is not known which they reach into.
void find_parts_in_each_other(const MendedSurface& mended, const WindingNumber& winding,
                              std::vector<PartMeeting>& meetings) {
  if (mended.parts > kMostParts) return;
  const Surface& surface = mended.surface;
  const double margin = kTolerance * largest_coordinate(surface.box);
  const std::vector<Box> boxes = boxes_of_parts(mended);
  std::vector<bool> crosses(mended.parts);
  for (const PartMeeting& meeting : meetings)
    if (meeting.crosses) crosses[meeting.parts.first] = crosses[meeting.parts.second] = true;
  // What two parts may have in common, by the meetings of each part; and of all its meetings.
  std::vector<std::vector<std::pair<std::size_t, Box>>> common(mended.parts);
  std::vector<Box> of_part(mended.parts, empty_box());
  for (std::size_t k = 0; k < meetings.size(); ++k) {
    const auto& [first, second] = meetings[k].parts;
    if (crosses[first] || crosses[second]) continue;
    for (const auto& [part, other] : {std::pair(first, second), std::pair(second, first)})
      if (const std::optional<Box> box = common_box(boxes[part], boxes[other], margin)) {
        common[part].emplace_back(k, *box);
        include(of_part[part], box->low);
        include(of_part[part], box->high);
      }
  }
  Checkpoint checkpoint;
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    checkpoint.pass();
    const std::uint32_t part = mended.part_of[t];
    if (part == kNoPart || common[part].empty()) continue;
    const auto [a, b, c] = surface.corners(t);
    const Vector3 centre = (1.0 / 3) * (a + b + c);
    if (!contains(of_part[part], centre) || !is_buried(surface, t, winding)) continue;
    for (const auto& [k, box] : common[part])
      if (!meetings[k].crosses && contains(box, centre)) {
        meetings[k].crosses = true;
        meetings[k].place = centre;
      }
  }
}

/// Finds parts inside the solid that cross no other part and are no voids.
void add_buried_parts(const MendedSurface& mended, const WindingNumber& winding,
                      const std::vector<PartMeeting>& meetings, Tally& overlapping) {
  if (mended.part_of.empty() || mended.parts > kMostParts) return;
  std::vector<bool> asked(mended.parts);
  for (const PartMeeting& meeting : meetings)
    if (meeting.crosses) asked[meeting.parts.first] = asked[meeting.parts.second] = true;
  const Surface& surface = mended.surface;
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    const std::uint32_t part = mended.part_of[t];
    if (part == kNoPart || asked[part]) continue;
    asked[part] = true;
    const auto [a, b, c] = surface.corners(t);
    if (is_buried(surface, t, winding)) overlapping.add((1.0 / 3) * (a + b + c));
  }
}

}  // namespace

void find_self_intersections(const MendedSurface& mended, const TriangleBvh& bvh,
                             const WindingNumber& winding, SurfaceFindings& findings) {
  const Found found = PairFinder(mended, bvh).find();
  if (found.crossings > 0) {
    findings.push_back(
        {FindingKind::kSelfIntersection, found.crossings, found.first_crossing, {}, found.cut_short});
  }
  std::vector<PartMeeting> meetings = distinct_meetings(found.meetings);
  if (std::ranges::any_of(meetings, [](const PartMeeting& meeting) { return !meeting.crosses; }))
    find_parts_in_each_other(mended, winding, meetings);
  Tally overlapping, touching;
  for (const PartMeeting& meeting : meetings) (meeting.crosses ? overlapping : touching).add(meeting.place);
  add_buried_parts(mended, winding, meetings, overlapping);
  overlapping.report(findings, FindingKind::kOverlappingComponents);
  touching.report(findings, FindingKind::kTouchingComponents);
}

}  // namespace crossgrain
