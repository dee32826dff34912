// SPDX-License-Identifier: Apache-2.0
#include "remeshing/closed_bodies.hpp"

#include <limits>
#include <span>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/edge_uses.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

struct Shell {
  std::vector<std::uint32_t> triangles;
  double volume = 0;  ///< negative if it looks inwards
};

std::vector<Shell> shells_of(const PatchedSurface& surface) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(surface.triangles);
  DisjointSets joined(surface.triangles.size());
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge) joined.join(edge[0].triangle, use.triangle);
  });
  std::vector<Shell> shells;
  std::vector<std::size_t> shell_of(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const std::uint32_t root = joined.root(t);
    if (root == t) {
      shell_of[t] = shells.size();
      shells.emplace_back();
    }
    shell_of[t] = shell_of[root];
    Shell& shell = shells[shell_of[t]];
    shell.triangles.push_back(t);
    const auto [a, b, c] = corners_of(surface.triangles[t], surface.vertices);
    const Vector3& origin = surface.vertices[surface.triangles[shell.triangles.front()][0]];
    shell.volume += dot(a - origin, cross(b - origin, c - origin)) / 6;
  }
  return shells;
}

/// Whether the first triangle of a shell lies inside another one.
bool encloses(const PatchedSurface& surface, const Shell& outer, const Shell& inner) {
  TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  for (const std::uint32_t t : outer.triangles) mesh.triangles.push_back(surface.triangles[t]);
  const Surface shell = prepare_surface(CheckedMesh::derived(std::move(mesh)));
  const TriangleBvh tree(shell);
  const auto [a, b, c] = corners_of(surface.triangles[inner.triangles.front()], surface.vertices);
  return WindingNumber(tree).inside((1.0 / 3) * (a + b + c));
}

}  // namespace

std::vector<ClosedBody> bodies_of(const PatchedSurface& surface) {
  const std::vector<Shell> shells = shells_of(surface);
  std::vector<std::size_t> owner(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s) {
    owner[s] = s;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t o = 0; shells[s].volume < 0 && o < shells.size(); ++o) {
      if (shells[o].volume <= 0 || shells[o].volume >= least || !encloses(surface, shells[o], shells[s]))
        continue;
      least = shells[o].volume;
      owner[s] = o;
    }
  }
  // Shells are in the order of their first triangles.
  std::vector<ClosedBody> all(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (owner[s] == s) all[s].shells.push_back(shells[s].triangles);
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (owner[s] != s) all[owner[s]].shells.push_back(shells[s].triangles);
  std::erase_if(all, [](const ClosedBody& body) { return body.shells.empty(); });
  return all;
}

}  // namespace crossgrain
