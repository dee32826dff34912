// SPDX-License-Identifier: Apache-2.0
#include "field/field_graph.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

namespace {

[[noreturn]] void throw_too_many_edges() {
  throw Error(
      ErrorKind::kLimit,
      "more than 2 billion pairs of neighbouring cells or edges of tets: lower the resolution or take fewer "
      "tets");
}

void check_edge_count(std::size_t ends) {
  if (ends > std::numeric_limits<std::uint32_t>::max()) throw_too_many_edges();
}

bool have_one_weight(const std::vector<Adjacency::Neighbour>& row) {
  return !row.empty() && std::all_of(row.begin(), row.end(), [&](const Adjacency::Neighbour& neighbour) {
    return neighbour.weight == row[0].weight;
  });
}

}  // namespace

Adjacency::Adjacency(std::size_t cell_count, std::span<const WeightedEdge> edges) {
  if (2 * edges.size() >= kEqual) throw_too_many_edges();
  begin_.assign(cell_count + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++begin_[edge.first + 1];
    ++begin_[edge.second + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  weight_begin_.assign(begin_.begin(), begin_.end() - 1);
  cells_.resize(2 * edges.size());
  weights_.resize(2 * edges.size() + kReadBeyond);
  std::vector<std::uint32_t> cursor = weight_begin_;
  const auto put = [&](std::uint32_t from, std::uint32_t to, float weight) {
    const std::uint32_t place = cursor[from]++;
    cells_[place] = to;
    weights_[place] = weight;
  };
  for (const WeightedEdge& edge : edges) {
    put(edge.first, edge.second, edge.weight);
    put(edge.second, edge.first, edge.weight);
  }
}

Adjacency::Adjacency(std::size_t cell_count, const RowOf& row_of) {
  const auto for_each_row = [&](const auto& visit) {
    parallel_for_chunks(cell_count, kParallelGrain, [&](std::size_t begin, std::size_t end) {
      std::vector<Neighbour> row;
      for (std::size_t i = begin; i < end; ++i) {
        row.clear();
        row_of(i, row);
        visit(i, row);
      }
    });
  };
  // Sizes first, each at the place of the next row's begin.
  begin_.assign(cell_count + 1, 0);
  weight_begin_.assign(cell_count + 1, 0);
  for_each_row([&](std::size_t i, const std::vector<Neighbour>& row) {
    begin_[i + 1] = static_cast<std::uint32_t>(row.size());
    weight_begin_[i + 1] = have_one_weight(row) ? 1 : static_cast<std::uint32_t>(row.size());
  });
  const auto total = [](const std::vector<std::uint32_t>& sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  };
  check_edge_count(total(begin_));
  if (total(weight_begin_) >= kEqual) throw_too_many_edges();
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::partial_sum(weight_begin_.begin(), weight_begin_.end(), weight_begin_.begin());
  cells_.resize(begin_.back());
  weights_.resize(weight_begin_.back() + kReadBeyond);
  weight_begin_.pop_back();
  for_each_row([&](std::size_t i, const std::vector<Neighbour>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) cells_[begin_[i] + k] = row[k].cell;
    const bool one_weight = have_one_weight(row);
    for (std::size_t k = 0; k < (one_weight ? 1 : row.size()); ++k)
      weights_[weight_begin_[i] + k] = row[k].weight;
    if (one_weight) weight_begin_[i] |= kEqual;
  });
}

Colouring colouring_of(std::span<const std::uint8_t> colour_of_cell) {
  const std::size_t colour_count =
      colour_of_cell.empty()
          ? 0
          : std::size_t{*std::max_element(colour_of_cell.begin(), colour_of_cell.end())} + 1;
  Colouring colouring;
  colouring.begin.assign(colour_count + 1, 0);
  for (const std::uint8_t colour : colour_of_cell) ++colouring.begin[colour + 1];
  for (std::size_t c = 0; c < colour_count; ++c) colouring.begin[c + 1] += colouring.begin[c];
  colouring.cells.resize(colour_of_cell.size());
  std::vector<std::size_t> cursor(colouring.begin.begin(), colouring.begin.end() - 1);
  for (std::size_t i = 0; i < colour_of_cell.size(); ++i) {
    colouring.cells[cursor[colour_of_cell[i]]++] = static_cast<std::uint32_t>(i);
  }
  return colouring;
}

Colouring greedy_colouring(const Adjacency& adjacency) {
  std::vector<std::uint8_t> colours(adjacency.size());
  std::array<std::uint32_t, 256> taken_by;  // the last cell for which a colour was seen among the neighbours
  taken_by.fill(~std::uint32_t{0});
  for (std::uint32_t i = 0; i < adjacency.size(); ++i) {
    for (const Adjacency::Neighbour& neighbour : adjacency[i]) {
      if (neighbour.cell < i) taken_by[colours[neighbour.cell]] = i;
    }
    const auto free =
        std::find_if(taken_by.begin(), taken_by.end(), [i](std::uint32_t by) { return by != i; });
    if (free == taken_by.end())
      throw Error(ErrorKind::kLimit,
                  "a vertex has more neighbours than there are colours, 256: split the tets around it");
    colours[i] = static_cast<std::uint8_t>(free - taken_by.begin());
  }
  return colouring_of(colours);
}

template <int D>
void CellForms<D>::hold_axis(std::size_t cell, const Vector3& unit_axis) {
  slot_[cell] = kHeld + static_cast<std::uint32_t>(held_axes_.size());
  held_axes_.push_back(unit_axis);
}

template <int D>
void CellForms<D>::set_plane(std::size_t cell, const Vector3& unit_normal, double weight) {
  slot_[cell] = static_cast<std::uint32_t>(planes_.size());
  planes_.push_back({{static_cast<float>(unit_normal[0]), static_cast<float>(unit_normal[1]),
                      static_cast<float>(unit_normal[2])},
                     static_cast<float>(weight)});
}

template <int D>
void CellForms<D>::reserve_general(std::span<const std::uint32_t> cells) {
  generals_.resize(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) slot_[cells[k]] = kGeneral + static_cast<std::uint32_t>(k);
}

template <int D>
void CellForms<D>::set_general(std::size_t cell, const QuadraticForm<D>& form, double scale) {
  PackedForm<D>& packed = generals_[slot_[cell] - kGeneral];
  auto next = packed.begin();
  for (const double value : form.matrix) *next++ = static_cast<float>(scale * value);
  if constexpr (D == 4) {
    for (const double value : form.linear) *next++ = static_cast<float>(scale * value);
    *next++ = static_cast<float>(scale * form.constant);
  }
}

template class CellForms<3>;
template class CellForms<4>;

}  // namespace crossgrain
