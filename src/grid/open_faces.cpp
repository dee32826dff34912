// SPDX-License-Identifier: Apache-2.0
#include "grid/open_faces.hpp"

#include <cmath>
#include <optional>

#include "base/vector3.hpp"
#include "surface/segment_crossing.hpp"

namespace crossgrain {
namespace {

/// By how much the winding number changes from the centre of leaf i to a point of it; nothing where rounding
/// could tell it wrong.
std::optional<int> winding_change_to(const GridLevel& level, const Solid& solid, CellIndex i,
                                     const Vector3& point) {
  int sum = 0;
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    const auto change = winding_change(solid.surface.corners(piece.triangle), level.tree.centre(i), point);
    if (!change) return std::nullopt;
    sum += *change;
  }
  return solid.winding.flipped() ? -sum : sum;
}

/// How far a sample moves, in cells, where the way there runs along an edge of the surface: faces of parts
/// drawn in round numbers are cut along lines that lead through many samples.
constexpr double kNudge1 = 0.0137, kNudge2 = 0.0071;

}  // namespace

double open_fraction(const GridLevel& level, const Solid& solid, CellIndex i, int face) {
  if (!level.holds_surface(i)) return 1;
  const double size = level.tree.cell_size(i);
  const int axis = face_axis(face), axis1 = (axis + 1) % 3, axis2 = (axis + 2) % 3;
  int open = 0;
  for (int a = 0; a < kOpenFaceSamples; ++a) {
    for (int b = 0; b < kOpenFaceSamples; ++b) {
      Vector3 point = level.tree.centre(i);
      point[axis] += 0.5 * face_sign(face) * size;
      point[axis1] += ((a + 0.5) / kOpenFaceSamples - 0.5) * size;
      point[axis2] += ((b + 0.5) / kOpenFaceSamples - 0.5) * size;
      std::optional<int> change = winding_change_to(level, solid, i, point);
      if (!change) {
        point[axis1] += kNudge1 * size;
        point[axis2] += kNudge2 * size;
        change = winding_change_to(level, solid, i, point);
      }
      open += level.centre_winding[i] + change.value_or(0) > 0;
    }
  }
  return static_cast<double>(open) / (kOpenFaceSamples * kOpenFaceSamples);
}

bool holds_two_sheets(const GridLevel& level, const Solid& solid, CellIndex i) {
  const auto pieces = level.pieces_of(i);
  const double size = level.tree.cell_size(i);
  // The sheets are told apart against the largest piece, so that the cost stays linear.
  const SurfacePiece* largest = nullptr;
  for (const SurfacePiece& piece : pieces) {
    if (!largest || piece.area > largest->area) largest = &piece;
  }
  if (!largest) return false;
  double same = 0, opposite = 0;
  for (const SurfacePiece& piece : pieces) {
    const double cosine =
        dot(solid.surface.normals[piece.triangle], solid.surface.normals[largest->triangle]);
    if (cosine > 0.5) same += piece.area;
    if (cosine < -0.5) opposite += piece.area;
  }
  return std::min(same, opposite) > 0.1 * size * size;
}

}  // namespace crossgrain
