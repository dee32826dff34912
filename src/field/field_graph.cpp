// SPDX-License-Identifier: Apache-2.0
#include "field/field_graph.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

constexpr const char* kPlanes = "cells with surface of one direction";

void check_count(std::size_t count, std::size_t most, const char* what) {
  if (count > most)
    throw Error(ErrorKind::kLimit,
                fmt::format("more than {} {}; take larger cells, or fewer tets", most, what));
}

}  // namespace

Colouring colouring_of(std::span<const std::uint8_t> colour_of_cell) {
  const std::size_t colour_count =
      colour_of_cell.empty() ? 0 : std::size_t{*std::ranges::max_element(colour_of_cell)} + 1;
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
  std::array<std::uint32_t, 256> taken_by;  // per colour the last cell that has a neighbour of it
  taken_by.fill(~std::uint32_t{0});
  for (std::uint32_t i = 0; i < adjacency.size(); ++i) {
    for (const Adjacency::Neighbour& neighbour : adjacency[i]) {
      if (neighbour.cell < i) taken_by[colours[neighbour.cell]] = i;
    }
    const auto free = std::ranges::find_if(taken_by, [i](std::uint32_t by) { return by != i; });
    if (free == taken_by.end())
      throw Error(ErrorKind::kLimit, "a vertex has too many neighbours: more than 256 colours are needed",
                  Remedy::kSplitTets);
    colours[i] = static_cast<std::uint8_t>(free - taken_by.begin());
  }
  return colouring_of(colours);
}

template <int D>
void CellForms<D>::hold_axis(std::size_t cell, const Vector3& unit_axis) {
  check_count(held_axes_.size() + 1, limits_.held_axes, "vertices of tets that are held along a normal");
  slot_[cell] = kHeld + static_cast<std::uint32_t>(held_axes_.size());
  held_axes_.push_back(unit_axis);
}

template <int D>
void CellForms<D>::set_plane(std::size_t cell, const Vector3& unit_normal, double weight) {
  if (empty(cell)) {
    check_count(planes_.size() + 1, limits_.planes, kPlanes);
    slot_[cell] = static_cast<std::uint32_t>(planes_.size());
    planes_.emplace_back();
  }
  planes_[slot_[cell]] = {{static_cast<float>(unit_normal[0]), static_cast<float>(unit_normal[1]),
                           static_cast<float>(unit_normal[2])},
                          static_cast<float>(weight)};
}

template <int D>
void CellForms<D>::reserve_planes(std::span<const std::uint32_t> cells) {
  check_count(cells.size(), limits_.planes, kPlanes);
  planes_ = sized_vector<PlaneForm>(cells.size());
  parallel_for(cells.size(), [&](std::size_t k) { slot_[cells[k]] = static_cast<std::uint32_t>(k); });
}

template <int D>
void CellForms<D>::reserve_general(std::span<const std::uint32_t> cells) {
  check_count(cells.size(), limits_.generals, "cells or vertices with surface of several directions");
  generals_ = sized_vector<PackedForm<D>>(cells.size());
  parallel_for(cells.size(),
               [&](std::size_t k) { slot_[cells[k]] = kGeneral + static_cast<std::uint32_t>(k); });
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
