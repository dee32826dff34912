// SPDX-License-Identifier: Apache-2.0
// How far hexahedra are from cubes of a size.
//
// Notation: a, b, c are the edges of a hexahedron at a corner, right-handed, in sizes; D is their
// determinant, and F = |a|^2 + |b|^2 + |c|^2. The energy of the corner is
//
//   f = F / chi^(2/3) + w (1 + D^2) / chi,
//
// 3 + 2 w for a cube and infinite for D <= 0, where chi is D, or a regularised D, which is positive for all
// (Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov 2021, Foldover-free maps in 50 lines of code,
// equation 3, for hexahedra by the tets at their corners).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "base/vector3.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

struct CornerEnergyOptions {
  double volume_weight;  ///< w: of the change of volume against that of shape
  int power = 1;         ///< of f, relative to a cube: with higher ones the worst corners count more
  double epsilon = 0;    ///< of `regularised`; 0: chi = D
};

/// The uses of vertices by hexahedra: 8 times the hexahedron, and the corner; ascending.
Lists<std::uint32_t> corner_uses(std::size_t vertices,
                                 std::span<const std::array<std::uint32_t, 8>> hexahedra);

/// The sum over all corners of hexahedra of (3 + 2 w) (f / (3 + 2 w))^power, which is infinite, without a
/// gradient, if D <= 0 at a corner with chi = D. The same to the bit for any number of threads.
class ShapeEnergy {
 public:
  /// The hexahedra must outlive it. `sizes`: of each hexahedron, in the unit of places.
  ShapeEnergy(std::size_t vertices, std::span<const std::array<std::uint32_t, 8>> hexahedra,
              std::vector<double> sizes);

  /// Fills in the gradient by the places of vertices. For hexahedra marked in `kept`, epsilon is 0.
  double operator()(const std::vector<Vector3>& places, const CornerEnergyOptions& options,
                    std::vector<Vector3>& gradient, std::span<const std::uint8_t> kept = {});

  /// The least determinant of all corners, in cubed sizes; infinite without hexahedra.
  double least_determinant(const std::vector<Vector3>& places) const;

 private:
  template <int W>
  void find_terms(const std::vector<Vector3>& places, const CornerEnergyOptions& options,
                  std::span<const std::uint8_t> kept, std::size_t first, int count);

  std::span<const std::array<std::uint32_t, 8>> hexahedra_;
  std::vector<double> scales_;
  Lists<std::uint32_t> uses_;
  std::vector<double> values_;      ///< of hexahedra
  std::vector<Vector3> by_corner_;  ///< their gradients by the places of their corners
};

/// A function of the place of one vertex to second order.
struct SecondOrder {
  double value = 0;
  Vector3 gradient{0, 0, 0};
  SymmetricMatrix3 hessian{};
};

/// Adds the energy of the four corners of a hexahedron that one of its vertices is part of, as a function of
/// that vertex's place, with chi = D. D is affine in it, F quadratic, and |y|^2 / t^(2/3) and (1 + t^2) / t
/// are convex for t > 0; so this is convex, and the Hessian positive definite. Returns false, and leaves
/// `sum` unfinished, unless all four determinants are positive.
bool add_energy_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                   const CornerEnergyOptions& options, SecondOrder& sum);

/// Adds about the second derivative of the same with `regularised` determinants, for chi as if it were
/// affine: positive definite.
void add_stiffness_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                      const CornerEnergyOptions& options, SymmetricMatrix3& sum);

/// The value alone; infinite unless all four determinants are positive.
double energy_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                 const CornerEnergyOptions& options);

}  // namespace crossgrain
