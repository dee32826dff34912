// SPDX-License-Identifier: Apache-2.0
#include "grid/open_faces.hpp"

#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// +1 where the segment from a to b enters the solid through the triangle, -1 where it leaves, 0 where it
/// misses.
int crossing(const std::array<Vector3, 3>& corners, const Vector3& a, const Vector3& b) {
  const Vector3 direction = b - a;
  const Vector3 edge1 = corners[1] - corners[0], edge2 = corners[2] - corners[0];
  const Vector3 p = cross(direction, edge2);
  const double determinant = dot(edge1, p);  // -direction . (edge1 x edge2)
  if (determinant == 0) return 0;
  const Vector3 s = a - corners[0];
  const double u = dot(s, p) / determinant;
  if (u < 0 || u > 1) return 0;
  const Vector3 q = cross(s, edge1);
  const double v = dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return 0;
  const double t = dot(edge2, q) / determinant;
  if (t < 0 || t > 1) return 0;
  return determinant > 0 ? 1 : -1;
}

}  // namespace

double open_fraction(const GridLevel& level, const Solid& solid, CellIndex i, int face) {
  const auto pieces = level.pieces_of(i);
  if (pieces.empty()) return 1;
  const int orientation = solid.winding.flipped() ? -1 : 1;
  const double size = level.tree.cell_size(i);
  const Vector3 centre = level.tree.centre(i);
  const int axis = face_axis(face), axis1 = (axis + 1) % 3, axis2 = (axis + 2) % 3;
  int open = 0;
  for (int a = 0; a < kOpenFaceSamples; ++a) {
    for (int b = 0; b < kOpenFaceSamples; ++b) {
      Vector3 point = centre;
      point[axis] += 0.5 * face_sign(face) * size;
      point[axis1] += ((a + 0.5) / kOpenFaceSamples - 0.5) * size;
      point[axis2] += ((b + 0.5) / kOpenFaceSamples - 0.5) * size;
      int winding = level.centre_inside[i];
      for (const SurfacePiece& piece : pieces) {
        winding += orientation * crossing(solid.surface.corners(piece.triangle), centre, point);
      }
      open += winding > 0;
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
