// SPDX-License-Identifier: Apache-2.0
#include "fit/embedding_update.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/ascending.hpp"

namespace crossgrain {
namespace {

/// Vertices of quads, ascending, with their faces; ascending.
using QuadFaces = std::vector<std::pair<std::array<std::uint32_t, 4>, std::uint32_t>>;

std::uint32_t face_at(const QuadFaces& faces, const std::array<std::uint32_t, 4>& vertices) {
  const auto key = ascending<4>(vertices);
  const auto entry = std::ranges::lower_bound(faces, key, {}, [](const auto& pair) { return pair.first; });
  return entry == faces.end() || entry->first != key ? Embedding::kNone : entry->second;
}

/// Of the quads that the sheet has not made or moved, and of these.
QuadFaces faces_after(const QuadComplex& before, const InsertedSheet& sheet, const Embedding& embedding) {
  QuadFaces faces, made;
  for (std::size_t q = 0; q < before.quads().size(); ++q)
    faces.emplace_back(ascending<4>(before.quads()[q].vertices), embedding.face_of_quad[q]);
  std::ranges::sort(faces);
  for (const InsertedSheet::Quad& quad : sheet.quads)
    made.emplace_back(ascending<4>(quad.vertices), face_at(faces, quad.before));
  faces.insert(faces.end(), made.begin(), made.end());
  std::ranges::sort(faces);
  return faces;
}

/// The twins of each vertex, ascending by vertex.
std::vector<std::array<std::uint32_t, 2>> twins_of(const InsertedSheet& sheet) {
  std::vector<std::array<std::uint32_t, 2>> twins;
  for (std::size_t k = 0; k < sheet.original.size(); ++k)
    twins.push_back({sheet.original[k], static_cast<std::uint32_t>(sheet.first_vertex + k)});
  std::ranges::sort(twins);
  return twins;
}

/// A vertex, then each of its twins.
std::vector<std::uint32_t> with_twins(std::span<const std::array<std::uint32_t, 2>> twins,
                                      std::uint32_t vertex) {
  std::vector<std::uint32_t> all{vertex};
  const auto [first, last] =
      std::ranges::equal_range(twins, vertex, {}, [](const auto& pair) { return pair[0]; });
  for (auto twin = first; twin != last; ++twin) all.push_back((*twin)[1]);
  return all;
}

/// Appends the way from a vertex to the next: straight on, or over a twin of one or both. Returns whether
/// there is one.
bool append_way(const QuadComplex& surface, std::span<const std::array<std::uint32_t, 2>> twins,
                std::uint32_t next, std::vector<std::uint32_t>& path) {
  const std::uint32_t from = path.back();
  const auto has_edge = [&](std::uint32_t a, std::uint32_t b) {
    return a == b || surface.edge_between(a, b) != QuadComplex::kNone;
  };
  if (has_edge(from, next)) {
    path.push_back(next);
    return true;
  }
  for (const std::uint32_t a : with_twins(twins, from)) {
    for (const std::uint32_t b : with_twins(twins, next)) {
      if (!has_edge(from, a) || !has_edge(a, b) || !has_edge(b, next)) continue;
      if (a != from) path.push_back(a);
      if (b != next) path.push_back(b);
      path.push_back(next);
      return true;
    }
  }
  return false;
}

/// Returns a path along edges of the surface; empty if there is none.
std::vector<std::uint32_t> path_after(const QuadComplex& surface,
                                      std::span<const std::array<std::uint32_t, 2>> twins,
                                      const std::vector<std::uint32_t>& path) {
  if (path.empty()) return {};
  std::vector<std::uint32_t> longer{path.front()};
  for (std::size_t k = 1; k < path.size(); ++k)
    if (!append_way(surface, twins, path[k], longer)) return {};
  return longer;
}

}  // namespace

void update_embedding(const QuadComplex& before, const QuadComplex& after, const InsertedSheet& sheet,
                      Embedding& embedding) {
  const QuadFaces faces = faces_after(before, sheet, embedding);
  embedding.face_of_quad.clear();
  for (const QuadComplex::Quad& quad : after.quads())
    embedding.face_of_quad.push_back(face_at(faces, quad.vertices));
  const auto twins = twins_of(sheet);
  for (std::vector<std::uint32_t>& path : embedding.path_of_curve) path = path_after(after, twins, path);
}

}  // namespace crossgrain
