// SPDX-License-Identifier: Apache-2.0
// The hexahedra around one vertex, for moves of this vertex alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "fit/shape_energy.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {

/// The scaled Jacobian (`scaled_jacobians`) of a hexahedron with these corners.
double scaled_jacobian_of(const HexCorners& corners);

/// Copies of the hexahedra at a vertex, in which it can be moved for trial.
class VertexSurroundings {
 public:
  /// `uses`: corner_uses of the vertex.
  VertexSurroundings(const HexMesh& mesh, std::span<const std::uint32_t> uses);

  void move_to(const Vector3& place);

  bool are_valid() const;
  double least_scaled_jacobian() const;

  /// Mean length of the edges at the vertex, and the least.
  double mean_edge() const;
  double least_edge() const;

  /// Mean of these sizes of all hexahedra of the mesh over those around.
  double mean_size(std::span<const double> sizes) const;

  /// The sum of energy_at, or add_energy_at, with these sizes of all hexahedra of the mesh.
  double energy(std::span<const double> sizes, const CornerEnergyOptions& options) const;
  bool add_energy(std::span<const double> sizes, const CornerEnergyOptions& options, SecondOrder& sum) const;

  /// The sum of (1 - s)^kWorstPower of the scaled Jacobians s of all corners that the vertex is part of:
  /// those of the worst of them count most.
  double badness() const;
  Vector3 badness_gradient() const;

 private:
  struct Use {
    std::uint32_t hexahedron;
    std::uint32_t corner;
    HexCorners corners;
  };
  std::vector<Use> uses_;
};

/// Vertices of which no two of a set have a hexahedron in common: all of a set can be moved at once.
std::vector<std::vector<std::uint32_t>> independent_sets(const HexMesh& mesh,
                                                         const Lists<std::uint32_t>& uses);

}  // namespace crossgrain
