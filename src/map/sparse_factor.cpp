// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <cstdio>  // scotch.h needs it and does not include it

#include <scotch.h>

#include <Eigen/SparseCholesky>
#include <map>
#include <mutex>
#include <new>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
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

/// The place of each row in an order of nested dissection. One call at a time: with two at once SCOTCH 7.0.3
/// gives other orders, though each has a context of its own.
Permutation dissection(const Sparse& matrix) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
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

/// A block of the matrix that no entry joins to the rest.
struct SparseFactor::Block {
  std::vector<Eigen::Index> rows;
  Permutation places;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;

  void compute(const Sparse& block) {
    places = dissection(block);
    Sparse ordered;
    ordered = block.twistedBy(places);
    ldlt.compute(ordered);
    if (ldlt.info() != Eigen::Success || ldlt.vectorD().minCoeff() <= 0)
      throw Error(ErrorKind::kLimit, "the equations of the map cannot be solved: tets are too flat");
  }
};

SparseFactor::SparseFactor(const Sparse& matrix) {
  const auto size = static_cast<std::uint32_t>(matrix.cols());
  DisjointSets sets(size);
  for (std::uint32_t column = 0; column < size; ++column)
    for (Sparse::InnerIterator it(matrix, column); it; ++it)
      sets.join(column, static_cast<std::uint32_t>(it.row()));
  std::map<std::uint32_t, std::size_t> block_of_root;
  std::vector<std::size_t> block_of(size);
  std::vector<Eigen::Index> place(size);
  for (std::uint32_t row = 0; row < size; ++row) {
    const auto [known, is_new] = block_of_root.try_emplace(sets.root(row), blocks_.size());
    if (is_new) blocks_.push_back(std::make_unique<Block>());
    block_of[row] = known->second;
    std::vector<Eigen::Index>& rows = blocks_[known->second]->rows;
    place[row] = static_cast<Eigen::Index>(rows.size());
    rows.push_back(row);
  }
  parallel_for(
      blocks_.size(),
      [&](std::size_t k) {
        const std::vector<Eigen::Index>& rows = blocks_[k]->rows;
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t column = 0; column < rows.size(); ++column)
          for (Sparse::InnerIterator it(matrix, rows[column]); it; ++it)
            entries.emplace_back(place[static_cast<std::size_t>(it.row())], column, it.value());
        const auto count = static_cast<Eigen::Index>(rows.size());
        Sparse block(count, count);
        block.setFromTriplets(entries.begin(), entries.end());
        blocks_[k]->compute(block);
      },
      /*grain=*/1);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd solution(right.size());
  parallel_for(
      blocks_.size(),
      [&](std::size_t k) {
        const Block& block = *blocks_[k];
        Eigen::VectorXd part(static_cast<Eigen::Index>(block.rows.size()));
        for (Eigen::Index row = 0; row < part.size(); ++row)
          part[block.places.indices()[row]] = right[block.rows[static_cast<std::size_t>(row)]];
        part = block.ldlt.solve(part).eval();
        for (Eigen::Index row = 0; row < part.size(); ++row)
          solution[block.rows[static_cast<std::size_t>(row)]] = part[block.places.indices()[row]];
      },
      /*grain=*/1);
  return solution;
}

}  // namespace crossgrain
