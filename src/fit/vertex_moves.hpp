// SPDX-License-Identifier: Apache-2.0
// Moves of single vertices of valid hexahedra, each accepted only if all hexahedra around stay valid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/fitting_energy.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/vertex_surroundings.hpp"

namespace crossgrain {

/// The same to the bit for any number of threads. Interrupted as watched loops are; the mesh is then valid,
/// and as good as its moves so far made it.
class VertexMoves {
 public:
  /// The mesh, of which all hexahedra are valid, and the targets must outlive it.
  VertexMoves(HexMesh& mesh, const FittingTargets& targets);

  /// Moves each vertex once to less energy of shapes and pulls, by Newton's step: those on their carrier
  /// along it, others freely. Vertices are left out whose surroundings have come to rest. Returns how many
  /// moved.
  std::size_t relax(const FittingPulls& pulls, const CornerEnergyOptions& options);

  /// Puts vertices that are off their carrier onto it, where the least scaled Jacobian around stays above
  /// `floor` or rises; as far as it goes elsewhere. Returns how many are off.
  std::size_t snap(double floor);

  /// Moves vertices of hexahedra with a scaled Jacobian below `threshold` so that the worst around them rise.
  /// Returns how many moved.
  std::size_t lift(double threshold);

  /// Moves vertices of hexahedra with a scaled Jacobian below `threshold`, each to the place where the least
  /// one around it is largest, of those near in 26 directions, which differ by `sweep`: so that never falls.
  /// Returns how many moved.
  std::size_t raise(double threshold, int sweep);

  bool is_on_carrier(std::uint32_t vertex) const { return is_on_[vertex] != 0; }

 private:
  using Kind = HexCarrier::Kind;
  Kind kind(std::uint32_t vertex) const { return targets_.carriers().of_vertex[vertex].kind; }

  /// Calls move(vertex) for a set of vertices that are `wanted`, at once for those of an independent set.
  template <class Move>
  std::size_t move_all(const std::vector<std::uint8_t>& wanted, const Move& move);

  void update_normals() { normals_ = targets_.normals_of(mesh_); }
  double pull_energy(std::uint32_t vertex, const Vector3& place, const FittingPulls& pulls) const;
  void add_pulls(std::uint32_t vertex, const FittingPulls& pulls, SecondOrder& sum) const;
  Vector3 direction_of(std::uint32_t vertex, const Vector3& gradient) const;
  std::array<Vector3, 3> axes_at(std::uint32_t vertex, const Vector3& gradient, int sweep) const;
  double off_carrier(std::uint32_t vertex, const Vector3& place) const;
  std::vector<std::uint8_t> vertices_of_worst(double threshold) const;
  Vector3 held(std::uint32_t vertex, const Vector3& place) const;
  bool relax_vertex(std::uint32_t vertex, const FittingPulls& pulls, const CornerEnergyOptions& options);
  bool snap_vertex(std::uint32_t vertex, double floor);
  bool lift_vertex(std::uint32_t vertex);
  bool raise_vertex(std::uint32_t vertex, int sweep);

  HexMesh& mesh_;
  const FittingTargets& targets_;
  Lists<std::uint32_t> uses_, pulled_by_;
  std::vector<std::vector<std::uint32_t>> sets_;
  std::vector<double> sizes_;
  std::vector<Vector3> normals_;
  std::vector<std::uint8_t> is_on_;       ///< its carrier; all of those inside
  std::vector<std::uint8_t> is_stirred_;  ///< the vertex, or one around it, has moved
};

}  // namespace crossgrain
