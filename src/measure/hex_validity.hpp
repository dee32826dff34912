// SPDX-License-Identifier: Apache-2.0
// The program's definition of a valid hexahedron.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// The corners of a hexahedron, in the order of HexMesh.
using HexCorners = std::array<Vector3, 8>;

/// Of the least determinant of a hexahedron: lower <= least <= upper.
struct JacobianBounds {
  double lower, upper;
};

/// A hexahedron is valid if the determinant of its trilinear map from the unit cube exceeds this share of the
/// product of its three mean edges everywhere, so that neither its size nor a stretch along its axes matters;
/// otherwise it is inverted. Vertices of single precision on one plane are off by a share of 1e-7 of the
/// model, so that a flat hexahedron of a twentieth of it can have 2e-6 at most, of either sign.
inline constexpr double kLeastJacobian = 1e-6;

/// Returns bounds of the least determinant of the trilinear map, divided by the product of the mean lengths
/// of the four edges along each axis: 1 for a box. Where a mean is zero or no number, both are 0.
///
/// The determinant is a polynomial of degree two along each axis. Its 27 Bezier coefficients bound it from
/// below, those at corners from above. The box with the least coefficient is halved along all axes until the
/// bounds are within `gap`, or after 512 cuts. (Johnen, Weill, Remacle 2017, Robust and efficient validation
/// of the linear hexahedral element, section 3.)
JacobianBounds least_jacobian(const HexCorners& corners, double gap = 1e-3);

/// Whether a hexahedron is valid, by the same bounds. One that 512 cuts do not decide is not.
bool is_valid(const HexCorners& corners);

HexCorners corners_of(const HexMesh& mesh, std::size_t hexahedron);

/// Returns 1 for each hexahedron that is not valid, otherwise 0.
std::vector<std::uint8_t> inverted_hexahedra(const HexMesh& mesh);

/// Whether all hexahedra that have a 1 in `which` (one entry for each) are valid.
bool are_valid(const std::vector<Vector3>& places, std::span<const std::array<std::uint32_t, 8>> hexahedra,
               std::span<const std::uint8_t> which);

}  // namespace crossgrain
