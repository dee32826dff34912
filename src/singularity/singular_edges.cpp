// SPDX-License-Identifier: Apache-2.0
#include "singularity/singular_edges.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "grid/leaf_surroundings.hpp"
#include "singularity/matching.hpp"
#include "singularity/touching_ends.hpp"

namespace crossgrain {
namespace {

/// Number of leaves per task.
constexpr std::size_t kLeafGrain = 1024;

class SingularEdgeFinder {
 public:
  SingularEdgeFinder(const Octree& tree, std::span<const StoredQuaternion> frames,
                     std::span<const std::uint8_t> open_faces)
      : tree_(tree), finder_(tree), frames_(frames), open_faces_(open_faces) {}

  /// Adds the singular edges owned by leaves [begin, end). The owner is the first of the smallest leaves
  /// around an edge.
  void find(CellIndex begin, CellIndex end, std::span<const std::uint8_t> owners,
            std::vector<GridEdge>& found) const {
    LeafSurroundings around(tree_, finder_);
    for (CellIndex i = begin; i < end; ++i) {
      if (!owners.empty() && !owners[i]) continue;
      around.move_to(i);
      find(around, found);
    }
  }

 private:
  using Step = LeafSurroundings::Step;

  void find(const LeafSurroundings& around, std::vector<GridEdge>& found) const {
    const CellIndex i = around.leaf();
    for (int axis = 0; axis < 3; ++axis) {
      for (int corner = 0; corner < 4; ++corner) {
        const int face_u = 2 * ((axis + 1) % 3) + (corner & 1);
        const int face_v = 2 * ((axis + 2) % 3) + (corner >> 1);
        Step to_u{}, to_v{}, diagonal{};
        to_u[face_axis(face_u)] = diagonal[face_axis(face_u)] = face_sign(face_u);
        to_v[face_axis(face_v)] = diagonal[face_axis(face_v)] = face_sign(face_v);
        if (!comes_before(around, to_u) || !comes_before(around, to_v) || !comes_before(around, diagonal))
          continue;
        const std::array ring{i, around.over(to_u).first, around.over(diagonal).first,
                              around.over(to_v).first};
        if (are_all_surely_alike(ring)) continue;
        const CubeRotation turn =
            turn_around(ring, {face_u, face_v, opposite_face(face_u), opposite_face(face_v)});
        if (!turn.is_identity())
          found.push_back(edge_of(i, axis, face_u, face_v, turn_along_axis(ring, face_u, face_v, turn)));
      }
    }
  }

  /// Whether the centre leaf, rather than the one at `step`, owns an edge of both. Smaller leaves at `step`
  /// own their parts of the edge.
  static bool comes_before(const LeafSurroundings& around, const Step& step) {
    return around.is_larger(step) || (around.is_equal(step) && around.leaf() < around.over(step).first);
  }

  bool are_all_surely_alike(const std::array<CellIndex, 4>& ring) const {
    for (std::size_t step = 0; step < 4; ++step) {
      if (!are_surely_alike(frames_[ring[step]], frames_[ring[(step + 1) % 4]])) return false;
    }
    return true;
  }

  /// Product of the matchings on the closed path over these leaves, which leaves ring[s] through faces[s];
  /// the identity if a face on it is not open.
  CubeRotation turn_around(const std::array<CellIndex, 4>& ring, const std::array<int, 4>& faces) const {
    CubeRotation turn;
    for (std::size_t step = 0; step < 4; ++step) {
      const CellIndex from = ring[step], to = ring[(step + 1) % 4];
      if (from == to) continue;
      if (!are_joined(from, faces[step], to)) return {};
      turn = face_matching(from, to) * turn;
    }
    return turn;
  }

  /// Whether the face between two leaves is open, according to the smaller of them, or to either of two equal
  /// ones.
  bool are_joined(CellIndex from, int face, CellIndex to) const {
    const int depth_from = tree_[from].depth(), depth_to = tree_[to].depth();
    return (depth_from >= depth_to && (open_faces_[from] >> face & 1)) ||
           (depth_to >= depth_from && (open_faces_[to] >> opposite_face(face) & 1));
  }

  /// The matching across a face. Computed in one direction only: if two rotations are equally near, rounding
  /// must not make the reverse matching a different one.
  CubeRotation face_matching(CellIndex from, CellIndex to) const {
    return from < to ? matching(frames_[from], frames_[to]) : inverse(matching(frames_[to], frames_[from]));
  }

  /// The rotation of frames on the path around an edge that is right-handed about the edge's axis.
  FrameTurn turn_along_axis(const std::array<CellIndex, 4>& ring, int face_u, int face_v,
                            const CubeRotation& product) const {
    std::array<Quaternion, 4> way;
    for (std::size_t step = 0; step < 4; ++step) way[step] = from_stored(frames_[ring[step]]);
    if (face_sign(face_u) == face_sign(face_v)) return frame_turn(product, way);
    std::swap(way[1], way[3]);
    return frame_turn(inverse(product), way);
  }

  GridEdge edge_of(CellIndex i, int axis, int face_u, int face_v, const FrameTurn& turn) const {
    const std::int32_t width = tree_[i].width();
    GridPoint start = tree_[i].corner();
    for (const int face : {face_u, face_v}) {
      if (face_sign(face) > 0) start[face_axis(face)] += width;
    }
    return {start, axis, width, turn};
  }

  const Octree& tree_;
  LeafFinder finder_;
  std::span<const StoredQuaternion> frames_;
  std::span<const std::uint8_t> open_faces_;
};

}  // namespace

std::vector<GridEdge> singular_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                     std::span<const std::uint8_t> open_faces,
                                     std::span<const std::uint8_t> owners, const Share& part) {
  assert(frames.size() == tree.size() && open_faces.size() == tree.size());
  const Share share = share_of(part, tree.size());
  const SingularEdgeFinder finder(tree, frames, open_faces);
  std::vector<std::vector<GridEdge>> runs((share.size() + kLeafGrain - 1) / kLeafGrain);
  parallel_for_chunks(share.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    finder.find(static_cast<CellIndex>(share.begin + begin), static_cast<CellIndex>(share.begin + end),
                owners, runs[begin / kLeafGrain]);
  });
  std::vector<GridEdge> edges;
  for (const auto& run : runs) edges.insert(edges.end(), run.begin(), run.end());
  return of_all(share, std::move(edges));
}

SingularEdges by_end_points(const std::vector<GridEdge>& edges, const RootCube& root) {
  std::vector<GridPoint> points;
  for (const GridEdge& edge : edges) points.insert(points.end(), {edge.start, edge.end()});
  sort_uniquely(points);
  const auto index_of = [&](const GridPoint& point) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
  };
  SingularEdges singular;
  for (const GridPoint& point : points) singular.points.push_back({root.position(point), 0, false, -1});
  std::vector<std::uint32_t> degrees(points.size(), 0), odd(points.size(), 0);
  for (const GridEdge& edge : edges) {
    const std::array ends{index_of(edge.start), index_of(edge.end())};
    for (const std::uint32_t end : ends) {
      ++degrees[end];
      odd[end] ^= edge.turn.is_odd();
      double& size = singular.points[end].cell_size;
      size = std::max(size, edge.length * root.unit());
    }
    singular.edges.push_back({ends, edge.turn});
  }
  for (std::size_t k = 0; k < points.size(); ++k) singular.points[k].on_boundary = degrees[k] == 1 || odd[k];
  return singular;
}

SingularEdges singular_grid_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                  std::span<const std::uint8_t> open_faces,
                                  std::span<const std::vector<Vector3>> creases,
                                  std::span<const std::uint8_t> owners, const Share& part) {
  SingularEdges singular = by_end_points(singular_edges(tree, frames, open_faces, owners, part), tree.root());
  singular.creases = creases;
  singular.surface_edges = touching_ends(singular, tree, open_faces, part);
  return singular;
}

}  // namespace crossgrain
