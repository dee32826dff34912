// SPDX-License-Identifier: Apache-2.0
#include "sampling/model_boundary.hpp"

#include "base/vector3.hpp"
#include "surface/solid_split.hpp"

namespace crossgrain {
namespace {

MendedSurface mended_outside(const TriangleMesh& mesh) {
  check_mesh(mesh);
  const SolidSplit split = split_solids(mesh, true);
  return mend_surface(split.outer ? *split.outer : mesh);
}

}  // namespace

ModelBoundary::ModelBoundary(const TriangleMesh& mesh)
    : mended_(mended_outside(mesh)), bvh_(mended_.surface), winding_(mended_.surface, bvh_) {}

double ModelBoundary::share_to(const Vector3& from, const Vector3& to) const {
  if (from == to) return 1;  // no ray
  const auto hit = bvh_.first_hit(from, to - from, 0, 1);
  return hit ? hit->t : 1;
}

}  // namespace crossgrain
