// SPDX-License-Identifier: Apache-2.0
// The constraints of the surface and the guides in a leaf as one quadratic form (docs/design.md section 3).
#pragma once

#include "constraint/classification.hpp"
#include "constraint/quadratic_form.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Returns the sum of area * E_n over the pieces and guides in leaf `i`, where n is the normal of a piece or
/// the direction of a guide. The weight of the form is the sum of the areas, in squared model units.
template <int D>
QuadraticForm<D> cell_form(const GridLevel& level, const Solid& solid, CellIndex i);

/// Returns the normal to which a piece in leaf `i` constrains frames: that of the true surface near the
/// leaf's centre.
inline Vector3 normal_of(const GridLevel& level, const Solid& solid, CellIndex i, const SurfacePiece& piece) {
  return solid.surface.mesh.corner_normals.empty()
             ? solid.surface.normals[piece.triangle]
             : solid.surface.normal_at(piece.triangle, level.tree.centre(i));
}

/// Returns whether all normals of pieces and directions of guides in leaf `i` are the same
/// (`is_same_normal`). Such a leaf needs no matrix.
bool has_single_normal(const GridLevel& level, const Solid& solid, CellIndex i);

/// Returns the normal of the first piece in leaf `i`, or the direction of its first guide if it has no
/// pieces. The leaf must be constrained.
Vector3 first_normal(const GridLevel& level, const Solid& solid, CellIndex i);

/// Returns the area of the pieces and guides in leaf `i`, which is the weight of its form.
double constrained_area(const GridLevel& level, CellIndex i);

/// Returns whether two unit normals, or one and the opposite of the other, differ by at most kSameNormal.
bool is_same_normal(const Vector3& a, const Vector3& b);

/// Squared sine of the angle up to which two normals are the same: 1e-4 degrees, less than a frame in single
/// precision resolves.
inline constexpr double kSameNormal = 3e-12;

/// Returns the class of a constrained leaf, from its degree-3 form.
ConstraintClass constraint_class(const GridLevel& level, const Solid& solid, CellIndex i);

}  // namespace crossgrain
