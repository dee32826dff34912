// SPDX-License-Identifier: Apache-2.0
#include "surface/feature_surface.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/patch_sides.hpp"
#include "surface/solid_split.hpp"
#include "surface/topology.hpp"

namespace crossgrain {

FeatureSurface feature_surface(const Surface& surface, bool unite_solids) {
  SolidSplit split = split_solids(CheckedMesh::derived(surface.mesh), unite_solids);
  const bool one_solid = unite_solids || surface.mesh.solids.empty();
  const auto number_of = [&](std::int32_t solid) { return one_solid ? 1 : solid + 1; };
  std::vector<std::uint8_t> is_left_out(surface.size(), 0);
  std::vector<std::int32_t> above(surface.size(), 0);
  for (const SolidSplit::Between& pair : split.between) {
    is_left_out[pair.sources[0]] = 1;
    is_left_out[pair.sources[1]] = unite_solids;
    above[pair.sources[1]] = number_of(pair.solids[0]);
  }
  FeatureSurface result;
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    if (is_left_out[t]) continue;
    result.source_of.push_back(t);
    result.solids.push_back({number_of(surface.mesh.solids.empty() ? 0 : surface.mesh.solids[t]), above[t]});
    result.surface.normals.push_back(surface.normals[t]);
    result.surface.areas.push_back(surface.areas[t]);
  }
  TriangleMesh mesh = selected_triangles(surface.mesh, result.source_of);
  mesh.inner_faces.clear();
  mesh.creases = std::move(*std::move(split.outer)).creases;
  const std::vector<std::uint32_t> first = first_equal_vertices(mesh.vertices);
  parallel_for(mesh.triangles.size(), [&](std::size_t t) {
    for (std::uint32_t& v : mesh.triangles[t]) v = first[v];
  });
  result.surface.mesh = std::move(mesh);
  result.surface.box = surface.box;
  return result;
}

}  // namespace crossgrain
