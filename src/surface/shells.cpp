// SPDX-License-Identifier: Apache-2.0
#include "surface/shells.hpp"

#include <algorithm>
#include <cstddef>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {
namespace {

std::uint32_t corner_at(std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t triangle,
                        std::uint32_t vertex) {
  const auto& corners = triangles[triangle];
  return static_cast<std::uint32_t>(3 * triangle + (std::ranges::find(corners, vertex) - corners.begin()));
}

}  // namespace

std::vector<int> euler_numbers_of_shells(std::span<const std::array<std::uint32_t, 3>> triangles) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(triangles);
  DisjointSets shells(triangles.size());
  DisjointSets fans(3 * triangles.size());
  bool is_closed = true;
  Checkpoint checkpoint;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    checkpoint.pass();
    is_closed = is_closed && edge.size() == 2;
    if (!is_closed) return;
    shells.join(edge[0].triangle, edge[1].triangle);
    for (const std::uint32_t vertex : {edge[0].low(), edge[0].high()})
      fans.join(corner_at(triangles, edge[0].triangle, vertex),
                corner_at(triangles, edge[1].triangle, vertex));
  });
  if (!is_closed) return {};
  std::vector<int> doubled(triangles.size(), 0);  // of vertices - edges + triangles, by the shell's root
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    checkpoint.pass();
    if (is_collapsed(triangles[t])) continue;
    int& sum = doubled[shells.root(t)];
    sum += 2 - 3;
    for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner)
      sum += fans.root(corner) == corner ? 2 : 0;
  }
  std::vector<int> numbers;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (shells.root(t) == t && !is_collapsed(triangles[t])) numbers.push_back(doubled[t] / 2);
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<ShellBody> bodies_in(std::span<const std::array<std::uint32_t, 3>> triangles,
                                 std::span<const Vector3> vertices) {
  DisjointSets shells(triangles.size());
  for_each_edge(sorted_edge_uses(triangles), [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge) shells.join(edge[0].triangle, use.triangle);
  });
  std::vector<ShellBody> all(triangles.size(), {empty_box(), 0});  // by the shell's root
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t root = shells.root(t);
    const Vector3& apex = vertices[triangles[root][0]];
    const auto& [a, b, c] = triangles[t];
    all[root].volume += dot(vertices[a] - apex, cross(vertices[b] - apex, vertices[c] - apex)) / 6;
    for (const std::uint32_t v : triangles[t]) include(all[root].box, vertices[v]);
  }
  std::erase_if(all, [](const ShellBody& body) { return !(body.volume > 0); });
  return all;
}

}  // namespace crossgrain
