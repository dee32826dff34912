// SPDX-License-Identifier: Apache-2.0
// Directions that frames at vertices of a tet mesh should follow.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "constraint/normal_form.hpp"
#include "field/field_graph.hpp"

namespace crossgrain {

struct VertexGuide {
  std::uint32_t vertex;
  Vector3 direction;  ///< unit
  double weight;      ///< as in a constraint
};

/// Weight of a guide of weight 1, relative to the sum of the vertex's edge weights. It is that of the grid,
/// where a cell of size dx has six faces of weight dx and a constraint has the weight kappa dx, kappa = 10.
inline constexpr double kGuideWeight = 10.0 / 6;

/// Returns the vertices that have guides, each once; guides must be ordered by vertex.
inline std::vector<std::uint32_t> guided_vertices(std::span<const VertexGuide> guides) {
  std::vector<std::uint32_t> vertices;
  for (const VertexGuide& guide : guides) {
    if (vertices.empty() || vertices.back() != guide.vertex) vertices.push_back(guide.vertex);
  }
  return vertices;
}

/// Sets the forms of vertices with guides. They must have been reserved (CellForms::reserve_general).
template <int D>
void set_guides(CellForms<D>& forms, const Adjacency& adjacency, std::span<const VertexGuide> guides) {
  constexpr double kDegreeFactor = D == 3 ? 5.0 / 3 : 1.0;
  for (std::size_t first = 0, last = 0; first < guides.size(); first = last) {
    const std::uint32_t vertex = guides[first].vertex;
    QuadraticForm<D> form;
    for (; last < guides.size() && guides[last].vertex == vertex; ++last)
      add_axis(form, guides[last].direction, guides[last].weight);
    double edge_weight = 0;
    for (const Adjacency::Neighbour& neighbour : adjacency[vertex]) edge_weight += std::abs(neighbour.weight);
    forms.set_general(vertex, form, kDegreeFactor * kGuideWeight * edge_weight);
  }
}

}  // namespace crossgrain
