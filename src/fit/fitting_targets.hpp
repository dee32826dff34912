// SPDX-License-Identifier: Apache-2.0
// Where vertices of hexahedra shall be on what carries them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/lists.hpp"
#include "fit/feature_carriers.hpp"
#include "fit/hex_carriers.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

/// A quadratic energy (x - point)^T weight (x - point) of the place x of a vertex.
struct VertexPull {
  SymmetricMatrix3 weight{};
  Vector3 point{0, 0, 0};
};

/// Places on carriers. Vertices on a curve slide between their neighbours, those on a group of faces
/// anywhere.
class FittingTargets {
 public:
  /// All must outlive it; `size` is the edge of hexahedra.
  FittingTargets(const FeatureComplex& complex, const HexCarriers& carriers, double size);

  const HexCarriers& carriers() const { return carriers_; }
  double size() const { return size_; }

  /// Spreads vertices evenly: on curves at equal shares (FeatureCarriers::shares), on faces so that each
  /// moves as its neighbours do in the mean, from the places of the mesh on.
  void spread(const HexMesh& mesh);

  /// Lets vertices on curves slide about where they are now, where those of a curve are in its order; those
  /// off it about where they were. To be called after `spread`.
  void slide_from(const HexMesh& mesh);

  /// Where `spread` put the vertices that have a carrier.
  const std::vector<Vector3>& evenly() const { return evenly_; }

  /// Unit normals of the mesh at vertices of its quads; zero at others.
  std::vector<Vector3> normals_of(const HexMesh& mesh) const;

  /// The point of a vertex's carrier nearest to p; `normal` is the mesh's there. Not for those inside.
  FeatureCarriers::Place nearest(std::uint32_t vertex, const Vector3& p, const Vector3& normal) const;

  /// Vertices of the surface next to each other over an edge of a quad.
  std::span<const std::uint32_t> neighbours(std::uint32_t vertex) const { return neighbours_[vertex]; }

 private:
  void spread_curves(const HexMesh& mesh);
  double share_of(std::uint32_t vertex, std::uint32_t curve, const Vector3& place, double after,
                  double end) const;
  bool is_on_curve(std::uint32_t vertex, std::uint32_t curve) const;
  void set_windows(std::uint32_t curve, const std::vector<double>& shares);
  void spread_faces(const HexMesh& mesh);
  double first_share(std::uint32_t curve, const std::vector<std::uint32_t>& path, const HexMesh& mesh) const;

  const HexCarriers& carriers_;
  double size_;
  FeatureCarriers features_;
  Lists<std::uint32_t> neighbours_;
  std::vector<Vector3> evenly_;
  std::vector<std::pair<double, double>> windows_;  ///< of arc length, of vertices on curves
};

}  // namespace crossgrain
