// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_splits.hpp"

#include <algorithm>
#include <utility>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

template <class Element>
auto vertices_of(const std::vector<Element>& elements) {
  std::vector<decltype(Element::vertices)> vertices;
  vertices.reserve(elements.size());
  for (const Element& element : elements) vertices.push_back(element.vertices);
  return vertices;
}

/// Elements with these vertices, and all else from the given elements of which they are parts.
template <class Element, std::size_t kCorners>
std::vector<Element> inherited(const std::vector<Element>& given, const SplitSimplices<kCorners>& split) {
  std::vector<Element> elements;
  elements.reserve(split.simplices().size());
  for (std::size_t k = 0; k < split.simplices().size(); ++k) {
    elements.push_back(given[split.parents()[k]]);
    elements.back().vertices = split.simplices()[k];
  }
  return elements;
}

/// Division keeps a coordinate that all points share, which multiplication by a third would not.
Vector3 mean_of(std::span<const std::uint32_t> vertices, const std::vector<Vector3>& points) {
  Vector3 sum{0, 0, 0};
  for (const std::uint32_t v : vertices) sum += points[v];
  const double count = static_cast<double>(vertices.size());
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

}  // namespace

TetSplits::TetSplits(TetMesh mesh)
    : given_(std::move(mesh)),
      tets_(std::move(given_.tets)),
      tagged_faces_(vertices_of(given_.feature_faces)),
      tagged_edges_(vertices_of(given_.feature_edges)) {}

std::optional<std::uint32_t> TetSplits::split_edge(std::uint32_t a, std::uint32_t b) {
  return split(std::array{a, b});
}

std::optional<std::uint32_t> TetSplits::split_face(const std::array<std::uint32_t, 3>& vertices) {
  return split(vertices);
}

std::optional<std::uint32_t> TetSplits::split_tet(std::uint32_t tet) {
  const std::array<std::uint32_t, 4> vertices = tets()[tet];
  return split(vertices);
}

std::optional<std::uint32_t> TetSplits::split(std::span<const std::uint32_t> vertices) {
  MeanOfVertices mean;
  mean.count = static_cast<std::uint8_t>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), mean.vertices.begin());
  mean.vertices = ascending(mean.vertices);  // so that sums round alike for any order
  const bool distinct = std::adjacent_find(mean.used().begin(), mean.used().end()) == mean.used().end();
  const std::vector<std::uint32_t> around = tets_.around(mean.used());
  if (!distinct || around.empty()) return std::nullopt;
  const auto centre = static_cast<std::uint32_t>(given_.vertices.size());
  given_.vertices.push_back(mean_of(mean.used(), given_.vertices));
  if (!std::all_of(around.begin(), around.end(),
                   [&](std::uint32_t t) { return keeps_shape(t, mean.used()); })) {
    given_.vertices.pop_back();
    return std::nullopt;
  }
  tets_.split(mean.used(), around, centre);
  if (mean.count <= 3) tagged_faces_.split(mean.used(), tagged_faces_.around(mean.used()), centre);
  if (mean.count == 2) tagged_edges_.split(mean.used(), tagged_edges_.around(mean.used()), centre);
  new_vertices_.push_back(mean);
  return centre;
}

bool TetSplits::keeps_shape(std::uint32_t tet, std::span<const std::uint32_t> vertices) const {
  const auto centre = static_cast<std::uint32_t>(given_.vertices.size() - 1);
  const std::array<std::uint32_t, 4>& corners = tets()[tet];
  const TetShape shape = shape_of_tet(given_.vertices, corners);
  if (shape == TetShape::kFlat) return true;
  return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
    return shape_of_tet(given_.vertices, SplitSimplices<4>::with_centre(corners, v, centre)) == shape;
  });
}

SplitTetMesh TetSplits::result() const {
  SplitTetMesh out{given_, parents(), new_vertices_};
  out.mesh.tets = tets();
  out.mesh.feature_faces = inherited(given_.feature_faces, tagged_faces_);
  out.mesh.feature_edges = inherited(given_.feature_edges, tagged_edges_);
  if (given_.regions.empty()) return out;
  out.mesh.regions.clear();
  for (const std::uint32_t parent : parents()) out.mesh.regions.push_back(given_.regions[parent]);
  return out;
}

}  // namespace crossgrain
