// SPDX-License-Identifier: Apache-2.0
#include "map/supernodal_factor.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <numeric>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Index = Eigen::Index;

/// Branches of the tree with at most this share of the work are tasks: enough of them for 32 threads.
constexpr double kShareOfTask = 1.0 / 64;

/// Rows of a panel that one thread works on: as many as a supernode has columns, so that products of blocks
/// run at full speed.
constexpr std::size_t kRowsAtATime = 256;

/// Multiplications of a supernode, about: those of its elimination and of its updates of others.
double work_of(const Supernodes& nodes, std::size_t node) {
  const double columns = nodes.columns(node);
  const double rows = columns + static_cast<double>(nodes.below(node).size());
  return columns * rows * rows;
}

}  // namespace

template <class Real>
SupernodalFactor<Real>::SupernodalFactor(const Sparse& matrix, const Supernodes& nodes) : nodes_(nodes) {
  divide();
  offsets_.push_back(0);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const auto columns = static_cast<std::size_t>(nodes.columns(node));
    offsets_.push_back(offsets_.back() + columns * (columns + nodes.below(node).size()));
  }
  values_ = std::make_unique_for_overwrite<Real[]>(offsets_.back());
  std::vector<int> row_at(nodes.places().size());
  for (std::size_t row = 0; row < row_at.size(); ++row)
    row_at[static_cast<std::size_t>(nodes.places()[row])] = static_cast<int>(row);
  std::atomic<bool> is_positive{true};
  parallel_for_in_order(beside_, [&](std::size_t task) {
    std::vector<int> local(row_at.size());
    for (std::size_t node = tasks_[task].begin; node < tasks_[task].end && is_positive; ++node) {
      assemble(matrix, row_at, node);
      const int begin = nodes_.begin(node), columns = nodes_.columns(node);
      std::iota(local.begin() + begin, local.begin() + begin + columns, 0);
      int place = columns;
      for (const int row : nodes_.below(node)) local[static_cast<std::size_t>(row)] = place++;
      parallel_for_chunks(static_cast<std::size_t>(place), kRowsAtATime,
                          [&](std::size_t first, std::size_t end) {
                            subtract(node, local, static_cast<Index>(first), static_cast<Index>(end));
                          });
      if (!eliminate(node)) is_positive = false;
    }
  });
  is_positive_ = is_positive;
}

template <class Real>
void SupernodalFactor<Real>::divide() {
  const std::size_t size = nodes_.size();
  std::vector<double> work(size);
  std::vector<std::size_t> first(size);  // of the branch below each
  children_.resize(size);
  double all = 0;
  for (std::size_t node = 0; node < size; ++node) {
    all += work_of(nodes_, node);
    work[node] += work_of(nodes_, node);
    first[node] = children_[node].empty() ? node : first[children_[node].front()];
    const std::size_t parent = nodes_.parent(node);
    if (parent == node) continue;
    work[parent] += work[node];
    children_[parent].push_back(static_cast<std::uint32_t>(node));
  }
  double joined_work = all;  // of the last task; no task grows beyond the share
  for (std::size_t node = 0; node < size; ++node) {
    const std::size_t parent = nodes_.parent(node);
    const bool is_small = work[node] <= kShareOfTask * all;
    if (is_small && parent != node && work[parent] <= kShareOfTask * all) continue;
    const Task task{is_small ? first[node] : node, node + 1};
    if (is_small && should_join(task, joined_work + work[node], kShareOfTask * all)) {
      tasks_.back().end = task.end;
      joined_work += work[node];
    } else {
      tasks_.push_back(task);
      joined_work = is_small ? work[node] : all;
    }
  }
  std::vector<std::uint32_t> task_of(size);
  for (std::uint32_t task = 0; task < tasks_.size(); ++task)
    for (std::size_t node = tasks_[task].begin; node < tasks_[task].end; ++node) task_of[node] = task;
  const auto count = static_cast<std::uint32_t>(tasks_.size());
  beside_.resize(count);
  beside_reversed_.resize(count);
  for (std::uint32_t task = 0; task < count; ++task) {
    const std::size_t last = tasks_[task].end - 1, parent = nodes_.parent(last);
    if (parent == last) continue;
    const std::uint32_t above = task_of[parent];
    beside_[task].push_back(above);
    beside_[above].push_back(task);
    beside_reversed_[count - 1 - task].push_back(count - 1 - above);
    beside_reversed_[count - 1 - above].push_back(count - 1 - task);
  }
}

/// Whether a branch becomes part of the last task, which has branches below the same parent, or other whole
/// trees.
template <class Real>
bool SupernodalFactor<Real>::should_join(const Task& task, double work, double most) const {
  if (tasks_.empty() || work > most) return false;
  const std::size_t before = tasks_.back().end - 1, last = task.end - 1;
  const bool are_roots = nodes_.parent(before) == before && nodes_.parent(last) == last;
  return are_roots || nodes_.parent(before) == nodes_.parent(last);
}

template <class Real>
auto SupernodalFactor<Real>::panel(std::size_t node) const -> Panel {
  const Index columns = nodes_.columns(node);
  return Panel(values_.get() + offsets_[node], columns + static_cast<Index>(nodes_.below(node).size()),
               columns);
}

template <class Real>
void SupernodalFactor<Real>::assemble(const Sparse& matrix, const std::vector<int>& row_at,
                                      std::size_t node) {
  Panel panel = this->panel(node);
  panel.setZero();
  const int begin = nodes_.begin(node), columns = nodes_.columns(node);
  const std::span<const int> below = nodes_.below(node);
  for (int column = begin; column < begin + columns; ++column)
    for (Sparse::InnerIterator it(matrix, row_at[static_cast<std::size_t>(column)]); it; ++it) {
      const int row = nodes_.places()[static_cast<std::size_t>(it.row())];
      if (row < column) continue;
      const Index local = row < begin + columns
                              ? row - begin
                              : columns + (std::lower_bound(below.begin(), below.end(), row) - below.begin());
      panel(local, column - begin) += static_cast<Real>(it.value());
    }
}

/// Takes the products of lower supernodes off the rows [begin, end) of the panel; `local` says which rows of
/// the panel rows are.
template <class Real>
void SupernodalFactor<Real>::subtract(std::size_t node, const std::vector<int>& local, Index begin,
                                      Index end) {
  Panel target = panel(node);
  Matrix products(end - begin, target.cols());
  const auto local_of = [&](int row) { return local[static_cast<std::size_t>(row)]; };
  for (const Supernodes::Part& part : nodes_.parts(node)) {
    const std::span<const int> rows = nodes_.below(part.node);
    const auto at = [&](Index local_row) {
      return std::partition_point(rows.begin() + part.begin, rows.end(),
                                  [&](int row) { return local_of(row) < local_row; }) -
             rows.begin();
    };
    const Index first = at(begin), last = at(end), count = part.end - part.begin;
    if (first == last) continue;
    const Panel source = panel(part.node);
    const Index columns = source.cols();
    auto product = products.topLeftCorner(last - first, count);
    product.noalias() = source.middleRows(columns + first, last - first) *
                        source.middleRows(columns + part.begin, count).transpose();
    for (Index column = 0; column < count; ++column) {
      Real* const to = &target(0, local_of(rows[part.begin + static_cast<std::size_t>(column)]));
      for (Index row = 0; row < last - first; ++row)
        to[local_of(rows[static_cast<std::size_t>(first + row)])] -= product(row, column);
    }
  }
}

/// Whether the pivots are positive.
template <class Real>
bool SupernodalFactor<Real>::eliminate(std::size_t node) {
  Panel panel = this->panel(node);
  const Index columns = panel.cols(), below = panel.rows() - columns;
  auto diagonal = panel.topRows(columns);
  const Eigen::LLT<Eigen::Ref<Matrix>> llt(diagonal);
  if (llt.info() != Eigen::Success || !panel.diagonal().allFinite()) return false;
  parallel_for_chunks(static_cast<std::size_t>(below), kRowsAtATime, [&](std::size_t begin, std::size_t end) {
    auto rows = panel.middleRows(columns + static_cast<Index>(begin), static_cast<Index>(end - begin));
    diagonal.template triangularView<Eigen::Lower>().transpose().template solveInPlace<Eigen::OnTheRight>(
        rows);
  });
  return true;
}

template <class Real>
Eigen::VectorXd SupernodalFactor<Real>::solve(const Eigen::VectorXd& right) const {
  const std::vector<int>& places = nodes_.places();
  const double largest = right.size() == 0 ? 0 : right.cwiseAbs().maxCoeff();
  if (largest == 0) return right;
  // Numbers near 1 are within the range of Real.
  Vector x(right.size());
  for (Index row = 0; row < x.size(); ++row)
    x[places[static_cast<std::size_t>(row)]] = static_cast<Real>(right[row] / largest);
  std::vector<Vector> carried(nodes_.size());
  parallel_for_in_order(beside_, [&](std::size_t task) {
    for (std::size_t node = tasks_[task].begin; node < tasks_[task].end; ++node) forward(node, x, carried);
  });
  parallel_for_in_order(beside_reversed_, [&](std::size_t reversed) {
    const Task& task = tasks_[tasks_.size() - 1 - reversed];
    for (std::size_t node = task.end; node-- > task.begin;) backward(node, x);
  });
  Eigen::VectorXd solution(right.size());
  for (Index row = 0; row < x.size(); ++row)
    solution[row] = largest * static_cast<double>(x[places[static_cast<std::size_t>(row)]]);
  return solution;
}

/// Solves the rows of a supernode in L x = right. `carried` has, for rows below each, what it and its branch
/// add to them.
template <class Real>
void SupernodalFactor<Real>::forward(std::size_t node, Vector& x, std::vector<Vector>& carried) const {
  const Panel panel = this->panel(node);
  const Index begin = nodes_.begin(node), columns = panel.cols(), below = panel.rows() - columns;
  const std::span<const int> rows = nodes_.below(node);
  Vector& carry = carried[node];
  carry.setZero(below);
  for (const std::uint32_t child : children_[node]) {
    std::size_t place = 0;
    const std::span<const int> from = nodes_.below(child);
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Real value = carried[child][static_cast<Index>(k)];
      if (from[k] < begin + columns) {
        x[from[k]] += value;
      } else {
        while (rows[place] < from[k]) ++place;
        carry[static_cast<Index>(place)] += value;
      }
    }
    carried[child].resize(0);
  }
  auto own = x.segment(begin, columns);
  panel.topRows(columns).template triangularView<Eigen::Lower>().solveInPlace(own);
  carry.noalias() -= panel.bottomRows(below) * own;
}

/// Solves the rows of a supernode in L^T x = right, once those of its ancestors are solved.
template <class Real>
void SupernodalFactor<Real>::backward(std::size_t node, Vector& x) const {
  const Panel panel = this->panel(node);
  const Index columns = panel.cols(), below = panel.rows() - columns;
  const std::span<const int> rows = nodes_.below(node);
  Vector above(below);
  for (Index k = 0; k < below; ++k) above[k] = x[rows[static_cast<std::size_t>(k)]];
  auto own = x.segment(nodes_.begin(node), columns);
  own.noalias() -= panel.bottomRows(below).transpose() * above;
  panel.topRows(columns).template triangularView<Eigen::Lower>().transpose().solveInPlace(own);
}

template class SupernodalFactor<float>;
template class SupernodalFactor<double>;

}  // namespace crossgrain
