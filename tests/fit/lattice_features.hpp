// SPDX-License-Identifier: Apache-2.0
// The features of a mesh's own surface.
#pragma once

#include <cstdint>
#include <functional>

#include "fit/quad_complex.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain::testing {

/// Features of the surface of hexahedra, each quad cut into two triangles; `number(quad)` is that of its
/// face. All curves are sharp if `are_sharp`.
inline FeatureComplex features_of(const HexMesh& mesh, const std::function<int(std::uint32_t quad)>& number,
                                  bool are_sharp = false) {
  const QuadComplex quads(mesh);
  TriangleMesh surface;
  surface.vertices = mesh.vertices;
  for (std::uint32_t q = 0; q < quads.quads().size(); ++q) {
    const auto& [a, b, c, d] = quads.quads()[q].vertices;
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({a, c, d});
    surface.faces.insert(surface.faces.end(), 2, number(q));
  }
  FeatureComplex features = feature_complex(prepare_surface(CheckedMesh(std::move(surface))));
  for (FeatureComplex::Curve& curve : features.curves) curve.is_soft = curve.is_soft && !are_sharp;
  return features;
}

}  // namespace crossgrain::testing
