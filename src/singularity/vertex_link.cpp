// SPDX-License-Identifier: Apache-2.0
#include "singularity/vertex_link.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace crossgrain {
namespace {

constexpr int kRegularValence = 4, kRegularCrease = 2;

/// Fills polygons with triangles, one after the other, until each vertex has as many as it needs.
class LinkSearch {
 public:
  /// `border`: triangles at each vertex of a polygon, in cyclic order; `inner`: valences of the vertices
  /// inside it.
  LinkSearch(std::span<const int> border, std::span<const int> inner)
      : left_(border.begin(), border.end()), is_joined_(border.size() + inner.size()) {
    for (const int valence : inner) {
      const auto place = static_cast<std::size_t>(valence);
      if (unused_.size() <= place) unused_.resize(place + 1, 0);
      ++unused_[place];
    }
    Polygon polygon(border.size());
    std::iota(polygon.begin(), polygon.end(), 0u);
    for (std::size_t k = 0; k < polygon.size(); ++k)
      join(polygon[k], polygon[(k + 1) % polygon.size()], true);
    open_.push_back(std::move(polygon));
  }

  bool succeeds() {
    if (open_.empty()) return is_complete();
    Polygon polygon = std::move(open_.back());
    open_.pop_back();
    const auto needs_fewer = [&](std::uint32_t a, std::uint32_t b) { return left_[a] < left_[b]; };
    std::rotate(polygon.begin(), std::ranges::min_element(polygon, needs_fewer), polygon.end());
    const bool found = left_[polygon[0]] > 0 && (closes_on_border(polygon) || closes_on_new_vertex(polygon));
    open_.push_back(std::move(polygon));
    return found;
  }

 private:
  using Polygon = std::vector<std::uint32_t>;

  bool is_complete() const {
    return std::ranges::all_of(left_, [](int left) { return left == 0; }) &&
           std::ranges::all_of(unused_, [](int count) { return count == 0; });
  }

  /// Tries the triangles of the polygon's first edge and another of its vertices.
  bool closes_on_border(const Polygon& polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t k = 2; k < count; ++k) {
      // A vertex that needs one triangle has its two edges of the polygon in it.
      if ((left_[polygon[0]] == 1 && k + 1 < count) || (left_[polygon[1]] == 1 && k > 2)) continue;
      if (succeeds_with(polygon, k)) return true;
    }
    return false;
  }

  bool succeeds_with(const Polygon& polygon, std::size_t third) {
    const std::uint32_t a = polygon[0], b = polygon[1], c = polygon[third];
    const bool is_last_beside_b = third == 2, is_last_beside_a = third + 1 == polygon.size();
    if ((!is_last_beside_b && joined(b, c)) || (!is_last_beside_a && joined(a, c))) return false;
    const std::size_t open = open_.size();
    take({a, b, c}, 1);
    if (!is_last_beside_b) {
      join(b, c, true);
      open_.emplace_back(polygon.begin() + 1, polygon.begin() + static_cast<std::ptrdiff_t>(third) + 1);
    }
    if (!is_last_beside_a) {
      join(a, c, true);
      open_.emplace_back(polygon.begin() + static_cast<std::ptrdiff_t>(third), polygon.end());
      open_.back().push_back(a);
    }
    const bool found = succeeds();
    open_.resize(open);
    if (!is_last_beside_b) join(b, c, false);
    if (!is_last_beside_a) join(a, c, false);
    take({a, b, c}, -1);
    return found;
  }

  /// Tries the triangles of the polygon's first edge and a vertex inside.
  bool closes_on_new_vertex(const Polygon& polygon) {
    const std::uint32_t a = polygon[0], b = polygon[1];
    if (left_[a] == 1 || left_[b] == 1) return false;
    for (std::size_t valence = 0; valence < unused_.size(); ++valence) {
      if (unused_[valence] == 0) continue;
      const auto c = static_cast<std::uint32_t>(left_.size());
      --unused_[valence];
      left_.push_back(static_cast<int>(valence));
      take({a, b, c}, 1);
      join(a, c, true);
      join(b, c, true);
      Polygon rest = polygon;
      rest.insert(rest.begin() + 1, c);
      open_.push_back(std::move(rest));
      const bool found = succeeds();
      open_.pop_back();
      join(a, c, false);
      join(b, c, false);
      take({a, b, c}, -1);
      left_.pop_back();
      ++unused_[valence];
      if (found) return true;
    }
    return false;
  }

  void take(const std::array<std::uint32_t, 3>& corners, int count) {
    for (const std::uint32_t corner : corners) left_[corner] -= count;
  }

  bool joined(std::uint32_t a, std::uint32_t b) const { return is_joined_[a] >> b & 1; }
  void join(std::uint32_t a, std::uint32_t b, bool on) {
    const auto set = [&](std::uint32_t from, std::uint32_t to) {
      const std::uint64_t bit = std::uint64_t{1} << to;
      is_joined_[from] = on ? is_joined_[from] | bit : is_joined_[from] & ~bit;
    };
    set(a, b);
    set(b, a);
  }

  std::vector<int> left_;                 ///< triangles that each vertex still needs
  std::vector<int> unused_;               ///< number of vertices that are not placed yet, by valence
  std::vector<std::uint64_t> is_joined_;  ///< bit b of entry a: there is an edge between a and b
  std::vector<Polygon> open_;             ///< regions without triangles yet
};

int sum_of(std::span<const int> numbers, int regular) {
  int sum = 0;
  for (const int number : numbers) sum += regular - number;
  return sum;
}

/// Whether a disc has a triangulation with `more` vertices of two triangles distributed among the creases.
bool has_disc(std::span<const int> inner, std::span<const int> creases, int more) {
  // How many of them follow each crease; at least one crease, or all are alike.
  std::vector<int> after(std::max<std::size_t>(1, creases.size()), 0);
  after[0] = more;
  while (true) {
    std::vector<int> border;
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (k < creases.size()) border.push_back(creases[k]);
      border.insert(border.end(), static_cast<std::size_t>(after[k]), kRegularCrease);
    }
    if (LinkSearch(border, inner).succeeds()) return true;
    // The next composition of `more`.
    std::size_t first = 0;
    while (first < after.size() && after[first] == 0) ++first;
    if (first + 1 >= after.size()) return false;
    const int rest = after[first] - 1;
    after[first] = 0;
    ++after[first + 1];
    after[0] = rest;
  }
}

}  // namespace

std::optional<bool> has_inner_link(std::span<const int> valences) {
  const int twice_regular = 12 - sum_of(valences, 6);
  if (twice_regular < 0 || twice_regular % 2 != 0) return false;
  std::vector<int> all(valences.begin(), valences.end());
  all.resize(valences.size() + static_cast<std::size_t>(twice_regular / 2), kRegularValence);
  if (2 * static_cast<int>(all.size()) - 4 > kMostLinkTriangles) return std::nullopt;
  std::ranges::sort(all);
  // The outermost triangle has a vertex of the least valence; one at it is taken out of the sphere.
  for (std::size_t b = 1; b < all.size(); ++b) {
    for (std::size_t c = b + 1; c < all.size(); ++c) {
      std::vector<int> inner;
      for (std::size_t k = 1; k < all.size(); ++k)
        if (k != b && k != c) inner.push_back(all[k]);
      if (LinkSearch(std::array{all[0] - 1, all[b] - 1, all[c] - 1}, inner).succeeds()) return true;
      while (c + 1 < all.size() && all[c + 1] == all[c]) ++c;
    }
    while (b + 1 < all.size() && all[b + 1] == all[b]) ++b;
  }
  return false;
}

int hexahedra_at_surface_vertex(std::span<const int> valences, std::span<const int> creases) {
  return 4 - sum_of(valences, kRegularValence) - sum_of(creases, kRegularCrease);
}

std::optional<bool> has_surface_link(std::span<const int> valences, std::span<const int> creases) {
  const int triangles = hexahedra_at_surface_vertex(valences, creases);
  if (triangles < 1 || std::ranges::any_of(creases, [](int k) { return k < 1; })) return false;
  if (triangles > kMostLinkTriangles) return std::nullopt;
  std::vector<int> inner(valences.begin(), valences.end());
  while (true) {
    const int border = triangles + 2 - 2 * static_cast<int>(inner.size());
    const int more = border - static_cast<int>(creases.size());
    if (border < 3 || more < 0) return false;
    if (has_disc(inner, creases, more)) return true;
    inner.push_back(kRegularValence);
  }
}

std::optional<bool> has_link_within(std::span<const int> border, std::span<const int> valences) {
  const int triangles = hexahedra_at_surface_vertex(valences, border);
  const int inside = triangles + 2 - static_cast<int>(border.size());
  const int regular = inside / 2 - static_cast<int>(valences.size());
  if (triangles < 1 || border.size() < 3 || inside % 2 != 0 || regular < 0) return false;
  if (std::ranges::any_of(border, [](int k) { return k < 1; })) return false;
  if (triangles > kMostLinkTriangles) return std::nullopt;
  std::vector<int> inner(valences.begin(), valences.end());
  inner.resize(valences.size() + static_cast<std::size_t>(regular), kRegularValence);
  return LinkSearch(border, inner).succeeds();
}

}  // namespace crossgrain
