// SPDX-License-Identifier: Apache-2.0
#include "grid/open_faces.hpp"

#include <algorithm>

#include "base/vector3.hpp"
#include "grid/winding_in_leaf.hpp"

namespace crossgrain {
namespace {

/// Distance, in cells, by which a sample moves if its segment meets an edge of the surface: faces at round
/// coordinates are often cut along lines through many samples.
constexpr double kNudge1 = 0.0137, kNudge2 = 0.0071;

/// Returns the samples of a face, moved by `nudge` times that distance.
PointsByAxis<kOpenFaceSamples> samples_of(const GridLevel& level, CellIndex i, int face, double nudge) {
  const double size = level.tree.cell_size(i);
  const int axis = face_axis(face), axis1 = (axis + 1) % 3, axis2 = (axis + 2) % 3;
  const Vector3 centre = level.tree.centre(i);
  const auto along = [](int sample) { return (sample + 0.5) / kOpenFaceSide - 0.5; };
  PointsByAxis<kOpenFaceSamples> points;
  std::size_t k = 0;
  for (int a = 0; a < kOpenFaceSide; ++a) {
    for (int b = 0; b < kOpenFaceSide; ++b, ++k) {
      points[axis][k] = centre[axis] + 0.5 * face_sign(face) * size;
      points[axis1][k] = centre[axis1] + (along(a) + nudge * kNudge1) * size;
      points[axis2][k] = centre[axis2] + (along(b) + nudge * kNudge2) * size;
    }
  }
  return points;
}

}  // namespace

int open_samples(const GridLevel& level, const Solid& solid, CellIndex i, int face) {
  if (!level.holds_surface(i)) return kOpenFaceSamples;
  auto found = winding_changes(level, solid, i, samples_of(level, i, face, 0));
  if (std::find(found.certain.begin(), found.certain.end(), false) != found.certain.end()) {
    const auto nudged = winding_changes(level, solid, i, samples_of(level, i, face, 1));
    for (std::size_t k = 0; k < kOpenFaceSamples; ++k) {
      if (!found.certain[k]) found.change[k] = nudged.certain[k] ? nudged.change[k] : 0;
    }
  }
  return static_cast<int>(std::count_if(found.change.begin(), found.change.end(),
                                        [&](int change) { return level.centre_winding[i] + change > 0; }));
}

bool holds_two_sheets(const GridLevel& level, const Solid& solid, CellIndex i) {
  const auto pieces = level.pieces_of(i);
  const double size = level.tree.cell_size(i);
  // Pieces are compared with the largest one only, so that the cost is linear.
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
