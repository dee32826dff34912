// SPDX-License-Identifier: Apache-2.0
#include "lattice/volume_shares.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// A place in the plane that rays along x are seen in.
struct Seen {
  double y, z;
};

Seen seen(const Vector3& p) {
  return {p[1], p[2]};
}

/// Twice the signed area of a, b and p, of the opposite sign, to the bit, with a and b exchanged.
double turn(const Seen& a, const Seen& b, const Seen& p) {
  const bool is_ordered = std::pair(a.z, a.y) < std::pair(b.z, b.y);
  const Seen& from = is_ordered ? a : b;
  const Seen& to = is_ordered ? b : a;
  const double area = (to.y - from.y) * (p.z - from.z) - (to.z - from.z) * (p.y - from.y);
  return is_ordered ? area : -area;
}

/// Whether p is left of the line from a to b; a p on it is taken to be moved a little, always the same way,
/// so that a ray through an edge or a vertex hits one triangle of those around it.
bool is_left(const Seen& a, const Seen& b, const Seen& p) {
  const double area = turn(a, b, p);
  return area != 0 ? area > 0 : std::pair(a.z, a.y) < std::pair(b.z, b.y);
}

struct Hit {
  double x;
  int sign;  ///< +1 where the ray enters the solid, -1 where it leaves it
};

/// Where the ray through p along x meets a triangle; seen along x, a triangle that looks back is clockwise.
std::optional<Hit> hit(const std::array<Vector3, 3>& corners, const Seen& p) {
  const Seen a = seen(corners[0]), b = seen(corners[1]), c = seen(corners[2]);
  const bool of_a = is_left(b, c, p), of_b = is_left(c, a, p), of_c = is_left(a, b, p);
  if (of_a != of_b || of_b != of_c) return std::nullopt;
  const double weight_a = turn(b, c, p), weight_b = turn(c, a, p), weight_c = turn(a, b, p);
  const double sum = weight_a + weight_b + weight_c;
  if (sum == 0) return std::nullopt;
  const double x = (weight_a * corners[0][0] + weight_b * corners[1][0] + weight_c * corners[2][0]) / sum;
  return Hit{x, of_a ? -1 : 1};
}

/// The rays of an axis: kRaysAcross within each cell, ascending.
std::vector<double> ray_coordinates(const std::vector<double>& planes) {
  std::vector<double> coordinates;
  for (std::size_t cell = 0; cell + 1 < planes.size(); ++cell)
    for (std::size_t k = 0; k < kRaysAcross; ++k)
      coordinates.push_back(planes[cell] + (planes[cell + 1] - planes[cell]) *
                                               (static_cast<double>(k) + 0.5) / double{kRaysAcross});
  return coordinates;
}

/// The hits of a column of cells, by ray.
using ColumnHits = std::array<std::vector<Hit>, kRaysAcross * kRaysAcross>;

/// Adds to the shares of the cells of a column how much of a ray is inside.
void add_inside(std::vector<Hit>& hits, const std::vector<double>& planes, std::vector<double>& lengths) {
  std::ranges::sort(
      hits, [](const Hit& a, const Hit& b) { return std::pair(a.x, -a.sign) < std::pair(b.x, -b.sign); });
  int depth = 0;
  double entered = 0;
  for (const Hit& hit : hits) {
    const int before = depth;
    depth += hit.sign;
    if (before <= 0 && depth > 0) entered = hit.x;
    if (before <= 0 || depth > 0) continue;
    auto cell = static_cast<std::size_t>(std::ranges::upper_bound(planes, entered) - planes.begin());
    for (cell = cell > 0 ? cell - 1 : 0; cell + 1 < planes.size() && planes[cell] < hit.x; ++cell)
      lengths[cell] += std::max(0.0, std::min(hit.x, planes[cell + 1]) - std::max(entered, planes[cell]));
  }
}

/// Triangles by the columns of cells that their box, seen along x, meets.
class Columns {
 public:
  Columns(const Surface& surface, const LatticePlanes& planes) : planes_(planes) {
    first_.assign(planes.cells(1) * planes.cells(2) + 1, 0);
    for (std::size_t t = 0; t < surface.size(); ++t)
      for_each(surface, t, [&](std::size_t column) { ++first_[column + 1]; });
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    triangles_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < surface.size(); ++t)
      for_each(surface, t,
               [&](std::size_t column) { triangles_[next[column]++] = static_cast<std::uint32_t>(t); });
  }

  template <class Visit>
  void for_each_of(std::size_t column, const Visit& visit) const {
    for (std::size_t k = first_[column]; k < first_[column + 1]; ++k) visit(triangles_[k]);
  }

 private:
  template <class Visit>
  void for_each(const Surface& surface, std::size_t triangle, const Visit& visit) const {
    const auto corners = surface.corners(triangle);
    std::array<std::pair<std::size_t, std::size_t>, 2> cells;
    for (std::size_t axis : {1, 2}) {
      const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      const std::vector<double>& at = planes_.at[axis];
      const auto after = [&](double x) {
        return static_cast<std::size_t>(std::ranges::upper_bound(at, x) - at.begin());
      };
      cells[axis - 1] = {std::max<std::size_t>(after(low), 1) - 1, std::min(after(high), at.size() - 1)};
    }
    for (std::size_t j = cells[0].first; j < cells[0].second; ++j)
      for (std::size_t k = cells[1].first; k < cells[1].second; ++k) visit(j * planes_.cells(2) + k);
  }

  const LatticePlanes& planes_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> triangles_;
};

}  // namespace

std::vector<float> volume_shares(const Surface& surface, const LatticePlanes& planes) {
  const Columns columns(surface, planes);
  const std::vector<double> ys = ray_coordinates(planes.at[1]), zs = ray_coordinates(planes.at[2]);
  const std::size_t across = planes.cells(1) * planes.cells(2);
  std::vector<float> shares(planes.cells(), 0);
  parallel_for(across, [&](std::size_t column) {
    const std::size_t j = column / planes.cells(2), k = column % planes.cells(2);
    ColumnHits hits;
    columns.for_each_of(column, [&](std::uint32_t triangle) {
      const auto corners = surface.corners(triangle);
      for (std::size_t ray = 0; ray < hits.size(); ++ray) {
        const Seen p{ys[j * kRaysAcross + ray / kRaysAcross], zs[k * kRaysAcross + ray % kRaysAcross]};
        if (const auto found = hit(corners, p)) hits[ray].push_back(*found);
      }
    });
    std::vector<double> lengths(planes.cells(0), 0);
    for (std::vector<Hit>& of_ray : hits) add_inside(of_ray, planes.at[0], lengths);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const double whole = (planes.at[0][i + 1] - planes.at[0][i]) * double{kRaysAcross * kRaysAcross};
      shares[i * across + column] = static_cast<float>(lengths[i] / whole);
    }
  });
  return shares;
}

}  // namespace crossgrain
