// SPDX-License-Identifier: Apache-2.0
#include "field/adjacency.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Number of words that may be read beyond the last weight of a group: eight floats.
constexpr std::size_t kReadBeyond = 16;

/// Numbers cells in the order of their first occurrence.
class FirstMet {
 public:
  explicit FirstMet(std::vector<std::uint32_t>& cells) : cells_(cells), slots_(kFirstSlots, kEmpty) {}

  /// Returns the place of `cell`, which is appended to the cells if it is new. Places are below 2^16, enough
  /// for a group of 1024 rows of fewer than 64 neighbours. Throws Error(kLimit) beyond.
  std::uint16_t place_of(std::uint32_t cell) {
    std::size_t slot = slot_of(cell);
    if (slots_[slot] == kEmpty) {
      if (cells_.size() > std::numeric_limits<std::uint16_t>::max())
        throw Error(ErrorKind::kLimit, "cells have too many neighbours to be stored");
      slots_[slot] = static_cast<std::uint32_t>(cells_.size());
      cells_.push_back(cell);
      if (2 * cells_.size() > slots_.size()) grow();
      return static_cast<std::uint16_t>(cells_.size() - 1);
    }
    return static_cast<std::uint16_t>(slots_[slot]);
  }

 private:
  static constexpr std::size_t kFirstSlots = 4096;
  static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

  std::size_t slot_of(std::uint32_t cell) const {
    std::size_t slot = cell * std::size_t{0x9e3779b1} >> 7 & (slots_.size() - 1);
    while (slots_[slot] != kEmpty && cells_[slots_[slot]] != cell) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (std::size_t place = 0; place < cells_.size(); ++place)
      slots_[slot_of(cells_[place])] = static_cast<std::uint32_t>(place);
  }

  std::vector<std::uint32_t>& cells_;
  std::vector<std::uint32_t> slots_;  ///< places in cells_
};

template <class Neighbours, class WeightOf>
bool have_one_weight(const Neighbours& row, const WeightOf& weight_of) {
  return !row.empty() && std::all_of(row.begin(), row.end(), [&](const auto& neighbour) {
    return weight_of(neighbour) == weight_of(row[0]);
  });
}

}  // namespace

class RowPacker {
 public:
  explicit RowPacker(Adjacency::Group& group) : group_(group), places_(group.cells) {}

  void add(const std::vector<Adjacency::Neighbour>& row) {
    const bool equal = have_one_weight(row, [](const auto& neighbour) { return neighbour.weight; });
    begin_row(row, equal ? Adjacency::kEqual : 0, 0);
    for (std::size_t k = 0; k < (equal ? 1 : row.size()); ++k) {
      std::array<std::uint16_t, 2> words;
      std::memcpy(words.data(), &row[k].weight, sizeof words);
      group_.words.insert(group_.words.end(), words.begin(), words.end());
    }
  }

  void add(const Adjacency::RowInUnits& row) {
    const bool equal = have_one_weight(row.neighbours, [](const auto& neighbour) { return neighbour.units; });
    begin_row(row.neighbours, Adjacency::kInUnits | (equal ? Adjacency::kEqual : 0), row.unit);
    for (std::size_t k = 0; k < (equal ? 1 : row.neighbours.size()); ++k)
      group_.words.push_back(row.neighbours[k].units);
  }

 private:
  template <class Neighbours>
  void begin_row(const Neighbours& row, unsigned kind, std::uint16_t unit) {
    if (row.size() > Adjacency::kLargestSize)
      throw Error(ErrorKind::kLimit, "a cell has more than 16383 neighbours");
    group_.words.push_back(static_cast<std::uint16_t>(row.size() | kind));
    group_.words.push_back(unit);
    for (const auto& neighbour : row) group_.words.push_back(places_.place_of(neighbour.cell));
  }

  Adjacency::Group& group_;
  FirstMet places_;
};

template <class Visit>
void Adjacency::pack_groups(std::size_t cell_count, const Visit& pack_row) {
  begin_ = sized_vector<std::uint32_t>(cell_count);
  groups_.resize((cell_count + kGroupSize - 1) / kGroupSize);
  parallel_for_chunks(cell_count, kGroupSize, [&](std::size_t begin, std::size_t end) {
    // Copied into vectors of the final size, without spare capacity.
    Group packed;
    packed.words.reserve(64 * kGroupSize);
    packed.cells.reserve(4 * kGroupSize);
    RowPacker packer(packed);
    for (std::size_t i = begin; i < end; ++i) {
      begin_[i] = static_cast<std::uint32_t>(packed.words.size());
      pack_row(i, packer);
    }
    packed.words.resize(packed.words.size() + kReadBeyond);
    Group& kept = groups_[begin / kGroupSize];
    kept.words.assign(packed.words.begin(), packed.words.end());
    kept.cells.assign(packed.cells.begin(), packed.cells.end());
  });
}

Adjacency::Adjacency(std::size_t cell_count, const RowOf& row_of) {
  pack_groups(cell_count, [&](std::size_t i, RowPacker& packer) {
    thread_local std::vector<Neighbour> row;
    row.clear();
    row_of(i, row);
    packer.add(row);
  });
}

Adjacency::Adjacency(std::size_t cell_count, std::vector<float> units, const RowInUnitsOf& row_of)
    : units_(std::move(units)) {
  pack_groups(cell_count, [&](std::size_t i, RowPacker& packer) {
    thread_local RowInUnits row;
    row.neighbours.clear();
    row_of(i, row);
    packer.add(row);
  });
}

Adjacency::Adjacency(std::size_t cell_count, std::span<const WeightedEdge> edges) {
  if (edges.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw Error(ErrorKind::kLimit, "more than 2 billion pairs of neighbouring cells or edges of tets",
                Remedy::kLowerResolution);
  }
  std::vector<std::uint32_t> begin(cell_count + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++begin[edge.first + 1];
    ++begin[edge.second + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> cursor(begin.begin(), begin.end() - 1);
  std::vector<Neighbour> neighbours(begin.back());
  for (const WeightedEdge& edge : edges) {
    neighbours[cursor[edge.first]++] = {edge.second, edge.weight};
    neighbours[cursor[edge.second]++] = {edge.first, edge.weight};
  }
  *this = Adjacency(cell_count, [&](std::size_t i, std::vector<Neighbour>& row) {
    const auto at = [&](std::size_t k) { return neighbours.begin() + static_cast<std::ptrdiff_t>(k); };
    row.assign(at(begin[i]), at(begin[i + 1]));
  });
}

std::size_t Adjacency::bytes() const {
  std::size_t bytes = begin_.capacity() * sizeof(std::uint32_t) + units_.capacity() * sizeof(float) +
                      groups_.capacity() * sizeof(Group);
  for (const Group& group : groups_) {
    bytes += group.words.capacity() * sizeof(std::uint16_t);
    bytes += group.cells.capacity() * sizeof(std::uint32_t);
  }
  return bytes;
}

}  // namespace crossgrain
