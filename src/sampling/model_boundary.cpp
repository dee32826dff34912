// SPDX-License-Identifier: Apache-2.0
#include "sampling/model_boundary.hpp"

#include "base/vector3.hpp"
#include "surface/solid_split.hpp"

namespace crossgrain {
ModelBoundary::ModelBoundary(const TriangleMesh& mesh)
    : mended_(mend_surface(split_solids(mesh, true).outer)),
      bvh_(mended_.surface),
      winding_(mended_.surface, bvh_) {}

double ModelBoundary::share_to(const Vector3& from, const Vector3& to) const {
  if (from == to) return 1;  // a ray needs a direction
  const auto hit = bvh_.first_hit(from, to - from, 0, 1);
  return hit ? hit->t : 1;
}

}  // namespace crossgrain
