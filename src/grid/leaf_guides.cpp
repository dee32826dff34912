// SPDX-License-Identifier: Apache-2.0
#include "grid/leaf_guides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"
#include "grid/point_guides.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kLeavesPerBegin = 256;

/// Number of segments or faces that one task processes.
constexpr std::size_t kGuideGrain = 64;

/// Distance, in finest cells, by which a walk goes beyond a face to be certainly in the next leaf.
constexpr double kPastFace = 1e-6;

/// The part of a segment in one leaf, as fractions of the segment's length.
struct Passage {
  CellIndex leaf;
  double from, to;
};

/// Follows segments from leaf to leaf.
class SegmentWalker {
 public:
  SegmentWalker(const Octree& tree, double finest)
      : tree_(tree), finder_(tree), finest_(finest > 0 ? finest : tree.root().size) {
    for (CellIndex i = 0; i < tree.size(); ++i) finest_ = std::min(finest_, tree.cell_size(i));
  }

  CellIndex leaf_at(const Vector3& point) const {
    const auto address = tree_.root().locate(point);
    return address ? finder_.containing(*address) : kNoCell;
  }

  /// Appends the leaves that a segment passes through. A segment without length passes through its leaf from
  /// 0 to 1.
  void walk(const GuideSegment& segment, std::vector<Passage>& passages) const {
    const auto& [a, b] = segment.ends;
    const Vector3 along = b - a;
    const double length = norm(along);
    if (length == 0) {
      const CellIndex leaf = leaf_at(a);
      if (leaf != kNoCell) passages.push_back({leaf, 0, 1});
      return;
    }
    // Most of the segment may lie outside the root cube.
    const ClippedSegment part = clip_segment(segment.ends, tree_.root().box(CellAddress::root()));
    if (part.empty()) return;
    const double past = kPastFace * finest_ / length;
    for (double t = part.from; t < part.to;) {
      const Vector3 here = a + std::min(1.0, t + past) * along;
      const CellIndex leaf = leaf_at(here);
      const double end =
          leaving(leaf == kNoCell ? finest_cell_around(here) : tree_.root().box(tree_[leaf]), a, along);
      const double to = std::min(part.to, std::max(end, t + 2 * past));
      if (leaf != kNoCell) passages.push_back({leaf, t, to});
      t = to;
    }
  }

 private:
  /// Returns the box of the finest possible cell at a point that is in no leaf.
  Box finest_cell_around(const Vector3& point) const {
    Box box;
    for (int k = 0; k < 3; ++k) {
      const double origin = tree_.root().origin[k];
      box.low[k] = origin + std::floor((point[k] - origin) / finest_) * finest_;
      box.high[k] = box.low[k] + finest_;
    }
    return box;
  }

  /// Returns the t at which a + t along leaves the box.
  static double leaving(const Box& box, const Vector3& a, const Vector3& along) {
    double t = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      if (along[k] > 0) t = std::min(t, (box.high[k] - a[k]) / along[k]);
      if (along[k] < 0) t = std::min(t, (box.low[k] - a[k]) / along[k]);
    }
    return t;
  }

  const Octree& tree_;
  LeafFinder finder_;
  double finest_;
};

Vector3 direction_at(const GuideSegment& segment, double t) {
  const auto& [first, last] = segment.directions;
  const double sign = dot(first, last) < 0 ? -1 : 1;
  const Vector3 direction = normalised((1 - t) * first + (sign * t) * last);
  return direction == Vector3{0, 0, 0} ? first : direction;
}

LeafGuide guide_of(const Octree& tree, const GuideSegment& segment, const Passage& passage) {
  const double length = norm(segment.ends[1] - segment.ends[0]);
  const double cell = tree.cell_size(passage.leaf);
  const double within = length == 0 ? cell : (passage.to - passage.from) * length;
  return LeafGuide::rounded(passage.leaf, direction_at(segment, 0.5 * (passage.from + passage.to)),
                            segment.weight * within * cell);
}

/// Returns the guides that `add_pieces(k, pieces)` appends for each k below `count`, in the order of k.
template <class AddPieces>
std::vector<std::vector<LeafGuide>> in_runs(std::size_t count, const AddPieces& add_pieces) {
  std::vector<std::vector<LeafGuide>> runs((count + kGuideGrain - 1) / kGuideGrain);
  parallel_for_chunks(count, kGuideGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) add_pieces(k, runs[begin / kGuideGrain]);
  });
  return runs;
}

void append(std::vector<LeafGuide>& guides, const std::vector<std::vector<LeafGuide>>& runs) {
  for (const auto& run : runs) guides.insert(guides.end(), run.begin(), run.end());
}

/// Returns the guides of segments, except in the leaves `left_out`, which are sorted.
std::vector<std::vector<LeafGuide>> along_segments(const Octree& tree, const SegmentWalker& walker,
                                                   const std::vector<GuideSegment>& segments,
                                                   const std::vector<CellIndex>& left_out) {
  return in_runs(segments.size(), [&](std::size_t s, std::vector<LeafGuide>& pieces) {
    std::vector<Passage> passages;
    walker.walk(segments[s], passages);
    for (const Passage& passage : passages) {
      if (!std::ranges::binary_search(left_out, passage.leaf))
        pieces.push_back(guide_of(tree, segments[s], passage));
    }
  });
}

/// Returns the direction at about the point of the face nearest to `point`, blended by barycentric
/// coordinates.
Vector3 direction_at(const GuideFace& face, const Vector3& point) {
  const auto& [a, b, c] = face.corners;
  const Vector3 normal = cross(b - a, c - a);
  const auto share = [&](const Vector3& from, const Vector3& to) {
    return std::max(0.0, dot(cross(to - from, point - from), normal));
  };
  const std::array<double, 3> shares{share(b, c), share(c, a), share(a, b)};
  Vector3 blended{0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const double sign = dot(face.directions[0], face.directions[k]) < 0 ? -1 : 1;
    blended += sign * shares[k] * face.directions[k];
  }
  const Vector3 direction = normalised(blended);
  return direction == Vector3{0, 0, 0} ? face.directions[0] : direction;
}

/// Cuts faces into one piece per leaf, by recursion from the root cube.
class FaceCutter {
 public:
  explicit FaceCutter(const Octree& tree) : tree_(tree), finder_(tree) {}

  void cut(const GuideFace& face, std::vector<LeafGuide>& pieces) const {
    cut(face, CellAddress::root(), pieces);
  }

 private:
  void cut(const GuideFace& face, CellAddress cell, std::vector<LeafGuide>& pieces) const {
    if (!may_overlap(face.corners, tree_.root().box(cell))) return;
    const auto [first, last] = finder_.over(cell);
    if (first == last) return;
    if (tree_[first] == cell) {
      const ClippedTriangle piece = clip_triangle(face.corners, tree_.root().box(cell));
      if (piece.area > 0)
        pieces.push_back(
            LeafGuide::rounded(first, direction_at(face, piece.centroid), face.weight * piece.area));
      return;
    }
    for (int octant = 0; octant < 8; ++octant) cut(face, cell.child(octant), pieces);
  }

  const Octree& tree_;
  LeafFinder finder_;
};

std::vector<std::vector<LeafGuide>> on_faces(const Octree& tree, const std::vector<GuideFace>& faces) {
  const FaceCutter cutter(tree);
  return in_runs(faces.size(),
                 [&](std::size_t f, std::vector<LeafGuide>& pieces) { cutter.cut(faces[f], pieces); });
}

}  // namespace

LeafGuide LeafGuide::rounded(CellIndex leaf, const Vector3& direction, double area) {
  LeafGuide guide{leaf, {}, static_cast<float>(area)};
  for (int k = 0; k < 3; ++k) guide.direction[k] = static_cast<float>(direction[k]);
  return guide;
}

Vector3 LeafGuide::unit_direction() const {
  return normalised(Vector3{direction[0], direction[1], direction[2]});
}

LeafGuides::LeafGuides(const Octree& tree, const Guides& guides, double finest) {
  if (tree.size() == 0 || guides.empty()) return;
  const SegmentWalker walker(tree, finest);
  std::vector<CellIndex> corners;
  for (const Vector3& corner : guides.corners) corners.push_back(walker.leaf_at(corner));
  std::ranges::sort(corners);

  append(guides_, along_segments(tree, walker, guides.creases, corners));
  append(guides_, along_segments(tree, walker, guides.segments, {}));
  append(guides_, on_faces(tree, guides.faces));
  append(guides_, {guides_at_points(tree, guides.points)});
  std::ranges::stable_sort(guides_, {}, &LeafGuide::leaf);

  begin_.resize(tree.size() / kLeavesPerBegin + 2);
  for (const LeafGuide& guide : guides_) ++begin_[guide.leaf / kLeavesPerBegin + 1];
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
}

std::span<const LeafGuide> LeafGuides::found(CellIndex leaf) const {
  const std::size_t part = leaf / kLeavesPerBegin;
  const auto first = guides_.begin() + begin_[part], last = guides_.begin() + begin_[part + 1];
  const auto begin = std::partition_point(first, last, [&](const LeafGuide& g) { return g.leaf < leaf; });
  const auto end = std::find_if(begin, last, [&](const LeafGuide& g) { return g.leaf != leaf; });
  return {begin, end};
}

}  // namespace crossgrain
