// SPDX-License-Identifier: Apache-2.0
#include "meshing/shown_surface.hpp"

#include <utility>
#include <vector>

namespace crossgrain {

std::shared_ptr<const SolvedSurface> shown_surface(const FeatureComplex& features) {
  SolvedSurface surface;
  surface.vertices = features.vertices;
  surface.triangles = features.triangles;
  for (const FeatureComplex::Curve& curve : features.curves) {
    if (curve.is_soft) continue;
    std::vector<Vector3>& crease = surface.creases.emplace_back();
    for (const std::uint32_t vertex : curve.vertices) crease.push_back(features.vertices[vertex]);
  }
  for (const std::uint32_t face : features.face_of) surface.faces.push_back(features.faces[face].number);
  return std::make_shared<const SolvedSurface>(std::move(surface));
}

}  // namespace crossgrain
