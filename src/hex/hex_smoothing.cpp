// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "map/foldover.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

/// The directions in which each vertex may move.
class Freedom {
 public:
  Freedom(const HexMesh& mesh, const MapSurface& surface, const std::vector<Foot>& feet)
      : directions_(feet.size()), begins_(feet.size() + 1, 0) {
    parallel_for(feet.size(), [&](std::size_t v) {
      const Vector3 direction = surface.nearest(feet[v], mesh.vertices[v]).direction;
      switch (feet[v].kind) {
        case Foot::Kind::kInside:
          directions_[v] = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
          break;
        case Foot::Kind::kFace: {
          const auto least = std::min_element(direction.begin(), direction.end(),
                                              [](double a, double b) { return std::abs(a) < std::abs(b); });
          Vector3 other{0, 0, 0};
          other[static_cast<std::size_t>(least - direction.begin())] = 1;
          const Vector3 first = normalised(cross(direction, other));
          directions_[v] = {first, cross(direction, first), Vector3{0, 0, 0}};
          break;
        }
        case Foot::Kind::kCurve:
          directions_[v] = {direction, Vector3{0, 0, 0}, Vector3{0, 0, 0}};
          break;
        case Foot::Kind::kCorner:
          break;
      }
    });
    constexpr std::array<Index, 4> kDimensions{3, 2, 1, 0};
    for (std::size_t v = 0; v < feet.size(); ++v)
      begins_[v + 1] = begins_[v] + kDimensions[static_cast<std::size_t>(feet[v].kind)];
  }

  Index size() const { return begins_.back(); }

  Vector3 move_of(std::size_t vertex, const Eigen::VectorXd& x) const {
    Vector3 move{0, 0, 0};
    for (Index k = begins_[vertex]; k < begins_[vertex + 1]; ++k)
      move += x[k] * directions_[vertex][static_cast<std::size_t>(k - begins_[vertex])];
    return move;
  }

  void put_gradient(std::size_t vertex, const Vector3& gradient, Eigen::VectorXd& of_x) const {
    for (Index k = begins_[vertex]; k < begins_[vertex + 1]; ++k)
      of_x[k] = dot(gradient, directions_[vertex][static_cast<std::size_t>(k - begins_[vertex])]);
  }

 private:
  std::vector<std::array<Vector3, 3>> directions_;
  std::vector<Index> begins_;
};

/// The energy of a mesh in sizes of hexahedra.
class ShapeEnergy {
 public:
  ShapeEnergy(const HexMesh& mesh, double size, double volume_weight)
      : mesh_(mesh), scale_(1 / size), volume_weight_(volume_weight), terms_(mesh.hexahedra.size()) {
    std::vector<std::array<std::uint32_t, 2>> uses;
    for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h)
      for (std::uint32_t k = 0; k < 8; ++k) uses.push_back({mesh.hexahedra[h][k], 8 * h + k});
    uses_ = ListTable(mesh.vertices.size(), uses);
  }

  /// Of vertices moved by `x` sizes of hexahedra in the directions of their freedom.
  double operator()(const Freedom& freedom, const Eigen::VectorXd& x, double epsilon,
                    Eigen::VectorXd& gradient) {
    const std::vector<Vector3> places = moved(freedom, x);
    parallel_for(terms_.size(), [&](std::size_t h) { terms_[h] = term(places, h, epsilon); });
    double sum = 0;
    for (const Term& term : terms_) sum += term.value;
    const double weight = 1 / (8 * static_cast<double>(terms_.size()));
    gradient.resize(x.size());
    parallel_for(places.size(), [&](std::size_t v) {
      Vector3 of_vertex{0, 0, 0};
      for (const std::uint32_t use : uses_[v]) of_vertex += terms_[use / 8].gradient[use % 8];
      freedom.put_gradient(v, weight * of_vertex, gradient);
    });
    return weight * sum;
  }

  double least_determinant(const std::vector<Vector3>& places) const {
    double least = 1;
    for (std::size_t h = 0; h < terms_.size(); ++h)
      for (std::size_t k = 0; k < 8; ++k) {
        const auto [a, b, c] = edges(places, h, k);
        least = std::min(least, dot(cross(a, b), c));
      }
    return least;
  }

  /// In sizes of hexahedra.
  std::vector<Vector3> moved(const Freedom& freedom, const Eigen::VectorXd& x) const {
    std::vector<Vector3> places(mesh_.vertices.size());
    parallel_for(places.size(),
                 [&](std::size_t v) { places[v] = scale_ * mesh_.vertices[v] + freedom.move_of(v, x); });
    return places;
  }

 private:
  struct Term {
    double value = 0;
    std::array<Vector3, 8> gradient{};
  };

  std::array<Vector3, 3> edges(const std::vector<Vector3>& places, std::size_t h, std::size_t k) const {
    const auto& corners = mesh_.hexahedra[h];
    const auto& [a, b, c] = kHexNeighbours[k];
    const Vector3& at = places[corners[k]];
    return {places[corners[a]] - at, places[corners[b]] - at, places[corners[c]] - at};
  }

  Term term(const std::vector<Vector3>& places, std::size_t h, double epsilon) const {
    Term term;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto [a, b, c] = edges(places, h, k);
      const std::array<Vector3, 3> cofactors{cross(b, c), cross(c, a), cross(a, b)};
      const double determinant = dot(cofactors[2], c);
      const auto [chi, slope] = regularised(determinant, epsilon);
      const double squares = dot(a, a) + dot(b, b) + dot(c, c), root = std::cbrt(chi * chi);
      const double volumes = volume_weight_ * (1 + determinant * determinant) / chi;
      term.value += squares / root + volumes;
      const double by_determinant = -2.0 / 3 * squares / (root * chi) * slope +
                                    2 * volume_weight_ * determinant / chi - volumes / chi * slope;
      const std::array<Vector3, 3> own{a, b, c};
      for (std::size_t n = 0; n < 3; ++n) {
        const Vector3 by_edge = (2 / root) * own[n] + by_determinant * cofactors[n];
        term.gradient[kHexNeighbours[k][n]] += by_edge;
        term.gradient[k] += -by_edge;
      }
    }
    return term;
  }

  const HexMesh& mesh_;
  double scale_, volume_weight_;
  ListTable uses_;  ///< 8 times the hexahedron, and the corner
  std::vector<Term> terms_;
};

double score_of(const HexMesh& mesh, double good_enough) {
  const std::vector<double> quality = scaled_jacobians(mesh);
  double least = 1, sum = 0;
  for (const double q : quality) least = std::min(least, q), sum += q;
  constexpr double kMeanWeight = 0.2;
  return std::min(least, good_enough) + kMeanWeight * sum / static_cast<double>(quality.size());
}

}  // namespace

HexMesh smoothed(HexMesh mesh, const MapSurface& surface, const std::vector<Foot>& feet, double size,
                 const HexSmoothingOptions& options) {
  if (mesh.hexahedra.empty()) return mesh;
  HexMesh best = mesh;
  double best_score = score_of(mesh, options.good_enough);
  ShapeEnergy energy(mesh, size, options.volume_weight);
  const auto least_now = [&] {
    const Freedom none(mesh, surface, std::vector<Foot>(feet.size(), Foot{Foot::Kind::kCorner, 0}));
    return energy.least_determinant(energy.moved(none, Eigen::VectorXd()));
  };
  const double least = least_now();
  constexpr double kShare = 0.2, kWithoutFlips = 0.01;
  double epsilon =
      std::min(options.largest_epsilon, least < 0 ? std::max(1e-6, kShare * -least) : kWithoutFlips);
  int in_vain = 0;
  for (int round = 0; round < options.rounds && in_vain < options.rounds_in_vain; ++round) {
    const Freedom freedom(mesh, surface, feet);
    const Descent descent =
        minimised([&](const Eigen::VectorXd& x,
                      Eigen::VectorXd& gradient) { return energy(freedom, x, epsilon, gradient); },
                  // About the second derivative of the energy of cubes.
                  [&](const Eigen::VectorXd& gradient) -> Eigen::VectorXd {
                    return 0.25 * static_cast<double>(mesh.hexahedra.size()) * gradient;
                  },
                  Eigen::VectorXd::Zero(freedom.size()), options.descent);
    parallel_for(mesh.vertices.size(), [&](std::size_t v) {
      mesh.vertices[v] =
          surface.nearest(feet[v], mesh.vertices[v] + size * freedom.move_of(v, descent.x)).point;
    });
    const double score = score_of(mesh, options.good_enough);
    in_vain = score > best_score + options.least_gain ? 0 : in_vain + 1;
    if (score > best_score) best_score = score, best = mesh;
    epsilon = next_epsilon(least_now(), epsilon, descent.first_value, descent.value);
  }
  return best;
}

}  // namespace crossgrain
