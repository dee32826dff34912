// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/shape_energy.hpp"
#include "map/descent.hpp"
#include "map/foldover.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

/// Of the change of volume against that of shape.
constexpr double kVolumeWeight = 0.05;

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

/// The energy of a mesh in sizes of hexahedra, and of its vertices' moves within their freedom.
class SmoothingEnergy {
 public:
  SmoothingEnergy(const HexMesh& mesh, double size, int power)
      : mesh_(mesh),
        scale_(1 / size),
        power_(power),
        shapes_(mesh.vertices.size(), mesh.hexahedra, std::vector<double>(mesh.hexahedra.size(), 1.0)) {}

  /// Of vertices moved by `x` sizes of hexahedra in the directions of their freedom.
  double operator()(const Freedom& freedom, const Eigen::VectorXd& x, double epsilon,
                    Eigen::VectorXd& gradient) {
    std::vector<Vector3> of_vertices;
    const double sum = shapes_(moved(freedom, x), {kVolumeWeight, power_, epsilon}, of_vertices);
    const double weight = 1 / (8 * static_cast<double>(mesh_.hexahedra.size()));
    gradient.resize(x.size());
    parallel_for(of_vertices.size(),
                 [&](std::size_t v) { freedom.put_gradient(v, weight * of_vertices[v], gradient); });
    return weight * sum;
  }

  /// At most 1.
  double least_determinant() const {
    std::vector<Vector3> places;
    for (const Vector3& place : mesh_.vertices) places.push_back(scale_ * place);
    return std::min(1.0, shapes_.least_determinant(places));
  }

 private:
  /// In sizes of hexahedra.
  std::vector<Vector3> moved(const Freedom& freedom, const Eigen::VectorXd& x) const {
    std::vector<Vector3> places(mesh_.vertices.size());
    parallel_for(places.size(),
                 [&](std::size_t v) { places[v] = scale_ * mesh_.vertices[v] + freedom.move_of(v, x); });
    return places;
  }

  const HexMesh& mesh_;
  double scale_;
  int power_;
  ShapeEnergy shapes_;
};

/// What decides between two meshes: more is better.
struct Score {
  std::size_t good = 0;  ///< hexahedra that are not inverted
  double shape = 0;
};

/// Of the score, below which a round is in vain.
constexpr double kLeastGain = 1e-3;

/// The shape is the least scaled Jacobian, as far as it is below 0.5, and half of the mean: at most 1.
Score score_of(const HexMesh& mesh) {
  constexpr double kGoodEnough = 0.5, kMeanWeight = 0.5;
  const std::vector<double> quality = scaled_jacobians(mesh);
  Score score;
  double least = 1, sum = 0;
  for (const double q : quality) {
    least = std::min(least, q);
    sum += q;
  }
  for (const std::uint8_t is_inverted : inverted_hexahedra(mesh)) score.good += !is_inverted;
  score.shape = std::min(least, kGoodEnough) + kMeanWeight * sum / static_cast<double>(quality.size());
  return score;
}

/// Vertices of inverted hexahedra.
std::vector<bool> in_inverted(const HexMesh& mesh) {
  const std::vector<std::uint8_t> is_inverted = inverted_hexahedra(mesh);
  std::vector<bool> result(mesh.vertices.size(), false);
  for (std::size_t h = 0; h < is_inverted.size(); ++h)
    if (is_inverted[h])
      for (const std::uint32_t v : mesh.hexahedra[h]) result[v] = true;
  return result;
}

/// Moves the vertices of a mesh in rounds.
class Smoothing {
 public:
  Smoothing(HexMesh mesh, const MapSurface& surface, const std::vector<Foot>& feet, double size,
            const HexSmoothingOptions& options)
      : best(std::move(mesh)),
        surface_(surface),
        feet_(feet),
        size_(size),
        options_(options),
        best_score_(score_of(best)) {}

  HexMesh best;

  bool is_valid() const { return best_score_.good == best.hexahedra.size(); }

  /// Whether a round could be a gain: of cubes there is none.
  bool may_gain() const { return !is_valid() || best_score_.shape + kLeastGain < 1; }

  /// Rounds from the best mesh on; vertices that are `loose` may leave the surface.
  /// `share` of the smoothing is done before it, and another `own_share` after it.
  void run(int power, const std::vector<bool>& loose, double share, double own_share);

 private:
  Foot foot(std::size_t vertex, const std::vector<bool>& loose) const {
    return loose[vertex] ? Foot{} : feet_[vertex];
  }
  Vector3 held(std::size_t vertex, const Vector3& point, bool is_loose) const;

  const MapSurface& surface_;
  const std::vector<Foot>& feet_;
  double size_;
  const HexSmoothingOptions& options_;
  Score best_score_;
};

Vector3 Smoothing::held(std::size_t vertex, const Vector3& point, bool is_loose) const {
  const Vector3 nearest = surface_.nearest(feet_[vertex], point).point;
  if (!is_loose) return nearest;
  const Vector3 off = point - nearest;
  const double length = norm(off), most = options_.slack * size_;
  return length <= most ? point : nearest + (most / length) * off;
}

void Smoothing::run(int power, const std::vector<bool>& loose, double share, double own_share) {
  tell_watched(Phase::kSmooth, share);
  if (!may_gain()) return;
  HexMesh mesh = best;
  SmoothingEnergy energy(mesh, size_, power);
  constexpr int kRoundsInVain = 6;
  double epsilon = first_epsilon(energy.least_determinant());
  std::vector<Foot> feet;
  for (std::size_t v = 0; v < feet_.size(); ++v) feet.push_back(foot(v, loose));
  int in_vain = 0;
  for (int round = 0; round < options_.rounds && in_vain < kRoundsInVain && may_gain(); ++round) {
    tell_watched(Phase::kSmooth, share + own_share * round / options_.rounds);
    const Freedom freedom(mesh, surface_, feet);
    const Descent descent =
        minimised([&](const Eigen::VectorXd& x,
                      Eigen::VectorXd& gradient) { return energy(freedom, x, epsilon, gradient); },
                  // About the second derivative of the energy of cubes.
                  [&](const Eigen::VectorXd& gradient, Eigen::VectorXd& result) {
                    result = 0.25 * static_cast<double>(mesh.hexahedra.size()) * gradient;
                  },
                  Eigen::VectorXd::Zero(freedom.size()), {.steps = 20});
    parallel_for(mesh.vertices.size(), [&](std::size_t v) {
      mesh.vertices[v] = held(v, mesh.vertices[v] + size_ * freedom.move_of(v, descent.x), loose[v]);
    });
    const Score score = score_of(mesh);
    const bool is_gain = score.good > best_score_.good ||
                         (score.good == best_score_.good && score.shape > best_score_.shape + kLeastGain);
    in_vain = is_gain ? 0 : in_vain + 1;
    if (is_gain) best_score_ = score, best = mesh;
    epsilon = next_epsilon(energy.least_determinant(), epsilon, descent.first_value, descent.value);
  }
}

}  // namespace

HexMesh smoothed(HexMesh mesh, const MapSurface& surface, const std::vector<Foot>& feet, double size,
                 const HexSmoothingOptions& options) {
  if (mesh.hexahedra.empty()) return mesh;
  Smoothing smoothing(std::move(mesh), surface, feet, size, options);
  const std::vector<bool> none(feet.size(), false);
  // Loose vertices take as many rounds again, where they are needed.
  const double own_share = 0.5 / static_cast<double>(options.powers.size());
  double share = 0;
  for (const int power : options.powers) smoothing.run(power, none, share, own_share), share += own_share;
  if (!smoothing.is_valid() && options.slack > 0)
    for (const int power : options.powers)
      smoothing.run(power, in_inverted(smoothing.best), share, own_share), share += own_share;
  return std::move(smoothing.best);
}

}  // namespace crossgrain
