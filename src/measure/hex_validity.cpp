// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_validity.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_lanes.hpp"

namespace crossgrain {
namespace {

/// A box whose determinant is everywhere near the limit is given up after a millisecond.
constexpr int kMostCuts = 512;

/// Edges along one axis, by the places of their ends along the other two. Real is double, or Lanes of several
/// hexahedra.
template <class Real>
using EdgesAlong = std::array<std::array<BasicVector3<Real>, 2>, 2>;

template <class Real>
struct ScaledEdges {
  EdgesAlong<Real> x, y, z;     ///< x by (y, z), y by (x, z), z by (x, y); of mean length 1 each
  std::array<Real, 3> lengths;  ///< the sums before
};

template <class Real>
Real scale_to_one(EdgesAlong<Real>& edges) {
  Real sum = 0.0;
  for (const auto& row : edges)
    for (const BasicVector3<Real>& edge : row) sum += norm(edge);
  for (auto& row : edges)
    for (BasicVector3<Real>& edge : row) edge = (4.0 / sum) * edge;
  return sum;
}

template <class Real>
ScaledEdges<Real> edges_of_box(const std::array<BasicVector3<Real>, 8>& p) {
  ScaledEdges<Real> edges{{{{p[1] - p[0], p[5] - p[4]}, {p[2] - p[3], p[6] - p[7]}}},
                          {{{p[3] - p[0], p[7] - p[4]}, {p[2] - p[1], p[6] - p[5]}}},
                          {{{p[4] - p[0], p[7] - p[3]}, {p[5] - p[1], p[6] - p[2]}}},
                          {}};
  edges.lengths = {scale_to_one(edges.x), scale_to_one(edges.y), scale_to_one(edges.z)};
  return edges;
}

/// Coefficients of a polynomial of degree two along each axis, at 9 i + 3 j + k.
template <class Real>
using BezierOf = std::array<Real, 27>;
using Bezier = BezierOf<double>;

/// A product of two Bernstein polynomials of degree one has half of the middle one of degree two where their
/// numbers differ, so that each coefficient is a mean over its sums.
template <class Real>
BezierOf<Real> determinant_of(const ScaledEdges<Real>& edges) {
  BezierOf<Real> sums;
  sums.fill(Real(0.0));
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t l = 0; l < 2; ++l)
        for (std::size_t m = 0; m < 2; ++m) {
          const BasicVector3<Real> normal = cross(edges.y[i][k], edges.z[l][m]);
          for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t n = 0; n < 2; ++n)
              sums[9 * (i + l) + 3 * (j + m) + k + n] += dot(edges.x[j][n], normal);
        }
  constexpr std::array<double, 3> kWeights{1, 0.5, 1};
  for (std::size_t c = 0; c < 27; ++c) sums[c] *= kWeights[c / 9] * kWeights[c / 3 % 3] * kWeights[c % 3];
  return sums;
}

/// Whether hexahedra are valid by their coefficients alone, as nearly all are.
template <int W>
LaneMask<double, W> are_surely_valid(const CornerLanes<W>& corners) {
  const ScaledEdges<Lanes<W>> edges = edges_of_box(corners);
  const BezierOf<Lanes<W>> coefficients = determinant_of(edges);
  auto result = coefficients[0] > kLeastJacobian;
  for (const Lanes<W>& coefficient : coefficients) result = result & (coefficient > kLeastJacobian);
  for (const Lanes<W>& length : edges.lengths)
    result = result & (length > 0.0) & (length < std::numeric_limits<double>::max());
  return result;
}

struct ParameterBox {
  Bezier coefficients;
  double lower;

  explicit ParameterBox(const Bezier& values)
      : coefficients(values), lower(*std::min_element(values.begin(), values.end())) {}

  /// The least at a corner, where coefficients are values.
  double upper() const {
    double least = coefficients[0];
    for (const std::size_t c : {2, 6, 8, 18, 20, 24, 26}) least = std::min(least, coefficients[c]);
    return least;
  }
};

/// Coefficients a, b, c on both halves: the middle ones are shared (de Casteljau).
std::array<double, 5> halved(double a, double b, double c) {
  const double ab = 0.5 * (a + b), bc = 0.5 * (b + c);
  return {a, ab, 0.5 * (ab + bc), bc, c};
}

/// The two halves along the axis whose coefficients are `step` apart.
std::array<Bezier, 2> halves_of(const Bezier& whole, std::size_t step) {
  std::array<Bezier, 2> halves;
  for (std::size_t c = 0; c < 27; ++c) {
    if (c / step % 3 != 0) continue;
    const std::array<double, 5> five = halved(whole[c], whole[c + step], whole[c + 2 * step]);
    for (std::size_t k = 0; k < 3; ++k) {
      halves[0][c + k * step] = five[k];
      halves[1][c + k * step] = five[k + 2];
    }
  }
  return halves;
}

/// Adds the eighths of a box.
void add_eighths(const Bezier& whole, std::vector<ParameterBox>& boxes) {
  for (const Bezier& half : halves_of(whole, 9))
    for (const Bezier& quarter : halves_of(half, 3))
      for (const Bezier& eighth : halves_of(quarter, 1)) boxes.emplace_back(eighth);
}

/// Cuts boxes until `is_enough(bounds)`.
template <class IsEnough>
JacobianBounds bounded(const HexCorners& corners, const IsEnough& is_enough) {
  const ScaledEdges<double> edges = edges_of_box(corners);
  for (const double length : edges.lengths)
    if (!(length > 0) || !std::isfinite(length)) return {0, 0};
  const ParameterBox whole(determinant_of(edges));
  JacobianBounds bounds{whole.lower, whole.upper()};
  if (is_enough(bounds)) return bounds;
  const auto is_higher = [](const ParameterBox& a, const ParameterBox& b) { return a.lower > b.lower; };
  std::vector<ParameterBox> heap{whole};
  for (int cut = 0; cut < kMostCuts && !is_enough(bounds); ++cut) {
    std::pop_heap(heap.begin(), heap.end(), is_higher);
    const Bezier lowest = heap.back().coefficients;
    heap.pop_back();
    const std::size_t first = heap.size();
    add_eighths(lowest, heap);
    for (std::size_t k = first; k < heap.size(); ++k) {
      bounds.upper = std::min(bounds.upper, heap[k].upper());
      std::push_heap(heap.begin(), heap.begin() + static_cast<std::ptrdiff_t>(k + 1), is_higher);
    }
    bounds.lower = heap.front().lower;
  }
  return bounds;
}

}  // namespace

JacobianBounds least_jacobian(const HexCorners& corners, double gap) {
  return bounded(corners,
                 [gap](const JacobianBounds& bounds) { return !(bounds.upper - bounds.lower > gap); });
}

bool is_valid(const HexCorners& corners) {
  return bounded(corners, [](const JacobianBounds& bounds) {
           return bounds.lower > kLeastJacobian || !(bounds.upper > kLeastJacobian);
         }).lower > kLeastJacobian;
}

HexCorners corners_of(const HexMesh& mesh, std::size_t hexahedron) {
  HexCorners corners;
  for (std::size_t k = 0; k < 8; ++k) corners[k] = mesh.vertices[mesh.hexahedra[hexahedron][k]];
  return corners;
}

bool are_valid(const std::vector<Vector3>& places, std::span<const std::array<std::uint32_t, 8>> hexahedra,
               std::span<const std::uint8_t> which) {
  std::atomic<bool> are_valid = true;
  parallel_for_lanes(hexahedra.size(), [&]<int W>(std::size_t first, int count) {
    if (!are_valid.load(std::memory_order_relaxed)) return;
    const CornerLanes<W> corners = corner_lanes<W>(places, hexahedra, first, count);
    const LaneMask<double, W> are_sure = are_surely_valid<W>(corners);
    for (int lane = 0; lane < count; ++lane)
      if (which[first + static_cast<std::size_t>(lane)] && !are_sure[lane] &&
          !is_valid(in_lane(corners, lane)))
        are_valid.store(false, std::memory_order_relaxed);
  });
  return are_valid;
}

std::vector<std::uint8_t> inverted_hexahedra(const HexMesh& mesh) {
  std::vector<std::uint8_t> result(mesh.hexahedra.size());
  parallel_for_lanes(result.size(), [&]<int W>(std::size_t first, int count) {
    const CornerLanes<W> corners = corner_lanes<W>(mesh.vertices, mesh.hexahedra, first, count);
    const LaneMask<double, W> are_sure = are_surely_valid<W>(corners);
    for (int lane = 0; lane < count; ++lane)
      result[first + static_cast<std::size_t>(lane)] = !are_sure[lane] && !is_valid(in_lane(corners, lane));
  });
  return result;
}

}  // namespace crossgrain
