// SPDX-License-Identifier: Apache-2.0
#include "fit/shape_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "base/elementary.hpp"
#include "base/instruction_set.hpp"
#include "base/lane_functions.hpp"
#include "base/lanes.hpp"
#include "base/parallel.hpp"
#include "map/foldover.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_lanes.hpp"

namespace crossgrain {
namespace {

std::array<Vector3, 3> scaled_edges(const std::array<Vector3, 8>& corners, std::size_t k, double scale) {
  const auto& [a, b, c] = kHexNeighbours[k];
  return {scale * (corners[a] - corners[k]), scale * (corners[b] - corners[k]),
          scale * (corners[c] - corners[k])};
}

/// f and its derivatives by F and D, where chi = D > 0.
struct PlainEnergy {
  double value, by_f, by_d, by_fd, by_dd;

  PlainEnergy(double f, double d, double volume_weight) {
    const double root = cube_root(d * d), inverse = 1 / d;
    by_f = 1 / root;
    value = f * by_f + volume_weight * (inverse + d);
    by_d = -2.0 / 3 * f * by_f * inverse + volume_weight * (1 - inverse * inverse);
    by_fd = -2.0 / 3 * by_f * inverse;
    by_dd = 10.0 / 9 * f * by_f * inverse * inverse + 2 * volume_weight * inverse * inverse * inverse;
  }
};

/// Adds factor * (u v^T + v u^T) / 2.
void add_product(SymmetricMatrix3& sum, double factor, const Vector3& u, const Vector3& v) {
  const double half = 0.5 * factor;
  std::size_t entry = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) sum[entry++] += half * (u[i] * v[j] + u[j] * v[i]);
}

/// Of the vertex in a corner's determinant and squares: the first derivatives, and the second one of F, a
/// multiple of the identity.
struct VertexPart {
  Vector3 of_f, of_d;
  double twice_f;
};

/// The corners that a vertex is part of: its own, then those where it ends an edge.
struct CornerUse {
  std::size_t corner, edge;  ///< 3 for the vertex at the corner
};
std::array<CornerUse, 4> uses_of_corner(std::size_t corner) {
  std::array<CornerUse, 4> uses{{{corner, 3}, {}, {}, {}}};
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t other = kHexNeighbours[corner][n];
    const auto& around = kHexNeighbours[other];
    const auto* const at = std::find(around.begin(), around.end(), static_cast<std::uint8_t>(corner));
    uses[n + 1] = {other, static_cast<std::size_t>(at - around.begin())};
  }
  return uses;
}

const std::array<std::array<CornerUse, 4>, 8>& all_corner_uses() {
  static const std::array<std::array<CornerUse, 4>, 8> uses = [] {
    std::array<std::array<CornerUse, 4>, 8> result;
    for (std::size_t k = 0; k < 8; ++k) result[k] = uses_of_corner(k);
    return result;
  }();
  return uses;
}

/// D and F of a corner that a vertex is part of, and their derivatives by it.
struct CornerPart {
  double determinant, squares;
  VertexPart of_vertex;

  CornerPart(const std::array<Vector3, 8>& corners, const CornerUse& use, double scale) {
    const std::array<Vector3, 3> edges = scaled_edges(corners, use.corner, scale);
    const auto& [a, b, c] = edges;
    const std::array<Vector3, 3> cofactors{cross(b, c), cross(c, a), cross(a, b)};
    determinant = dot(cofactors[2], c);
    squares = dot(a, a) + dot(b, b) + dot(c, c);
    const double square = scale * scale;
    of_vertex = use.edge == 3
                    ? VertexPart{(-2 * scale) * (a + b + c),
                                 -scale * (cofactors[0] + cofactors[1] + cofactors[2]), 6 * square}
                    : VertexPart{(2 * scale) * edges[use.edge], scale * cofactors[use.edge], 2 * square};
  }
};

void add_second_order(const PlainEnergy& energy, const VertexPart& part, double cube, int power,
                      SecondOrder& sum) {
  const double share = energy.value / cube;
  const double outer = power * raised(share, power - 1);
  const double bend = power > 1 ? power * (power - 1) * raised(share, power - 2) / cube : 0;
  const Vector3 gradient = energy.by_f * part.of_f + energy.by_d * part.of_d;
  sum.value += cube * raised(share, power);
  sum.gradient += outer * gradient;
  add_product(sum.hessian, 2 * outer * energy.by_fd, part.of_f, part.of_d);
  add_product(sum.hessian, outer * energy.by_dd, part.of_d, part.of_d);
  if (bend > 0) add_product(sum.hessian, bend, gradient, gradient);
  for (const std::size_t diagonal : {0, 3, 5}) sum.hessian[diagonal] += outer * energy.by_f * part.twice_f;
}

/// `regularised` of lanes: D itself where epsilon is 0 and D > 0.
template <int W>
struct RegularisedLanes {
  Lanes<W> chi, slope;

  RegularisedLanes(const Lanes<W>& determinant, const Lanes<W>& epsilon) {
    constexpr double kLeast = 1e-100;
    const Lanes<W> root = sqrt(determinant * determinant + epsilon * epsilon);
    const Lanes<W> positive = 0.5 * (determinant + root),
                   other = 0.5 * epsilon * epsilon / (root - determinant);
    chi = select(determinant > 0.0, positive, other);
    chi = select(chi > kLeast, chi, Lanes<W>(kLeast));
    slope = chi / root;
  }
};

/// Returns the energy of a corner, and adds its gradient to that of all corners, which are in sizes.
template <int W>
Lanes<W> add_corner_energy(const CornerLanes<W>& corners, std::size_t corner, const Lanes<W>& epsilon,
                           const CornerEnergyOptions& options, CornerLanes<W>& gradient) {
  using Real = Lanes<W>;
  std::array<BasicVector3<Real>, 3> edges;
  for (std::size_t n = 0; n < 3; ++n) edges[n] = corners[kHexNeighbours[corner][n]] - corners[corner];
  const auto& [a, b, c] = edges;
  const std::array<BasicVector3<Real>, 3> cofactors{cross(b, c), cross(c, a), cross(a, b)};
  const Real determinant = dot(cofactors[2], c);
  const RegularisedLanes<W> regularised(determinant, epsilon);
  const Real inverse = 1.0 / regularised.chi, inverse_root = inverse_cube_root(regularised.chi);
  const Real by_squares = inverse_root * inverse_root;
  const Real squares = dot(a, a) + dot(b, b) + dot(c, c);
  const Real volumes = options.volume_weight * (1.0 + determinant * determinant) * inverse;
  // Relative to a cube of the size, so that no power is out of range for it.
  const double cube = 3 + 2 * options.volume_weight;
  const Real share = (squares * by_squares + volumes) * (1 / cube);
  Real below = 1.0;
  for (int k = 1; k < options.power; ++k) below *= share;
  const Real by_determinant = (2 * options.volume_weight) * determinant * inverse -
                              (2.0 / 3 * squares * by_squares + volumes) * inverse * regularised.slope;
  const Real of_edges = 2 * options.power * below * by_squares;
  const Real of_cofactors = options.power * below * by_determinant;
  for (std::size_t n = 0; n < 3; ++n) {
    const BasicVector3<Real> by_edge = of_edges * edges[n] + of_cofactors * cofactors[n];
    gradient[kHexNeighbours[corner][n]] += by_edge;
    gradient[corner] += -by_edge;
  }
  const auto is_finite = (epsilon > 0.0) | (determinant > 0.0);
  return select(is_finite, cube * share * below, Real(INFINITY));
}

}  // namespace

Lists<std::uint32_t> corner_uses(std::size_t vertices,
                                 std::span<const std::array<std::uint32_t, 8>> hexahedra) {
  return Lists<std::uint32_t>(vertices, [&](const auto& add) {
    for (std::uint32_t h = 0; h < hexahedra.size(); ++h)
      for (std::uint32_t k = 0; k < 8; ++k) add(hexahedra[h][k], 8 * h + k);
  });
}

ShapeEnergy::ShapeEnergy(std::size_t vertices, std::span<const std::array<std::uint32_t, 8>> hexahedra,
                         std::vector<double> sizes)
    : hexahedra_(hexahedra),
      scales_(std::move(sizes)),
      uses_(corner_uses(vertices, hexahedra)),
      values_(hexahedra.size()),
      by_corner_(8 * hexahedra.size()) {
  for (double& scale : scales_) scale = 1 / scale;
}

/// Of `count` hexahedra from `first` on, each in a lane; lanes beyond hold the last one too.
template <int W>
void ShapeEnergy::find_terms(const std::vector<Vector3>& places, const CornerEnergyOptions& options,
                             std::span<const std::uint8_t> kept, std::size_t first, int count) {
  std::array<double, W> scales, epsilons;
  for (int lane = 0; lane < W; ++lane) {
    const std::size_t h = first + static_cast<std::size_t>(std::min(lane, count - 1));
    scales[static_cast<std::size_t>(lane)] = scales_[h];
    epsilons[static_cast<std::size_t>(lane)] = !kept.empty() && kept[h] ? 0 : options.epsilon;
  }
  const auto scale = lanes_at<Lanes<W>>(scales.data()), epsilon = lanes_at<Lanes<W>>(epsilons.data());
  CornerLanes<W> corners = corner_lanes<W>(places, hexahedra_, first, count), gradient;
  for (BasicVector3<Lanes<W>>& corner : corners) corner = scale * corner;
  gradient.fill({0.0, 0.0, 0.0});
  Lanes<W> value = 0.0;
  for (std::size_t k = 0; k < 8; ++k) value += add_corner_energy(corners, k, epsilon, options, gradient);
  std::array<double, W> values;
  std::memcpy(values.data(), &value.native, sizeof values);
  std::array<std::array<double, W>, 24> coordinates;
  for (std::size_t i = 0; i < 24; ++i) {
    const Lanes<W> of_place = scale * gradient[i / 3][i % 3];
    std::memcpy(coordinates[i].data(), &of_place.native, sizeof values);
  }
  for (std::size_t l = 0; l < static_cast<std::size_t>(count); ++l) {
    values_[first + l] = values[l];
    for (std::size_t i = 0; i < 24; ++i) by_corner_[8 * (first + l) + i / 3][i % 3] = coordinates[i][l];
  }
}

double ShapeEnergy::operator()(const std::vector<Vector3>& places, const CornerEnergyOptions& options,
                               std::vector<Vector3>& gradient, std::span<const std::uint8_t> kept) {
  parallel_for_lanes(values_.size(), [&]<int W>(std::size_t first, int count) {
    find_terms<W>(places, options, kept, first, count);
  });
  gradient.resize(places.size());
  parallel_for(places.size(), [&](std::size_t v) {
    Vector3 of_vertex{0, 0, 0};
    for (const std::uint32_t use : uses_[v]) of_vertex += by_corner_[use];
    gradient[v] = of_vertex;
  });
  return std::accumulate(values_.begin(), values_.end(), 0.0);
}

double ShapeEnergy::least_determinant(const std::vector<Vector3>& places) const {
  double least = INFINITY;
  for (std::size_t h = 0; h < hexahedra_.size(); ++h) {
    std::array<Vector3, 8> corners;
    for (std::size_t k = 0; k < 8; ++k) corners[k] = places[hexahedra_[h][k]];
    for (std::size_t k = 0; k < 8; ++k) {
      const auto [a, b, c] = scaled_edges(corners, k, scales_[h]);
      least = std::min(least, dot(cross(a, b), c));
    }
  }
  return least;
}

bool add_energy_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                   const CornerEnergyOptions& options, SecondOrder& sum) {
  const double cube = 3 + 2 * options.volume_weight;
  for (const CornerUse& use : all_corner_uses()[corner]) {
    const CornerPart part(corners, use, scale);
    if (!(part.determinant > 0)) return false;
    const PlainEnergy energy(part.squares, part.determinant, options.volume_weight);
    add_second_order(energy, part.of_vertex, cube, options.power, sum);
  }
  return true;
}

void add_stiffness_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                      const CornerEnergyOptions& options, SymmetricMatrix3& sum) {
  const double cube = 3 + 2 * options.volume_weight;
  SecondOrder all;
  for (const CornerUse& use : all_corner_uses()[corner]) {
    CornerPart part(corners, use, scale);
    const auto [chi, slope] = regularised(part.determinant, options.epsilon);
    part.of_vertex.of_d = slope * part.of_vertex.of_d;
    add_second_order(PlainEnergy(part.squares, chi, options.volume_weight), part.of_vertex, cube,
                     options.power, all);
  }
  for (std::size_t k = 0; k < 6; ++k) sum[k] += all.hessian[k];
}

double energy_at(const std::array<Vector3, 8>& corners, std::size_t corner, double scale,
                 const CornerEnergyOptions& options) {
  const double cube = 3 + 2 * options.volume_weight;
  double sum = 0;
  for (const CornerUse& use : all_corner_uses()[corner]) {
    const auto [a, b, c] = scaled_edges(corners, use.corner, scale);
    const double determinant = dot(cross(a, b), c);
    if (!(determinant > 0)) return INFINITY;
    const double f = dot(a, a) + dot(b, b) + dot(c, c);
    const double share =
        (f / cube_root(determinant * determinant) + options.volume_weight * (1 / determinant + determinant)) /
        cube;
    sum += cube * raised(share, options.power);
  }
  return sum;
}

}  // namespace crossgrain
