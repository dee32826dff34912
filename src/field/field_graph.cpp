// SPDX-License-Identifier: Apache-2.0
#include "field/field_graph.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

namespace {

void check_edge_count(std::size_t ends) {
  if (ends > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorKind::kLimit,
                "more than 2 billion pairs of neighbouring cells or edges of tets: lower the resolution or "
                "take fewer tets");
}

/// The weights of rows put one after the other, but for rows that have those of one of the last few.
class WeightRows {
 public:
  /// Where the weights of the row begin, counted from the first ones put here. New ones go to `weights`,
  /// unless that is null.
  std::size_t put(const std::vector<Adjacency::Neighbour>& row, float* weights) {
    for (const Stored& stored : last_) {
      if (std::equal(stored.weights.begin(), stored.weights.end(), row.begin(), row.end(),
                     [](float weight, const Adjacency::Neighbour& n) { return weight == n.weight; }))
        return stored.begin;
    }
    Stored& oldest = last_[next_++ % last_.size()];
    oldest.begin = size_;
    oldest.weights.clear();
    for (const Adjacency::Neighbour& neighbour : row) oldest.weights.push_back(neighbour.weight);
    if (weights != nullptr) std::copy(oldest.weights.begin(), oldest.weights.end(), weights + size_);
    size_ += row.size();
    return oldest.begin;
  }

  std::size_t size() const { return size_; }

 private:
  struct Stored {
    std::size_t begin = 0;
    std::vector<float> weights;
  };
  std::array<Stored, 4> last_;
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace

Adjacency::Adjacency(std::size_t cell_count, std::span<const WeightedEdge> edges) {
  check_edge_count(2 * edges.size());
  begin_.assign(cell_count + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++begin_[edge.first + 1];
    ++begin_[edge.second + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  weight_begin_.assign(begin_.begin(), begin_.end() - 1);
  cells_.resize(2 * edges.size());
  weights_.resize(2 * edges.size());
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
  const std::size_t chunks = (cell_count + kParallelGrain - 1) / kParallelGrain;
  std::vector<std::size_t> row_ends(chunks + 1), weight_ends(chunks + 1);
  begin_.assign(cell_count + 1, 0);
  weight_begin_.resize(cell_count);
  const auto visit = [&](const auto& with_row) {
    parallel_for_chunks(cell_count, kParallelGrain, [&](std::size_t begin, std::size_t end) {
      WeightRows rows;
      std::vector<Neighbour> row;
      for (std::size_t i = begin; i < end; ++i) {
        row.clear();
        row_of(i, row);
        with_row(begin / kParallelGrain, i, row, rows);
      }
    });
  };
  visit([&](std::size_t chunk, std::size_t i, const std::vector<Neighbour>& row, WeightRows& rows) {
    rows.put(row, nullptr);
    begin_[i + 1] = static_cast<std::uint32_t>(row.size());
    row_ends[chunk + 1] += row.size();
    weight_ends[chunk + 1] = rows.size();
  });
  std::partial_sum(row_ends.begin(), row_ends.end(), row_ends.begin());
  std::partial_sum(weight_ends.begin(), weight_ends.end(), weight_ends.begin());
  check_edge_count(row_ends.back());
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  cells_.resize(row_ends.back());
  weights_.resize(weight_ends.back());
  visit([&](std::size_t chunk, std::size_t i, const std::vector<Neighbour>& row, WeightRows& rows) {
    for (std::size_t k = 0; k < row.size(); ++k) cells_[begin_[i] + k] = row[k].cell;
    const std::size_t place = rows.put(row, weights_.data() + weight_ends[chunk]);
    weight_begin_[i] = static_cast<std::uint32_t>(weight_ends[chunk] + place);
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
