// SPDX-License-Identifier: Apache-2.0
#include "map/supernodes.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int kNone = -1;

using Pattern = std::vector<std::vector<int>>;  ///< rows of each column

/// The rows of each column for which `is_wanted(row, column)`, of a matrix whose rows have other places.
template <class IsWanted>
Pattern pattern_of(const Sparse& matrix, const std::vector<int>& places, const IsWanted& is_wanted) {
  Pattern rows(places.size());
  for (int column = 0; column < matrix.cols(); ++column)
    for (Sparse::InnerIterator it(matrix, column); it; ++it) {
      const int row = places[static_cast<std::size_t>(it.row())],
                at = places[static_cast<std::size_t>(column)];
      if (is_wanted(row, at)) rows[static_cast<std::size_t>(at)].push_back(row);
    }
  return rows;
}

/// The parent of each column in the tree of elimination (Liu, ACM TOMS 12, 1986).
std::vector<int> elimination_tree(const Pattern& above) {
  const std::size_t size = above.size();
  std::vector<int> parents(size, kNone), tops(size, kNone);
  for (std::size_t column = 0; column < size; ++column)
    for (int row : above[column])
      while (row != kNone && row != static_cast<int>(column)) {
        int& top = tops[static_cast<std::size_t>(row)];
        const int next = top;
        top = static_cast<int>(column);
        if (next == kNone) parents[static_cast<std::size_t>(row)] = static_cast<int>(column);
        row = next;
      }
  return parents;
}

/// The place of each node in an order in which the nodes below a node come right before it.
std::vector<int> postorder(const std::vector<int>& parents) {
  const std::size_t size = parents.size();
  std::vector<int> child(size, kNone), sibling(size, kNone), places(size), roots;
  for (std::size_t node = size; node-- > 0;) {
    if (parents[node] == kNone) {
      roots.push_back(static_cast<int>(node));
      continue;
    }
    int& first = child[static_cast<std::size_t>(parents[node])];
    sibling[node] = first;
    first = static_cast<int>(node);
  }
  int place = 0;
  std::vector<int> stack = std::move(roots);
  while (!stack.empty()) {
    const auto node = static_cast<std::size_t>(stack.back());
    if (child[node] != kNone) {
      stack.push_back(child[node]);
      child[node] = sibling[static_cast<std::size_t>(child[node])];
    } else {
      places[node] = place++;
      stack.pop_back();
    }
  }
  return places;
}

/// The number of entries of each column of the factor: column j has one in row i if it lies on a way up the
/// tree from an entry of row i of the matrix to i.
std::vector<int> column_counts(const Pattern& above, const std::vector<int>& parents) {
  const std::size_t size = parents.size();
  std::vector<int> counts(size, 1), seen(size, kNone);
  Checkpoint checkpoint;
  for (std::size_t row = 0; row < size; ++row) {
    seen[row] = static_cast<int>(row);
    checkpoint.pass();
    for (const int column : above[row])
      for (auto at = static_cast<std::size_t>(column); seen[at] != static_cast<int>(row);
           at = static_cast<std::size_t>(parents[at])) {
        ++counts[at];
        seen[at] = static_cast<int>(row);
      }
  }
  return counts;
}

/// Columns that may share their rows.
struct Range {
  int begin = 0, columns = 0;
  std::int64_t rows = 0;     ///< with those of the columns
  std::int64_t entries = 0;  ///< that are not zero

  std::int64_t room() const { return rows * columns - std::int64_t{columns} * (columns - 1) / 2; }
};

bool should_merge(const Range& merged, const SupernodeOptions& options) {
  for (const auto& [columns, zeros] : options.merging)
    if (merged.columns <= columns)
      return static_cast<double>(merged.room() - merged.entries) <=
             zeros * static_cast<double>(merged.room());
  return false;
}

/// Ranges of columns that become supernodes: columns with the same rows, and children merged into parents
/// right behind them where that stores few zeros.
std::vector<Range> ranges_of(const std::vector<int>& parents, const std::vector<int>& counts,
                             const SupernodeOptions& options) {
  std::vector<Range> ranges;
  const int size = static_cast<int>(parents.size());
  for (int begin = 0, end = 0; begin < size; begin = end) {
    Range range{begin, 0, counts[static_cast<std::size_t>(begin)], 0};
    do {
      range.entries += counts[static_cast<std::size_t>(end++)];
    } while (end < size && parents[static_cast<std::size_t>(end) - 1] == end &&
             counts[static_cast<std::size_t>(end)] == counts[static_cast<std::size_t>(end) - 1] - 1);
    range.columns = end - begin;
    while (!ranges.empty()) {
      const Range& before = ranges.back();
      const int parent = parents[static_cast<std::size_t>(range.begin) - 1];
      const Range merged{before.begin, before.columns + range.columns, before.columns + range.rows,
                         before.entries + range.entries};
      if (parent == kNone || parent >= end || !should_merge(merged, options)) break;
      range = merged;
      ranges.pop_back();
    }
    ranges.push_back(range);
  }
  return ranges;
}

/// The rows below each range: those of the matrix and of ranges whose first row below is in this one.
Pattern rows_below(const Pattern& of_matrix, const std::vector<Range>& ranges) {
  const std::size_t size = of_matrix.size();
  std::vector<std::size_t> range_of(size);
  for (std::size_t k = 0; k < ranges.size(); ++k)
    std::fill_n(range_of.begin() + ranges[k].begin, ranges[k].columns, k);
  Pattern below(ranges.size());
  std::vector<std::vector<std::size_t>> children(ranges.size());
  std::vector<std::size_t> seen(size, ranges.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const int end = ranges[k].begin + ranges[k].columns;
    const auto add = [&](const std::vector<int>& rows) {
      for (const int row : rows)
        if (row >= end && std::exchange(seen[static_cast<std::size_t>(row)], k) != k) below[k].push_back(row);
    };
    for (int column = ranges[k].begin; column < end; ++column)
      add(of_matrix[static_cast<std::size_t>(column)]);
    for (const std::size_t child : children[k]) add(below[child]);
    std::sort(below[k].begin(), below[k].end());
    if (!below[k].empty()) children[range_of[static_cast<std::size_t>(below[k].front())]].push_back(k);
  }
  return below;
}

}  // namespace

Supernodes::Supernodes(const Sparse& matrix, std::vector<int> places, const SupernodeOptions& options)
    : places_(std::move(places)) {
  const auto rows_above = [&] { return pattern_of(matrix, places_, std::less<>()); };
  const std::vector<int> order = postorder(elimination_tree(rows_above()));
  for (int& place : places_) place = order[static_cast<std::size_t>(place)];
  const Pattern above = rows_above();
  const std::vector<int> parents = elimination_tree(above);
  const std::vector<Range> ranges = ranges_of(parents, column_counts(above, parents), options);
  const Pattern below = rows_below(pattern_of(matrix, places_, std::greater<>()), ranges);

  below_begins_.push_back(0);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const int end = ranges[k].begin + ranges[k].columns;
    for (int begin = ranges[k].begin; begin < end; begin += options.most_columns) {
      begins_.push_back(begin);
      for (int row = begin + options.most_columns; row < end; ++row) below_.push_back(row);
      below_.insert(below_.end(), below[k].begin(), below[k].end());
      below_begins_.push_back(below_.size());
    }
  }
  begins_.push_back(static_cast<int>(places_.size()));

  std::vector<std::uint32_t> node_of(places_.size());
  for (std::size_t node = 0; node < size(); ++node)
    std::fill_n(node_of.begin() + begin(node), columns(node), static_cast<std::uint32_t>(node));
  parts_.resize(size());
  for (std::size_t node = 0; node < size(); ++node) {
    const std::span<const int> rows = this->below(node);
    parents_.push_back(rows.empty() ? node : node_of[static_cast<std::size_t>(rows.front())]);
    for (std::uint32_t first = 0, end = 0; first < rows.size(); first = end) {
      const std::uint32_t owner = node_of[static_cast<std::size_t>(rows[first])];
      while (end < rows.size() && node_of[static_cast<std::size_t>(rows[end])] == owner) ++end;
      parts_[owner].push_back({static_cast<std::uint32_t>(node), first, end});
    }
  }
}

}  // namespace crossgrain
