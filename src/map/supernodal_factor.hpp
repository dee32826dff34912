// SPDX-License-Identifier: Apache-2.0
// Cholesky factors of large sparse matrices, in dense blocks.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "map/supernodes.hpp"

namespace crossgrain {

/// L of A = L L^T, left-looking over supernodes (Ng and Peyton, SIAM J. Sci. Comput. 14, 1993), with Eigen's
/// dense products; Real is double or float. Branches of the tree of supernodes, and rows of large supernodes,
/// are parallel. The same to the bit for any number of threads.
template <class Real>
class SupernodalFactor {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// Takes all entries of both triangles, of a matrix with these supernodes. `nodes` must outlive the factor.
  SupernodalFactor(const Eigen::SparseMatrix<double>& matrix, const Supernodes& nodes);

  /// Whether all pivots are positive numbers; if not, there is nothing to solve with.
  bool is_positive() const { return is_positive_; }

  /// About A^-1 right, with the rounding of Real; as many numbers as rows. Only if is_positive(). Safe to
  /// call from several threads at once.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Panel = Eigen::Map<Matrix>;

  /// Supernodes one after the other: branches of little work below one parent, or one supernode with much.
  struct Task {
    std::size_t begin = 0, end = 0;
  };

  void divide();
  bool should_join(const Task& task, double work, double most) const;
  Panel panel(std::size_t node) const;
  void assemble(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& row_at, std::size_t node);
  void subtract(std::size_t node, const std::vector<int>& local, Eigen::Index begin, Eigen::Index end);
  bool eliminate(std::size_t node);
  void forward(std::size_t node, Vector& x, std::vector<Vector>& carried) const;
  void backward(std::size_t node, Vector& x) const;

  const Supernodes& nodes_;
  bool is_positive_ = true;
  std::vector<std::size_t> offsets_;  ///< of the panels in values_
  std::unique_ptr<Real[]> values_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<Task> tasks_;
  std::vector<std::vector<std::uint32_t>> beside_, beside_reversed_;  ///< parents and children among tasks
};

}  // namespace crossgrain
