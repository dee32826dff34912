// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_carriers.hpp"

#include <utility>

#include "base/disjoint_sets.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

using Kind = HexCarrier::Kind;

std::vector<std::uint32_t> joined_faces(const FeatureComplex& complex,
                                        const std::vector<std::vector<std::uint32_t>>& path_of_curve) {
  DisjointSets sets(complex.faces.size());
  for (std::size_t c = 0; c < complex.curves.size(); ++c) {
    if (!path_of_curve[c].empty()) continue;
    const auto& sides = complex.curves[c].sides;
    for (std::size_t k = 1; k < sides.size(); ++k) sets.join(sides[0].face, sides[k].face);
  }
  std::vector<std::uint32_t> groups(complex.faces.size());
  for (std::uint32_t f = 0; f < groups.size(); ++f) groups[f] = static_cast<std::uint32_t>(sets.root(f));
  return groups;
}

}  // namespace

HexCarriers carriers_on(std::size_t vertices, const FeatureComplex& complex,
                        const std::vector<std::uint32_t>& vertex_of_corner,
                        std::vector<std::vector<std::uint32_t>> path_of_curve,
                        std::vector<HexCarriers::Quad> quads_with_faces) {
  HexCarriers carriers;
  carriers.of_vertex.resize(vertices);
  carriers.group_of_face = joined_faces(complex, path_of_curve);
  carriers.quads = std::move(quads_with_faces);
  for (HexCarriers::Quad& quad : carriers.quads) {
    quad.group = carriers.group_of_face[quad.group];
    for (const std::uint32_t v : quad.vertices) carriers.of_vertex[v] = {Kind::kFace, quad.group};
  }
  for (std::uint32_t c = 0; c < path_of_curve.size(); ++c)
    for (const std::uint32_t v : path_of_curve[c]) carriers.of_vertex[v] = {Kind::kCurve, c};
  for (std::uint32_t c = 0; c < vertex_of_corner.size(); ++c)
    if (vertex_of_corner[c] != FeatureComplex::kNone)
      carriers.of_vertex[vertex_of_corner[c]] = {Kind::kCorner, c};
  carriers.path_of_curve = std::move(path_of_curve);
  return carriers;
}

HexCarriers carriers_without_features(const HexMesh& mesh, const FeatureComplex& complex) {
  HexCarriers carriers;
  carriers.of_vertex.resize(mesh.vertices.size());
  carriers.path_of_curve.resize(complex.curves.size());
  carriers.group_of_face.assign(complex.faces.size(), 0);
  for (const HexSide& side : boundary_of(mesh)) {
    carriers.quads.push_back({side.vertices, 0});
    for (const std::uint32_t v : side.vertices) carriers.of_vertex[v] = {Kind::kFace, 0};
  }
  return carriers;
}

}  // namespace crossgrain
