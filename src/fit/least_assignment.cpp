// SPDX-License-Identifier: Apache-2.0
#include "fit/least_assignment.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "base/lists.hpp"
#include "base/parallel.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

/// Prices of rows and columns under which no choice costs less than both together, and those taken just that.
class AugmentingPaths {
 public:
  AugmentingPaths(std::size_t rows, const std::vector<AssignmentChoice>& choices, double without)
      : without_(without), price_of_row_(rows, 0), column_of_(rows, kNowhere) {
    std::size_t columns = 0;
    for (const AssignmentChoice& choice : choices)
      columns = std::max<std::size_t>(columns, choice.column + 1);
    choices_ = Lists<AssignmentChoice>(rows, [&](const auto& add) {
      for (const AssignmentChoice& choice : choices) add(choice.row, choice);
    });
    price_of_column_.assign(columns, 0);
    row_of_.assign(columns, kNowhere);
    reached_from_.assign(columns, kNowhere);
    length_.assign(columns, INFINITY);
    is_settled_.assign(columns, false);
  }

  void add(std::uint32_t row) {
    double to_give_up = INFINITY;  // length to the best row that goes without
    std::uint32_t giving_up = kNowhere, end = kNowhere;
    const auto scan = [&](std::uint32_t from, double before) {
      scanned_.emplace_back(from, before);
      if (const double length = before + without_ - price_of_row_[from]; length < to_give_up)
        to_give_up = length, giving_up = from;
      for (const AssignmentChoice& choice : choices_[from]) {
        const double length = before + choice.cost - price_of_row_[from] - price_of_column_[choice.column];
        // Settled ones too: rounding could make their lengths a little less for ever.
        if (is_settled_[choice.column] || length >= length_[choice.column]) continue;
        if (length_[choice.column] == INFINITY) reached_.push_back(choice.column);
        length_[choice.column] = length;
        reached_from_[choice.column] = from;
        open_.emplace(length, choice.column);
      }
    };
    scan(row, 0);
    double least = 0;
    for (;;) {
      if (open_.empty() || open_.top().first >= to_give_up) {
        least = to_give_up;
        break;
      }
      const auto [length, column] = open_.top();
      open_.pop();
      if (is_settled_[column]) continue;
      is_settled_[column] = true;
      if (row_of_[column] == kNowhere) {
        least = length;
        end = column;
        break;
      }
      scan(row_of_[column], length);
    }
    change_prices(least);
    if (end == kNowhere) {
      end = column_of_[giving_up];
      column_of_[giving_up] = kNowhere;
      if (giving_up == row) end = kNowhere;
      if (end != kNowhere) row_of_[end] = kNowhere;
    }
    while (end != kNowhere) {
      const std::uint32_t from = reached_from_[end];
      row_of_[end] = from;
      std::swap(column_of_[from], end);
      if (from == row) break;
    }
    clear();
  }

  std::vector<std::uint32_t> columns() && { return std::move(column_of_); }

 private:
  void change_prices(double least) {
    for (const auto& [row, before] : scanned_) price_of_row_[row] += least - before;
    for (const std::uint32_t column : reached_)
      if (length_[column] < least && row_of_[column] != kNowhere)
        price_of_column_[column] -= least - length_[column];
  }

  void clear() {
    for (const std::uint32_t column : reached_) {
      length_[column] = INFINITY;
      is_settled_[column] = false;
    }
    reached_.clear();
    scanned_.clear();
    open_ = {};
  }

  using Open = std::pair<double, std::uint32_t>;

  const double without_;
  Lists<AssignmentChoice> choices_;
  std::vector<double> price_of_row_, price_of_column_, length_;
  std::vector<std::uint32_t> column_of_, row_of_, reached_from_, reached_;
  std::vector<bool> is_settled_;  // its length is known
  std::vector<std::pair<std::uint32_t, double>> scanned_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace

std::vector<std::uint32_t> least_assignment(std::size_t rows, const std::vector<AssignmentChoice>& choices,
                                            double without) {
  AugmentingPaths paths(rows, choices, without);
  for (std::uint32_t row = 0; row < rows; ++row) {
    check_watched();
    paths.add(row);
  }
  return std::move(paths).columns();
}

}  // namespace crossgrain
