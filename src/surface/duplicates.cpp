// SPDX-License-Identifier: Apache-2.0
#include "surface/duplicates.hpp"

#include <algorithm>
#include <array>

#include "base/ascending.hpp"
#include "base/disjoint_sets.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns whether the corners are in sorted order up to a cyclic shift.
bool is_even(const Triangle& c) {
  return (c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0]) == 2;
}

Vector3 mean_of_corners(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  Vector3 centroid;
  for (std::size_t k = 0; k < 3; ++k)
    centroid[k] = (mesh.vertices[a][k] + mesh.vertices[b][k] + mesh.vertices[c][k]) / 3;
  return centroid;
}

/// Triangles with the same vertices, ascending; the first represents all.
struct Stack {
  std::vector<std::uint32_t> triangles;
  bool looks_both_ways = false;
};

/// Returns stacks of two or more triangles, ordered by their first triangle.
std::vector<Stack> stacks_of(const TriangleMesh& mesh, const std::vector<TriangleRole>& roles) {
  std::vector<std::pair<Triangle, std::uint32_t>> keys;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (roles[t] == TriangleRole::kSurface) keys.emplace_back(ascending(mesh.triangles[t]), t);
  std::sort(keys.begin(), keys.end());
  std::vector<Stack> stacks;
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    while (end < keys.size() && keys[end].first == keys[begin].first) ++end;
    if (end - begin < 2) continue;
    Stack stack;
    for (std::size_t k = begin; k < end; ++k) stack.triangles.push_back(keys[k].second);
    for (const std::uint32_t t : stack.triangles)
      stack.looks_both_ways |= is_even(mesh.triangles[t]) != is_even(mesh.triangles[stack.triangles[0]]);
    stacks.push_back(std::move(stack));
  }
  std::sort(stacks.begin(), stacks.end(),
            [](const Stack& a, const Stack& b) { return a.triangles[0] < b.triangles[0]; });
  return stacks;
}

/// Returns for each stack whether its set of connected stacks is a wall between two parts.
std::vector<bool> find_walls(const TriangleMesh& mesh, const std::vector<TriangleRole>& roles,
                             const std::vector<Stack>& stacks) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<std::uint32_t> stack_of(mesh.triangles.size(), kNone);
  for (std::uint32_t s = 0; s < stacks.size(); ++s) stack_of[stacks[s].triangles[0]] = s;
  // Visit each stack once.
  std::vector<std::uint32_t> origin;
  std::vector<Triangle> distinct;
  std::vector<bool> repeated(mesh.triangles.size());
  for (const Stack& stack : stacks)
    for (std::size_t k = 1; k < stack.triangles.size(); ++k) repeated[stack.triangles[k]] = true;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (roles[t] == TriangleRole::kDropped || repeated[t]) continue;
    origin.push_back(t);
    distinct.push_back(mesh.triangles[t]);
  }
  const std::vector<EdgeUse> uses = sorted_edge_uses(distinct);
  const auto stack_at = [&](const EdgeUse& use) { return stack_of[origin[use.triangle]]; };

  DisjointSets sets(stacks.size());
  std::vector<bool> has_rim(stacks.size()), is_no_wall(stacks.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    std::uint32_t first = kNone;
    for (const EdgeUse& use : edge) {
      const std::uint32_t s = stack_at(use);
      if (s == kNone) continue;
      if (edge.size() > 2) {
        has_rim[s] = true;
      } else if (edge.size() == 1 || stack_at(edge[0]) == kNone || stack_at(edge[1]) == kNone) {
        is_no_wall[s] = true;
      } else if (first == kNone) {
        first = s;
      } else {
        sets.join(first, s);
      }
    }
  });
  std::vector<bool> set_has_rim(stacks.size()), set_is_no_wall(stacks.size()), result(stacks.size());
  for (std::uint32_t s = 0; s < stacks.size(); ++s) {
    if (has_rim[s]) set_has_rim[sets.root(s)] = true;
    if (is_no_wall[s] || !stacks[s].looks_both_ways) set_is_no_wall[sets.root(s)] = true;
  }
  for (std::uint32_t s = 0; s < stacks.size(); ++s)
    result[s] = set_has_rim[sets.root(s)] && !set_is_no_wall[sets.root(s)];
  return result;
}

}  // namespace

std::vector<TriangleRole> find_duplicates(const TriangleMesh& mesh, SurfaceFindings& findings) {
  std::vector<TriangleRole> roles(mesh.triangles.size(), TriangleRole::kSurface);
  for (std::size_t t = 0; t < roles.size(); ++t)
    if (is_collapsed(mesh.triangles[t])) roles[t] = TriangleRole::kDropped;
  const std::vector<Stack> stacks = stacks_of(mesh, roles);
  if (stacks.empty()) return roles;
  const std::vector<bool> is_wall = find_walls(mesh, roles, stacks);
  Tally duplicates;
  for (std::size_t s = 0; s < stacks.size(); ++s) {
    const std::vector<std::uint32_t>& triangles = stacks[s].triangles;
    bool opposite_is_there = false;
    if (is_wall[s]) roles[triangles[0]] = TriangleRole::kInternalSheet;
    for (std::size_t k = 1; k < triangles.size(); ++k) {
      const bool opposite = is_even(mesh.triangles[triangles[k]]) != is_even(mesh.triangles[triangles[0]]);
      if (is_wall[s] && opposite && !opposite_is_there) {
        opposite_is_there = true;
        roles[triangles[k]] = TriangleRole::kInternalSheet;
        continue;
      }
      roles[triangles[k]] = TriangleRole::kDropped;
      duplicates.add(mean_of_corners(mesh, triangles[k]));
    }
  }
  duplicates.report(findings, FindingKind::kDuplicatedTriangle);
  return roles;
}

}  // namespace crossgrain
