// SPDX-License-Identifier: Apache-2.0
#include "analysis/singular_edges.hpp"

#include <array>
#include <cassert>

#include "analysis/matching.hpp"
#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Leaves that one task looks at.
constexpr std::size_t kLeafGrain = 1024;

class SingularEdgeFinder {
 public:
  SingularEdgeFinder(const Octree& tree, std::span<const StoredQuaternion> frames,
                     std::span<const std::uint8_t> open_faces)
      : tree_(tree), finder_(tree), frames_(frames), open_faces_(open_faces) {}

  /// Adds the singular edges that leaf i owns: of the leaves around an edge the smallest, of several the
  /// first.
  void find(CellIndex i, std::vector<GridEdge>& found) const {
    std::array<CellIndex, kFaceCount> across;
    for (int face = 0; face < kFaceCount; ++face) across[face] = finder_.neighbour(i, face);
    for (int axis = 0; axis < 3; ++axis) {
      for (int corner = 0; corner < 4; ++corner) {
        const int face_u = 2 * ((axis + 1) % 3) + (corner & 1);
        const int face_v = 2 * ((axis + 2) % 3) + (corner >> 1);
        const CellIndex j = across[face_u], k = across[face_v];
        if (!comes_before(i, j) || !comes_before(i, k)) continue;
        const CellIndex diagonal = across_edge(i, face_u, face_v);
        if (!comes_before(i, diagonal)) continue;
        const CubeRotation turn =
            turn_around({i, j, diagonal, k}, {face_u, face_v, opposite_face(face_u), opposite_face(face_v)});
        if (!turn.is_identity()) found.push_back(edge_of(i, axis, face_u, face_v, turn));
      }
    }
  }

 private:
  /// Whether leaf i, of two leaves at an edge, is the one to own it. `j` is never smaller than i; kNoCell
  /// stands for nothing there, or for smaller leaves, which then own what is left of the edge.
  bool comes_before(CellIndex i, CellIndex j) const {
    return j != kNoCell && (tree_[j].depth() < tree_[i].depth() || i < j);
  }

  CellIndex across_edge(CellIndex i, int face_u, int face_v) const {
    const auto beside = adjacent(tree_[i], face_u);
    const auto diagonal = beside ? adjacent(*beside, face_v) : std::nullopt;
    return diagonal ? finder_.containing(*diagonal) : kNoCell;
  }

  /// How the way around over these leaves, leaving ring[s] through faces[s], turns frames; not at all where
  /// it is not open.
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

  /// A face between leaves is open if the smaller of them says so, or either of two equal ones.
  bool are_joined(CellIndex from, int face, CellIndex to) const {
    const int depth_from = tree_[from].depth(), depth_to = tree_[to].depth();
    return (depth_from >= depth_to && (open_faces_[from] >> face & 1)) ||
           (depth_to >= depth_from && (open_faces_[to] >> opposite_face(face) & 1));
  }

  /// Worked out in one direction only: where two rotations are equally near, rounding must not make the way
  /// back another one.
  CubeRotation face_matching(CellIndex from, CellIndex to) const {
    return from < to ? matching(frames_[from], frames_[to]) : inverse(matching(frames_[to], frames_[from]));
  }

  GridEdge edge_of(CellIndex i, int axis, int face_u, int face_v, const CubeRotation& turn) const {
    const std::int32_t width = tree_[i].width();
    GridPoint start = tree_[i].corner();
    for (const int face : {face_u, face_v}) {
      if (face_sign(face) > 0) start[face_axis(face)] += width;
    }
    return {start, axis, width, turn.is_odd()};
  }

  const Octree& tree_;
  LeafFinder finder_;
  std::span<const StoredQuaternion> frames_;
  std::span<const std::uint8_t> open_faces_;
};

}  // namespace

std::vector<GridEdge> singular_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                     std::span<const std::uint8_t> open_faces) {
  assert(frames.size() == tree.size() && open_faces.size() == tree.size());
  const SingularEdgeFinder finder(tree, frames, open_faces);
  std::vector<std::vector<GridEdge>> runs((tree.size() + kLeafGrain - 1) / kLeafGrain);
  parallel_for_chunks(tree.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i) finder.find(i, runs[begin / kLeafGrain]);
  });
  std::vector<GridEdge> edges;
  for (const auto& run : runs) edges.insert(edges.end(), run.begin(), run.end());
  return edges;
}

}  // namespace crossgrain
