// SPDX-License-Identifier: Apache-2.0
#include "fit/shape_energy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "map/foldover.hpp"
#include "measure/hex_faces.hpp"

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

}  // namespace

CornerEnergy corner_energy(const std::array<Vector3, 3>& edges, const CornerEnergyOptions& options) {
  const auto& [a, b, c] = edges;
  const std::array<Vector3, 3> cofactors{cross(b, c), cross(c, a), cross(a, b)};
  const double determinant = dot(cofactors[2], c);
  if (options.epsilon == 0 && !(determinant > 0)) return {INFINITY, {}};
  const auto [chi, slope] =
      options.epsilon == 0 ? Regularised{determinant, 1} : regularised(determinant, options.epsilon);
  const double squares = dot(a, a) + dot(b, b) + dot(c, c), root = cube_root(chi * chi);
  const double volumes = options.volume_weight * (1 + determinant * determinant) / chi;
  // Relative to a cube of the size, so that no power is out of range for it.
  const double cube = 3 + 2 * options.volume_weight, share = (squares / root + volumes) / cube;
  const double below = raised(share, options.power - 1), outer = options.power * below;
  const double by_determinant = -2.0 / 3 * squares / (root * chi) * slope +
                                2 * options.volume_weight * determinant / chi - volumes / chi * slope;
  CornerEnergy energy{cube * share * below, {}};
  for (std::size_t n = 0; n < 3; ++n)
    energy.by_edge[n] = outer * ((2 / root) * edges[n] + by_determinant * cofactors[n]);
  return energy;
}

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
      terms_(hexahedra.size()) {
  for (double& scale : scales_) scale = 1 / scale;
}

std::array<Vector3, 3> ShapeEnergy::edges(const std::vector<Vector3>& places, std::size_t hexahedron,
                                          std::size_t corner) const {
  const auto& corners = hexahedra_[hexahedron];
  const auto& [a, b, c] = kHexNeighbours[corner];
  const Vector3& at = places[corners[corner]];
  const double scale = scales_[hexahedron];
  return {scale * (places[corners[a]] - at), scale * (places[corners[b]] - at),
          scale * (places[corners[c]] - at)};
}

ShapeEnergy::Term ShapeEnergy::term(const std::vector<Vector3>& places, std::size_t hexahedron,
                                    const CornerEnergyOptions& options) const {
  Term term{0, {}};
  for (std::size_t k = 0; k < 8; ++k) {
    const CornerEnergy energy = corner_energy(edges(places, hexahedron, k), options);
    term.value += energy.value;
    for (std::size_t n = 0; n < 3; ++n) {
      term.gradient[kHexNeighbours[k][n]] += energy.by_edge[n];
      term.gradient[k] += -energy.by_edge[n];
    }
  }
  return term;
}

double ShapeEnergy::operator()(const std::vector<Vector3>& places, const CornerEnergyOptions& options,
                               std::vector<Vector3>& gradient, std::span<const std::uint8_t> kept) {
  CornerEnergyOptions barrier = options;
  barrier.epsilon = 0;
  parallel_for(terms_.size(), [&](std::size_t h) {
    terms_[h] = term(places, h, !kept.empty() && kept[h] ? barrier : options);
  });
  double sum = 0;
  for (const Term& term : terms_) sum += term.value;
  gradient.resize(places.size());
  parallel_for(places.size(), [&](std::size_t v) {
    Vector3 of_vertex{0, 0, 0};
    for (const std::uint32_t use : uses_[v])
      of_vertex += scales_[use / 8] * terms_[use / 8].gradient[use % 8];
    gradient[v] = of_vertex;
  });
  return sum;
}

double ShapeEnergy::least_determinant(const std::vector<Vector3>& places) const {
  double least = INFINITY;
  for (std::size_t h = 0; h < terms_.size(); ++h)
    for (std::size_t k = 0; k < 8; ++k) {
      const auto [a, b, c] = edges(places, h, k);
      least = std::min(least, dot(cross(a, b), c));
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
