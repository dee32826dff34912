// SPDX-License-Identifier: Apache-2.0
#include "surface/solid_split.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "base/vector3.hpp"
#include "surface/creases.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle with its corners in ascending order; `even` tells whether that is an even permutation.
struct SortedCorners {
  Triangle corners;
  bool even;
  std::uint32_t triangle;

  friend bool operator<(const SortedCorners& a, const SortedCorners& b) {
    return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
  }
};

SortedCorners sorted_corners(const Triangle& t, const std::vector<std::uint32_t>& first,
                             std::uint32_t index) {
  Triangle corners{first[t[0]], first[t[1]], first[t[2]]};
  bool even = true;
  const auto order = [&](std::size_t a, std::size_t b) {
    if (corners[a] <= corners[b]) return;
    std::swap(corners[a], corners[b]);
    even = !even;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {corners, even, index};
}

/// Two triangles; that of the solid of lower number is first.
using Pair = std::array<std::uint32_t, 2>;

/// Pairs triangles with the same corners.
void pair_up(std::span<const SortedCorners> same, const std::vector<std::int32_t>& solids,
             std::vector<Pair>& pairs, std::vector<bool>& paired) {
  for (const SortedCorners& a : same) {
    if (paired[a.triangle]) continue;
    const auto b = std::find_if(same.begin(), same.end(), [&](const SortedCorners& other) {
      return other.triangle > a.triangle && !paired[other.triangle] && other.even != a.even &&
             solids[other.triangle] != solids[a.triangle];
    });
    if (b == same.end()) continue;
    paired[a.triangle] = paired[b->triangle] = true;
    const bool in_order = solids[a.triangle] < solids[b->triangle];
    pairs.push_back(in_order ? Pair{a.triangle, b->triangle} : Pair{b->triangle, a.triangle});
  }
}

std::vector<Pair> separating_pairs(const TriangleMesh& mesh, std::vector<bool>& paired) {
  const std::vector<std::uint32_t> first = first_equal_vertices(mesh.vertices);
  std::vector<SortedCorners> sorted;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const SortedCorners corners = sorted_corners(mesh.triangles[t], first, t);
    if (!is_collapsed(corners.corners)) sorted.push_back(corners);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Pair> pairs;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].corners == sorted[begin].corners) ++end;
    if (end - begin > 1) pair_up(std::span(sorted).subspan(begin, end - begin), mesh.solids, pairs, paired);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return std::minmax(a[0], a[1]) < std::minmax(b[0], b[1]); });
  return pairs;
}

/// Appends a triangle unless it has no area and hence no normal.
void append_inner(const TriangleMesh& mesh, const Triangle& triangle,
                  const std::array<Vector3, 3>* corner_normals, TriangleMesh& inner) {
  const TriangleShape shape = shape_of(corners_of(triangle, mesh.vertices));
  if (shape.area == 0) return;
  inner.triangles.push_back(triangle);
  inner.corner_normals.push_back(
      corner_normals != nullptr ? *corner_normals : std::array{shape.normal, shape.normal, shape.normal});
}

TriangleMesh without(TriangleMesh mesh, const std::vector<bool>& left_out) {
  const auto keep = [&](auto& entries) {
    if (entries.empty()) return;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < left_out.size(); ++t) {
      if (!left_out[t]) entries[kept++] = entries[t];
    }
    entries.resize(kept);
  };
  keep(mesh.triangles);
  keep(mesh.faces);
  keep(mesh.solids);
  keep(mesh.corner_normals);
  return mesh;
}

/// The ends of a straight piece of a curve in ascending order.
using Piece = std::pair<Vector3, Vector3>;

Piece piece_between(const Vector3& a, const Vector3& b) {
  return a < b ? Piece{a, b} : Piece{b, a};
}

/// Returns the edges at which normals differ by more than CreaseAngles::least_deg.
std::set<Piece> sharp_pieces(const TriangleMesh& mesh) {
  const double least_cosine = std::cos(CreaseAngles{}.least_deg * std::numbers::pi / 180);
  const std::vector<EdgeUse> all_uses = sorted_edge_uses(mesh.triangles);
  const auto normal_along = [&](const EdgeUse& use) {
    const Vector3 normal = shape_of(corners_of(mesh.triangles[use.triangle], mesh.vertices)).normal;
    return use.forward ? normal : -normal;
  };
  std::set<Piece> pieces;
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    for (std::size_t k = 1; k < uses.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        if (-dot(normal_along(uses[j]), normal_along(uses[k])) < least_cosine)
          pieces.insert(piece_between(mesh.vertices[uses[0].low()], mesh.vertices[uses[0].high()]));
      }
    }
  });
  return pieces;
}

std::vector<CreaseCurve> creases_of_union(const TriangleMesh& outer,
                                          std::span<const SolidSplit::Between> between) {
  std::set<Piece> between_solids;
  for (const auto& [t, solids, sources] : between) {
    for (std::size_t k = 0; k < 3; ++k)
      between_solids.insert(piece_between(outer.vertices[t[k]], outer.vertices[t[(k + 1) % 3]]));
  }
  const std::set<Piece> sharp = sharp_pieces(outer);
  const auto runs_along = [](const CreaseCurve& curve, const std::set<Piece>& pieces) {
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      if (pieces.contains(piece_between(curve.points[k], curve.points[k + 1]))) return true;
    }
    return false;
  };
  std::vector<CreaseCurve> creases = outer.creases;
  std::erase_if(creases, [&](const CreaseCurve& curve) {
    return runs_along(curve, between_solids) && !runs_along(curve, sharp);
  });
  return creases;
}

}  // namespace

bool has_several_solids(const TriangleMesh& mesh) {
  return std::adjacent_find(mesh.solids.begin(), mesh.solids.end(), std::not_equal_to<>()) !=
         mesh.solids.end();
}

SolidSplit split_solids(CheckedMesh mesh, bool unite) {
  TriangleMesh inner;
  inner.vertices = mesh->vertices;
  std::vector<bool> paired(mesh->triangles.size());
  std::vector<SolidSplit::Between> between;
  if (has_several_solids(*mesh)) {
    for (const auto& [owner, other] : separating_pairs(*mesh, paired)) {
      between.push_back({mesh->triangles[owner], {mesh->solids[owner], mesh->solids[other]}, {owner, other}});
      if (!unite)
        append_inner(*mesh, between.back().triangle,
                     mesh->corner_normals.empty() ? nullptr : &mesh->corner_normals[owner], inner);
    }
  }
  for (const Triangle& triangle : mesh->inner_faces) append_inner(*mesh, triangle, nullptr, inner);
  if (between.empty()) return {std::move(mesh), std::move(inner), {}};
  TriangleMesh outer = without(*std::move(mesh), paired);
  if (unite) outer.creases = creases_of_union(outer, between);
  return {CheckedMesh::derived(std::move(outer)), std::move(inner), std::move(between)};
}

std::vector<GuideFace> guides_across(const TriangleMesh& inner) {
  std::vector<GuideFace> guides;
  for (std::size_t t = 0; t < inner.triangles.size(); ++t)
    guides.push_back({corners_of(inner.triangles[t], inner.vertices), inner.corner_normals[t], 1});
  return guides;
}

}  // namespace crossgrain
