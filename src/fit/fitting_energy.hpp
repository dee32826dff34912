// SPDX-License-Identifier: Apache-2.0
// The energy that fits hexahedra to a model, as a function of all vertices.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/shape_energy.hpp"
#include "fit/surface_samples.hpp"

namespace crossgrain {

/// What pulls vertices beside their shapes.
struct FittingPulls {
  std::vector<VertexPull> of_vertex;
  std::vector<QuadPull> of_quads;
  std::vector<std::uint8_t> is_held = {};  ///< 1 for vertices that stay where they are
  double quad_weight = 0;                  ///< of the latter, in squared inverse model units
};

/// Edges of cubes that hexahedra shall be: of their own volume, within shares of the size, so that thin
/// layers keep their thickness and no hexahedron vanishes.
std::vector<double> wanted_sizes(const HexMesh& mesh, double size);

/// The energy of shapes and pulls by displacements in sizes, three unknowns for each vertex. It is infinite
/// for meshes in which one of the `kept` hexahedra is invalid (is_valid).
class FittingEnergy {
 public:
  /// The mesh and the pulls must outlive it and not change. `kept`: 1 for hexahedra that are valid and shall
  /// stay so; the determinants of others are regularised by the options' epsilon.
  FittingEnergy(const HexMesh& mesh, const FittingPulls& pulls, double size,
                const CornerEnergyOptions& options, std::vector<std::uint8_t> kept);

  double operator()(const Eigen::VectorXd& displacements, Eigen::VectorXd& gradient);

  /// Makes `result` the gradient times the inverses of the second derivatives by each vertex alone, at the
  /// mesh as it was given.
  void precondition(const Eigen::VectorXd& gradient, Eigen::VectorXd& result) const;

  std::vector<Vector3> places(const Eigen::VectorXd& displacements) const;

 private:
  void find_places(const Eigen::VectorXd& displacements, std::vector<Vector3>& places) const;
  void invert_blocks();
  SymmetricMatrix3 block_of(std::uint32_t vertex) const;

  const HexMesh& mesh_;
  const FittingPulls& pulls_;
  double size_;
  CornerEnergyOptions options_;
  std::vector<std::uint8_t> kept_;
  std::vector<double> sizes_;
  ShapeEnergy shapes_;
  Lists<std::uint32_t> uses_;       ///< of vertices by hexahedra
  Lists<std::uint32_t> pulled_by_;  ///< 3 times the pull of a quad, and the vertex in it
  std::vector<Eigen::Matrix3d> inverses_;
  std::vector<Vector3> at_, of_shapes_;  ///< places of the last evaluation, and the gradient of shapes there
  std::vector<double> differences_;      ///< of the pulls of quads there
};

}  // namespace crossgrain
