// SPDX-License-Identifier: Apache-2.0
#include "map/nested_dissection.hpp"

#include <scotch.h>

#include <mutex>
#include <new>

namespace crossgrain {
namespace {

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

}  // namespace

std::vector<int> nested_dissection(const Eigen::SparseMatrix<double>& matrix) {
  // One call at a time: with two at once SCOTCH 7.0.3 gives other orders, though each has a context of its
  // own.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const auto size = static_cast<SCOTCH_Num>(matrix.cols());
  std::vector<SCOTCH_Num> begins{0}, neighbours;
  for (SCOTCH_Num column = 0; column < size; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
      if (it.row() != column) neighbours.push_back(static_cast<SCOTCH_Num>(it.row()));
    begins.push_back(static_cast<SCOTCH_Num>(neighbours.size()));
  }
  Context context;
  Graph graph, bound;
  Strategy strategy;
  demand(SCOTCH_graphBuild(&*graph, 0, size, begins.data(), nullptr, nullptr, nullptr,
                           static_cast<SCOTCH_Num>(neighbours.size()), neighbours.data(), nullptr));
  context.bind(*graph, *bound);
  static_assert(sizeof(SCOTCH_Num) == sizeof(int), "SCOTCH with indices of 32 bits");
  std::vector<SCOTCH_Num> places(static_cast<std::size_t>(size));
  demand(SCOTCH_graphOrder(&*bound, &*strategy, places.data(), nullptr, nullptr, nullptr, nullptr));
  return places;
}

}  // namespace crossgrain
