// SPDX-License-Identifier: Apache-2.0
#include "map/untangling.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "map/descent.hpp"
#include "map/foldover.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

/// Of the change of volume against that of shape.
constexpr double kVolumeWeight = 0.1;

/// The end of rounds if so many do not lower the flips by `kLeastFall` of them.
constexpr int kRoundsInVain = 4;
constexpr double kLeastFall = 0.1;

/// The function that is minimised, of the free columns.
class Distortion {
 public:
  Distortion(const MapEnergy& energy, const Eigen::VectorXd& columns, const std::vector<std::uint32_t>& free)
      : energy_(energy) {
    const std::size_t tets = energy.unknowns().cut().copies_of_tets().size();
    for (std::size_t t = 0; t < tets; ++t) all_ += energy.volume(t);
    terms_.resize(tets);
    std::vector<Eigen::Triplet<double>> chosen;
    Eigen::VectorXd fixed = columns;
    for (std::size_t k = 0; k < free.size(); ++k) {
      chosen.emplace_back(free[k], static_cast<Index>(k), 1.0);
      fixed[free[k]] = 0;
    }
    Sparse selection(columns.size(), static_cast<Index>(free.size()));
    selection.setFromTriplets(chosen.begin(), chosen.end());
    basis_ = energy.basis() * selection;
    transposed_ = basis_.transpose();
    fixed_ = energy.basis() * fixed;
  }

  MapCoordinates map(const Eigen::VectorXd& x) const { return fixed_ + basis_ * x; }

  double operator()(const Eigen::VectorXd& x, double epsilon, Eigen::VectorXd& gradient) {
    const MapCoordinates map = this->map(x);
    parallel_for(terms_.size(), [&](std::size_t t) { terms_[t] = term(map, t, epsilon); });
    double sum = 0;
    for (const Term& term : terms_) sum += term.value;
    Eigen::VectorXd of_map = Eigen::VectorXd::Zero(map.size());
    const auto& copies = energy_.unknowns().cut().copies_of_tets();
    for (std::size_t t = 0; t < terms_.size(); ++t)
      for (std::size_t a = 0; a < 4; ++a)
        of_map.segment<3>(static_cast<Index>(3 * copies[t][a])) +=
            terms_[t].gradient.col(static_cast<Index>(a));
    gradient = transposed_ * of_map;
    return sum;
  }

 private:
  struct Term {
    double value = 0;
    Eigen::Matrix<double, 3, 4> gradient;  ///< by the coordinates of the corners
  };

  Term term(const MapCoordinates& map, std::size_t t, double epsilon) const {
    const Eigen::Matrix3d jacobian = energy_.jacobian(map, t);
    const double determinant = jacobian.determinant();
    const auto [chi, slope] = regularised(determinant, epsilon);
    const double squares = jacobian.squaredNorm(), root = cube_root(chi * chi);
    const double volumes = kVolumeWeight * (1 + determinant * determinant) / chi;
    const double weight = energy_.volume(t) / all_;
    Term term;
    term.value = weight * (squares / root + volumes);
    const double by_determinant = -2.0 / 3 * squares / (root * chi) * slope +
                                  2 * kVolumeWeight * determinant / chi - volumes / chi * slope;
    Eigen::Matrix3d cofactors;
    cofactors.row(0) = jacobian.row(1).cross(jacobian.row(2));
    cofactors.row(1) = jacobian.row(2).cross(jacobian.row(0));
    cofactors.row(2) = jacobian.row(0).cross(jacobian.row(1));
    term.gradient =
        weight * energy_.size() * (2 / root * jacobian + by_determinant * cofactors) * energy_.gradients(t);
    return term;
  }

  const MapEnergy& energy_;
  double all_ = 0;
  Sparse basis_, transposed_;
  MapCoordinates fixed_;
  std::vector<Term> terms_;
};

std::vector<std::uint32_t> free_columns(const PoissonMap& poisson, IntegerColumns integers) {
  std::vector<std::uint32_t> free = poisson.continuous();
  if (integers == IntegerColumns::kFree)
    for (const Index k : poisson.free_integers())
      free.push_back(poisson.integers()[static_cast<std::size_t>(k)]);
  return free;
}

}  // namespace

Untangled untangled(const PoissonMap& poisson, Eigen::VectorXd columns, IntegerColumns integers,
                    const UntanglingOptions& options) {
  const MapEnergy& energy = poisson.energy();
  const std::vector<std::uint32_t> free = free_columns(poisson, integers);
  Distortion distortion(energy, columns, free);
  const Preconditioner preconditioner = [&](const Eigen::VectorXd& gradient, Eigen::VectorXd& result) {
    result = integers == IntegerColumns::kFree ? poisson.roughly_solved_with_integers(gradient)
                                               : poisson.roughly_solved(gradient);
  };
  Eigen::VectorXd x(static_cast<Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) x[static_cast<Index>(k)] = columns[free[k]];
  Untangled result;
  result.flips = flips_of(energy, distortion.map(x));
  const MapFlips given = result.flips;
  double epsilon = first_epsilon(given.least_determinant);
  std::size_t before = result.flips.tets;
  int in_vain = 0;
  for (int round = 0; round < options.rounds && in_vain < kRoundsInVain; ++round) {
    const Descent descent =
        minimised([&](const Eigen::VectorXd& at,
                      Eigen::VectorXd& gradient) { return distortion(at, epsilon, gradient); },
                  preconditioner, std::move(x), options.descent);
    x = descent.x;
    result.steps += descent.steps;
    result.flips = flips_of(energy, distortion.map(x));
    if (result.flips.tets == 0) break;
    const bool falls =
        static_cast<double>(result.flips.tets) <= (1 - kLeastFall) * static_cast<double>(before);
    in_vain = falls ? 0 : in_vain + 1;
    if (falls) before = result.flips.tets;
    epsilon = next_epsilon(result.flips.least_determinant, epsilon, descent.first_value, descent.value);
  }
  if (result.flips.tets > given.tets)
    result.flips = given;
  else
    for (std::size_t k = 0; k < free.size(); ++k) columns[free[k]] = x[static_cast<Index>(k)];
  result.columns = std::move(columns);
  return result;
}

}  // namespace crossgrain
