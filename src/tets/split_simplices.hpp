// SPDX-License-Identifier: Apache-2.0
// Tets, faces or edges that are split around new vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace crossgrain {

/// Simplices of one kind, listed at each of their vertices: a split takes time in proportion to the shortest
/// of the lists of its vertices.
template <std::size_t kCorners>
class SplitSimplices {
 public:
  using Simplex = std::array<std::uint32_t, kCorners>;

  explicit SplitSimplices(std::vector<Simplex> given)
      : simplices_(std::move(given)), parents_(simplices_.size()) {
    std::iota(parents_.begin(), parents_.end(), 0U);
    for (std::uint32_t s = 0; s < simplices_.size(); ++s)
      for (const std::uint32_t v : simplices_[s]) list_at(v).push_back(s);
  }

  const std::vector<Simplex>& simplices() const { return simplices_; }

  /// For each simplex the given one of which it is a part.
  const std::vector<std::uint32_t>& parents() const { return parents_; }

  /// Indices of the simplices at a vertex, in no particular order.
  std::span<const std::uint32_t> at(std::uint32_t vertex) const {
    return vertex < at_.size() ? std::span<const std::uint32_t>(at_[vertex])
                               : std::span<const std::uint32_t>();
  }

  /// Indices of the simplices that have all these vertices, ascending.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t s : at(least_used(vertices)))
      if (has_all(s, vertices)) found.push_back(s);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Replaces each simplex of `found`, which is `around(vertices)`, by one for each of these vertices, with
  /// the new vertex `centre` in its place. One of them keeps the index, the others are added at the end.
  void split(std::span<const std::uint32_t> vertices, std::span<const std::uint32_t> found,
             std::uint32_t centre) {
    if (found.empty()) return;
    const std::uint32_t left = least_used(vertices);
    std::erase_if(at_[left], [&](std::uint32_t s) { return has_all(s, vertices); });
    for (const std::uint32_t s : found) {
      for (const std::uint32_t v : vertices) {
        if (v == left) continue;
        parents_.push_back(parents_[s]);
        simplices_.push_back(with_centre(simplices_[s], v, centre));
        list(static_cast<std::uint32_t>(simplices_.size() - 1));
      }
      simplices_[s] = with_centre(simplices_[s], left, centre);
      list_at(centre).push_back(s);
    }
  }

  /// The simplex with `centre` in the place of a vertex: of the same orientation if `centre` is inside the
  /// simplex, or inside a face or edge of it that has the vertex.
  static Simplex with_centre(Simplex simplex, std::uint32_t vertex, std::uint32_t centre) {
    std::replace(simplex.begin(), simplex.end(), vertex, centre);
    return simplex;
  }

 private:
  std::vector<std::uint32_t>& list_at(std::uint32_t vertex) {
    if (at_.size() <= vertex) at_.resize(vertex + std::size_t{1});
    return at_[vertex];
  }

  void list(std::uint32_t simplex) {
    for (const std::uint32_t v : simplices_[simplex]) list_at(v).push_back(simplex);
  }

  bool has_all(std::uint32_t simplex, std::span<const std::uint32_t> vertices) const {
    const Simplex& corners = simplices_[simplex];
    return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    });
  }

  /// The one of the vertices with the fewest simplices.
  std::uint32_t least_used(std::span<const std::uint32_t> vertices) const {
    return *std::min_element(vertices.begin(), vertices.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return at(a).size() < at(b).size(); });
  }

  std::vector<Simplex> simplices_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::vector<std::uint32_t>> at_;  ///< for each vertex the simplices that have it
};

}  // namespace crossgrain
