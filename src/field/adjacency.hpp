// SPDX-License-Identifier: Apache-2.0
// Compact lists of neighbours and edge weights.
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <vector>

#include "base/lanes.hpp"

namespace crossgrain {

/// An edge of the graph. It adds (weight / 2) |h_first - h_second|^2 to the smoothness energy.
struct WeightedEdge {
  std::uint32_t first;
  std::uint32_t second;
  float weight;  ///< a length: open face area over distance of the centres
};

/// Rows of neighbours with weights; each edge is in the rows of both its cells.
///
/// Cells are grouped a thousand at a time. A group lists the neighbours of its cells once, and rows refer to
/// that list by 16-bit places. Weights are single-precision numbers or 16-bit multiples of a unit; if all
/// neighbours have the same weight, as inside a solid, it is stored once.
class Adjacency {
 public:
  struct Neighbour {
    std::uint32_t cell;
    float weight;
  };

  /// Neighbours of one cell. Layout of a row: number of neighbours and kind of the weights; number of the
  /// unit; places of the neighbours; weights.
  class Row {
   public:
    class Iterator {
     public:
      Iterator(const Row& row, std::size_t k) : row_(&row), k_(k) {}
      Neighbour operator*() const { return (*row_)[k_]; }
      Iterator& operator++() {
        ++k_;
        return *this;
      }
      bool operator==(const Iterator& other) const { return k_ == other.k_; }

     private:
      const Row* row_;
      std::size_t k_;
    };

    Row(const std::uint16_t* words, const std::uint32_t* cells, const float* units)
        : places_(words + kHeaderWords),
          weights_(places_ + (words[0] & kLargestSize)),
          cells_(cells),
          size_(words[0] & kLargestSize),
          equal_(words[0] & kEqual),
          unit_(words[0] & kInUnits ? units[words[1]] : 0) {}

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    bool has_equal_weights() const { return equal_; }

    std::uint32_t cell(std::size_t k) const { return cells_[places_[k]]; }
    float weight(std::size_t k) const {
      const std::size_t at = equal_ ? 0 : k;
      if (unit_ > 0) return unit_ * static_cast<float>(weights_[at]);
      float weight;
      std::memcpy(&weight, weights_ + 2 * at, sizeof weight);
      return weight;
    }
    Neighbour operator[](std::size_t k) const { return {cell(k), weight(k)}; }
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size_}; }

    /// Returns weights k, k + 1, ..., one per lane; lanes beyond the end of the row are undefined.
    /// Precondition: weights are not equal.
    template <class Real>
    Real weights_from(std::size_t k) const {
      return unit_ > 0 ? unit_ * lanes_of_words<Real>(weights_ + k) : lanes_of_floats<Real>(weights_ + 2 * k);
    }

   private:
    const std::uint16_t* places_;
    const std::uint16_t* weights_;
    const std::uint32_t* cells_;
    std::size_t size_;
    bool equal_;
    float unit_;  ///< 0: weights are floats
  };

  /// Appends the neighbours of a cell to `row`, which is empty when passed.
  using RowOf = std::function<void(std::size_t cell, std::vector<Neighbour>& row)>;

  /// A row whose weights are positive whole multiples of a unit.
  struct RowInUnits {
    struct Neighbour {
      std::uint32_t cell;
      std::uint16_t units;
    };
    std::vector<Neighbour> neighbours;  ///< empty when passed
    std::uint16_t unit = 0;             ///< index into the list of units
  };
  using RowInUnitsOf = std::function<void(std::size_t cell, RowInUnits& row)>;

  Adjacency() = default;

  /// Builds rows from edges; neighbours of a cell have the order of `edges`. Throws Error(kLimit) beyond 2^31
  /// edges or 16383 neighbours of one cell.
  Adjacency(std::size_t cell_count, std::span<const WeightedEdge> edges);

  /// Builds rows from `row_of`, which must give each edge in the rows of both its cells with the same weight.
  /// It is called once per cell, from several threads. Throws Error(kLimit) beyond 16383 neighbours of one
  /// cell.
  Adjacency(std::size_t cell_count, const RowOf& row_of);
  Adjacency(std::size_t cell_count, std::vector<float> units, const RowInUnitsOf& row_of);

  std::size_t size() const { return begin_.size(); }
  Row operator[](std::size_t cell) const {
    const Group& group = groups_[cell / kGroupSize];
    return {group.words.data() + begin_[cell], group.cells.data(), units_.data()};
  }

  /// Memory of the object in bytes.
  std::size_t bytes() const;

 private:
  friend class RowPacker;

  static constexpr std::size_t kGroupSize = 1024;
  static constexpr std::size_t kHeaderWords = 2;
  static constexpr unsigned kLargestSize = (1u << 14) - 1, kEqual = 1u << 14, kInUnits = 1u << 15;

  struct Group {
    std::vector<std::uint16_t> words;  ///< rows, with padding so that weights can be read as vectors
    std::vector<std::uint32_t> cells;  ///< neighbours of the rows' cells
  };

  template <class Visit>
  void pack_groups(std::size_t cell_count, const Visit& pack_row);

  std::vector<Group> groups_;
  std::vector<std::uint32_t> begin_;  ///< begin of each row in its group's words
  std::vector<float> units_;
};

}  // namespace crossgrain
