// SPDX-License-Identifier: Apache-2.0
// Weights of the edges between leaves, one by one.
#pragma once

#include <array>
#include <span>

#include "field/octree_graph.hpp"
#include "grid/grid_level.hpp"
#include "grid/open_faces.hpp"

namespace crossgrain {

using FaceWeights = std::array<FaceWeight, kFaceCount>;

/// Steps of weight per open sample of a face.
inline constexpr int kStepsOfSample = FaceWeight::kFullFace / kOpenFaceSamples;

class LeafConnector {
 public:
  LeafConnector(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid)
      : level_(level), neighbours_(neighbours), tree_(level.tree), solid_(solid) {}

  /// Returns the weights of the edges that leaf i owns: to larger leaves, and to leaves of its size on its
  /// high side.
  FaceWeights owned(CellIndex i) const {
    FaceWeights weights;
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = neighbours_[i][face];
      if (j == kNoCell || (is_equal(i, j) && face_sign(face) < 0)) continue;
      weights[face] = weight(i, face, j, kStepsOfSample * samples_between(i, face, j));
    }
    return weights;
  }

  /// Returns the inward normals of the surface in leaf i, times their areas.
  Vector3 inward(CellIndex i) const {
    Vector3 sum{0, 0, 0};
    for (const SurfacePiece& piece : level_.pieces_of(i))
      sum += -piece.area * solid_.outward_normal(piece.triangle);
    return sum;
  }

  /// Returns the smallest possible edge: half a sample.
  FaceWeight tie(CellIndex i, int face) const {
    return weight(i, face, neighbours_[i][face], kStepsOfSample / 2);
  }

  bool is_equal(CellIndex i, CellIndex j) const { return tree_[i].depth() == tree_[j].depth(); }

 private:
  int samples_between(CellIndex i, int face, CellIndex j) const {
    // The surface does not cross a face of a leaf without surface, so the face is fully open.
    if (!level_.holds_surface(i) || !level_.holds_surface(j)) return kOpenFaceSamples;
    return open_samples(level_, solid_, i, face);
  }

  /// `steps` is the open area in parts of the face.
  FaceWeight weight(CellIndex i, int face, CellIndex j, int steps) const {
    // The centres of leaves of two sizes are 1.5 times as far apart.
    if (!is_equal(i, j)) return {steps * 2 / 3, true};
    return {steps * (3 - shared_hanging_faces(i, face, j)) / 3, false};
  }

  /// Returns how many leaves of twice the size touch both i and its neighbour j across `face`. Each takes
  /// away a third of the edge's weight; see connect_leaves.
  int shared_hanging_faces(CellIndex i, int face, CellIndex j) const {
    if (tree_[i].depth() == 0 || tree_[i].parent() != tree_[j].parent()) return 0;
    int shared = 0;
    for (int other = 0; other < kFaceCount; ++other) {
      if (face_axis(other) == face_axis(face)) continue;
      const CellIndex k = neighbours_[i][other];
      shared += k != kNoCell && tree_[k].depth() < tree_[i].depth();
    }
    return shared;
  }

  const GridLevel& level_;
  std::span<const FaceNeighbours> neighbours_;
  const Octree& tree_;
  const Solid& solid_;
};

static_assert(FaceWeight::kFullFace % kOpenFaceSamples == 0 && kStepsOfSample / 2 * 2 % 3 == 0 &&
                  kStepsOfSample / 2 * 2 == kStepsOfSample,
              "weights of faces must be whole");

}  // namespace crossgrain
