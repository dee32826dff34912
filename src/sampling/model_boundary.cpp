// SPDX-License-Identifier: Apache-2.0
#include "sampling/model_boundary.hpp"

#include "base/vector3.hpp"
#include "surface/solid_split.hpp"

namespace crossgrain {
ModelBoundary::ModelBoundary(const TriangleMesh& mesh)
    : surface_(std::make_shared<const SearchableSurface>(mend_surface(split_solids(mesh, true).outer))) {}

double ModelBoundary::share_to(const Vector3& from, const Vector3& to) const {
  if (from == to) return 1;  // a ray needs a direction
  const auto hit = surface_->bvh().first_hit(from, to - from, 0, 1);
  return hit ? hit->t : 1;
}

}  // namespace crossgrain
