// SPDX-License-Identifier: Apache-2.0
#include "grid/local_thickness.hpp"

#include "base/vector3.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {

namespace {

/// Whether a ray is still in the solids where it has left one: those that touch reach into each other by what
/// their triangles are off the true surface.
bool goes_on(const Solid& solid, std::uint32_t from, std::uint32_t to, const Vector3& beyond) {
  const std::vector<std::int32_t>& solids = solid.surface.mesh.solids;
  return !solids.empty() && solids[from] != solids[to] && solid.winding.inside(beyond);
}

}  // namespace

std::optional<InwardRay> inward_ray(const GridLevel& level, const Solid& solid, CellIndex i, double longest) {
  const SurfacePiece* largest = nullptr;
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    if (!largest || piece.area > largest->area) largest = &piece;
  }
  if (!largest) return std::nullopt;
  const Box box = level.tree.root().box(level.tree[i]);
  const Vector3 origin = clip_triangle(solid.surface.corners(largest->triangle), box).centroid;
  const Vector3 direction = -solid.outward_normal(largest->triangle);
  // The origin is off the surface by rounding only, which is less than a millionth of a cell.
  const double start = 1e-6 * level.tree.cell_size(i);
  auto hit = solid.bvh.first_hit(origin, direction, start, longest);
  while (hit && goes_on(solid, largest->triangle, hit->triangle, origin + (hit->t + start) * direction))
    hit = solid.bvh.first_hit(origin, direction, hit->t + start, longest);
  return InwardRay{origin, direction, hit ? hit->t : std::numeric_limits<double>::infinity(),
                   hit ? hit->triangle : 0};
}

}  // namespace crossgrain
