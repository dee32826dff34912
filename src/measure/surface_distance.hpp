// SPDX-License-Identifier: Apache-2.0
// How far the surface of hexahedra and that of a model are from each other.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/types.hpp"
#include "measure/surface_quads.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Distances in sizes of hexahedra.
struct DistanceFigures {
  double percentile_99 = 0, largest = 0;  ///< beyond what straight edges cut off
  Vector3 place{0, 0, 0};                 ///< of the largest
  double largest_in_all = 0;              ///< with it
  Vector3 place_in_all{0, 0, 0};
};

struct SurfaceDistances {
  DistanceFigures of_mesh;   ///< of vertices, middles of edges and centres of quads from the model
  DistanceFigures of_model;  ///< of points spread evenly over the model from the quads
};

/// Triangles of a complex, which has some, ready for nearest points.
class FeatureTrees {
 public:
  explicit FeatureTrees(const FeatureComplex& complex);
  ~FeatureTrees();

  /// Returns the nearest face between the same solids; of all, if there is none.
  std::uint32_t nearest_face(const Vector3& point, std::int32_t below, std::int32_t above) const;

  /// Returns the distance to the nearest of these.
  double distance(const Vector3& point, std::int32_t below, std::int32_t above) const;

  /// Returns the unit normal of the true surface of a face near a point: blended from exact normals, or from
  /// the mean normals of the face's triangles at its vertices.
  Vector3 normal_on_face(std::uint32_t face, const Vector3& point) const;

 private:
  struct Trees;
  std::unique_ptr<const Trees> trees_;
};

/// Returns for each quad by how much a curved surface leaves it, model units: k d^2 / 16 for its diagonals of
/// length d, where the normals of its face turn by k d in their direction, added. That is the depth of the
/// middle of a parallelogram with corners on a quadric.
std::vector<double> cut_off_by_quads(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                     std::span<const std::uint32_t> face_of_quad, const FeatureTrees& trees);

/// Returns the distances of quads and model. `cut_off` is that of `cut_off_by_quads`; edges have the larger
/// one of the quads beside them, vertices none.
SurfaceDistances surface_distances(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                   std::span<const double> cut_off, const FeatureComplex& complex,
                                   const FeatureTrees& trees, double size);

}  // namespace crossgrain
