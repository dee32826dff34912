// SPDX-License-Identifier: Apache-2.0
// The constraints of the surface and the guides inside a leaf as one quadratic form (docs/design.md section
// 3).
#pragma once

#include "constraint/classification.hpp"
#include "constraint/quadratic_form.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// The sum over the pieces and guides in leaf `i` of area * E_n, for guides with their direction for n; its
/// weight is their area in squared model units.
template <int D>
QuadraticForm<D> cell_form(const GridLevel& level, const Solid& solid, CellIndex i);

extern template QuadraticForm<3> cell_form<3>(const GridLevel&, const Solid&, CellIndex);
extern template QuadraticForm<4> cell_form<4>(const GridLevel&, const Solid&, CellIndex);

/// The normal that a piece in leaf `i` constrains frames by: that of the true surface near the leaf's centre.
inline Vector3 normal_of(const GridLevel& level, const Solid& solid, CellIndex i, const SurfacePiece& piece) {
  return solid.surface.mesh.corner_normals.empty()
             ? solid.surface.normals[piece.triangle]
             : solid.surface.normal_at(piece.triangle, level.tree.centre(i));
}

/// Where there is one direction only that the pieces of leaf `i` have for a normal and the guides in it for
/// their direction: true. Such a leaf needs no matrix. Normals within kSameNormal of each other count as one.
bool has_single_normal(const GridLevel& level, const Solid& solid, CellIndex i);

/// That of the first piece of a leaf that is constrained, or where it has none the direction of its first
/// guide.
Vector3 first_normal(const GridLevel& level, const Solid& solid, CellIndex i);

/// Of the pieces and guides in leaf `i`: the weight of its form.
double constrained_area(const GridLevel& level, CellIndex i);

/// Whether two unit normals count as one, either way round.
bool is_same_normal(const Vector3& a, const Vector3& b);

/// Squared sine up to which two normals are one: 1e-4 degrees, below what a frame in single precision
/// resolves.
inline constexpr double kSameNormal = 3e-12;

/// The class of a leaf that is constrained, from its degree-3 form.
ConstraintClass constraint_class(const GridLevel& level, const Solid& solid, CellIndex i);

}  // namespace crossgrain
