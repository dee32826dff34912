// SPDX-License-Identifier: Apache-2.0
// The map of least energy, as a function of its integers.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>
#include <vector>

#include "map/map_energy.hpp"
#include "map/sparse_factor.hpp"

namespace crossgrain {

/// The least energy (MapEnergy) for given integers z: E(z) = z^T S z - 2 s^T z + c, with the Schur complement
/// S of its matrix onto the integer columns. `energy` must outlive it.
class PoissonMap {
 public:
  /// Factors the matrix of the continuous columns. Throws Error(kLimit) if that fails.
  explicit PoissonMap(const MapEnergy& energy);

  const MapEnergy& energy() const { return *energy_; }

  /// The integer columns, and those of them whose values only shift the map; all others are fixed by the
  /// energy.
  const std::vector<std::uint32_t>& integers() const { return integers_; }
  const std::vector<std::uint32_t>& continuous() const { return continuous_; }
  const std::vector<bool>& is_pinned() const { return is_pinned_; }

  /// Those that are not pinned, as places in integers().
  std::vector<Eigen::Index> free_integers() const;

  const Eigen::MatrixXd& schur() const { return schur_; }  ///< S

  /// The integers of least energy, not rounded, with zeros for those that are pinned.
  const Eigen::VectorXd& relaxed() const { return relaxed_; }

  /// All columns of the map of least energy with these integers.
  Eigen::VectorXd columns_for(const Eigen::VectorXd& integers) const;

  /// About the solution of K x = right (SparseFactor::solve_roughly) for the continuous columns alone, with
  /// zeros for all integers, or for these and after them free_integers().
  Eigen::VectorXd roughly_solved(const Eigen::VectorXd& right) const { return factor_->solve_roughly(right); }
  Eigen::VectorXd roughly_solved_with_integers(const Eigen::VectorXd& right) const;

  /// The same columns with other integers: the continuous ones move as the energy says, from where they are.
  Eigen::VectorXd moved(const Eigen::VectorXd& columns, const Eigen::VectorXd& integers) const;

 private:
  void split();
  void reduce();
  void find_relaxed(const Eigen::VectorXd& right);

  const MapEnergy* energy_;
  std::vector<std::uint32_t> integers_, continuous_;
  std::vector<bool> is_pinned_;
  Eigen::SparseMatrix<double> coupling_;  ///< of continuous rows and integer columns
  std::optional<SparseFactor> factor_;    ///< of the continuous columns
  Eigen::MatrixXd schur_;
  Eigen::LDLT<Eigen::MatrixXd> free_schur_;  ///< of free_integers()
  Eigen::VectorXd continuous_right_, relaxed_;
};

}  // namespace crossgrain
