// SPDX-License-Identifier: Apache-2.0
#include "grid/cell_constraints.hpp"

#include "base/vector3.hpp"
#include "constraint/normal_form.hpp"

namespace crossgrain {

template <int D>
QuadraticForm<D> cell_form(const GridLevel& level, const Solid& solid, CellIndex i) {
  QuadraticForm<D> form{};
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    add_normal(form, solid.surface.normals[piece.triangle], piece.area);
  }
  return form;
}

template QuadraticForm<3> cell_form<3>(const GridLevel&, const Solid&, CellIndex);
template QuadraticForm<4> cell_form<4>(const GridLevel&, const Solid&, CellIndex);

bool has_single_normal(const GridLevel& level, const Solid& solid, CellIndex i) {
  const auto pieces = level.pieces_of(i);
  for (const SurfacePiece& piece : pieces) {
    const Vector3 off =
        cross(solid.surface.normals[piece.triangle], solid.surface.normals[pieces[0].triangle]);
    if (dot(off, off) > kSameNormal) return false;
  }
  return !pieces.empty();
}

ConstraintClass constraint_class(const GridLevel& level, const Solid& solid, CellIndex i) {
  if (has_single_normal(level, solid, i)) return ConstraintClass::kPlane;
  return classify(cell_form<3>(level, solid, i));
}

}  // namespace crossgrain
