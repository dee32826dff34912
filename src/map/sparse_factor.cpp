// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <cstdio>  // scotch.h needs it and does not include it

#include <scotch.h>

#include <Eigen/SparseCholesky>
#include <new>
#include <vector>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// Throws for what SCOTCH's functions return: it fails where memory does.
void demand(int code) {
  if (code != 0) throw std::bad_alloc();
}

/// State of SCOTCH's for one call: with random numbers of its own and one thread, so that the result is the
/// same whatever else the process does.
class Context {
 public:
  Context() {
    demand(SCOTCH_contextInit(&context_));
    SCOTCH_contextRandomSeed(&context_, 1);
    demand(SCOTCH_contextOptionSetNum(&context_, SCOTCH_OPTIONNUMDETERMINISTIC, 1));
    demand(SCOTCH_contextThreadSpawn(&context_, 1, nullptr));
  }
  ~Context() { SCOTCH_contextExit(&context_); }
  Context(const Context&) = delete;

  void bind(const SCOTCH_Graph& graph, SCOTCH_Graph& bound) {
    demand(SCOTCH_contextBindGraph(&context_, &graph, &bound));
  }

 private:
  SCOTCH_Context context_;
};

class Graph {
 public:
  Graph() { demand(SCOTCH_graphInit(&graph_)); }
  ~Graph() { SCOTCH_graphExit(&graph_); }
  Graph(const Graph&) = delete;
  SCOTCH_Graph& operator*() { return graph_; }

 private:
  SCOTCH_Graph graph_;
};

class Strategy {
 public:
  Strategy() { demand(SCOTCH_stratInit(&strategy_)); }
  ~Strategy() { SCOTCH_stratExit(&strategy_); }
  Strategy(const Strategy&) = delete;
  SCOTCH_Strat& operator*() { return strategy_; }

 private:
  SCOTCH_Strat strategy_;
};

/// The place of each row in an order of nested dissection.
Permutation dissection(const Sparse& matrix) {
  const auto size = static_cast<SCOTCH_Num>(matrix.cols());
  std::vector<SCOTCH_Num> begins{0}, neighbours;
  for (SCOTCH_Num column = 0; column < size; ++column) {
    for (Sparse::InnerIterator it(matrix, column); it; ++it)
      if (it.row() != column) neighbours.push_back(static_cast<SCOTCH_Num>(it.row()));
    begins.push_back(static_cast<SCOTCH_Num>(neighbours.size()));
  }
  Context context;
  Graph graph, bound;
  Strategy strategy;
  demand(SCOTCH_graphBuild(&*graph, 0, size, begins.data(), nullptr, nullptr, nullptr,
                           static_cast<SCOTCH_Num>(neighbours.size()), neighbours.data(), nullptr));
  context.bind(*graph, *bound);
  Permutation places(matrix.cols());
  static_assert(sizeof(SCOTCH_Num) == sizeof(int));
  demand(SCOTCH_graphOrder(&*bound, &*strategy, places.indices().data(), nullptr, nullptr, nullptr, nullptr));
  return places;
}

}  // namespace

struct SparseFactor::Factor {
  Permutation places;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;
};

SparseFactor::SparseFactor(const Sparse& matrix) {
  auto factor = std::make_unique<Factor>();
  if (matrix.cols() > 0) {
    factor->places = dissection(matrix);
    Sparse ordered;
    ordered = matrix.twistedBy(factor->places);
    factor->ldlt.compute(ordered);
    if (factor->ldlt.info() != Eigen::Success || factor->ldlt.vectorD().minCoeff() <= 0)
      throw Error(ErrorKind::kLimit, "the equations of the map cannot be solved: tets are too flat");
  }
  factor_ = std::move(factor);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& right) const {
  if (right.size() == 0) return right;
  const Eigen::VectorXd ordered = factor_->places * right;
  return factor_->places.transpose() * factor_->ldlt.solve(ordered).eval();
}

Eigen::MatrixXd SparseFactor::solve_all(const Eigen::MatrixXd& rights) const {
  if (rights.size() == 0) return rights;
  const Eigen::MatrixXd ordered = factor_->places * rights;
  return factor_->places.transpose() * factor_->ldlt.solve(ordered).eval();
}

}  // namespace crossgrain
