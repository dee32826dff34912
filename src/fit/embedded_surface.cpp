// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/ascending.hpp"
#include "fit/embedding.hpp"

namespace crossgrain {

std::vector<std::int32_t> solids_of_hexahedra(const HexMesh& mesh, const FeatureComplex& features) {
  std::vector<std::int32_t> solids;
  for (const FeatureComplex::Face& face : features.faces)
    solids.insert(solids.end(), {face.below, face.above});
  sort_uniquely(solids);
  std::erase(solids, 0);
  if (solids.size() <= 1 || mesh.regions.empty())
    return std::vector<std::int32_t>(mesh.hexahedra.size(), solids.empty() ? 1 : solids[0]);
  std::vector<std::int32_t> of_hexahedra = mesh.regions;
  for (std::int32_t& solid : of_hexahedra) ++solid;
  return of_hexahedra;
}

QuadComplex surface_of(const HexMesh& mesh, const FeatureComplex& features) {
  return QuadComplex(mesh, solids_of_hexahedra(mesh, features));
}

}  // namespace crossgrain
