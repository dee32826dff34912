// SPDX-License-Identifier: Apache-2.0
// Which entries the Cholesky factor of a sparse matrix has, in blocks of columns.
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

struct SupernodeOptions {
  int most_columns = 256;  ///< of a supernode; wider ones are divided

  /// Supernodes of at most so many columns are merged if at most this share of their entries is zero.
  struct Merging {
    int columns = 0;
    double zeros = 0;
  };
  std::vector<Merging> merging{{4, 1}, {16, 0.8}, {48, 0.1}, {1 << 30, 0.05}};
};

/// The entries of the factor L of a symmetric matrix, rows and columns in an order of elimination: supernodes
/// are ranges of columns with one set of rows below them (Davis, "Direct Methods for Sparse Linear Systems",
/// 2006, chapter 4). Supernodes form a forest: the parent of one is that of its first row below, and comes
/// after it. All rows below a supernode are columns of its ancestors.
class Supernodes {
 public:
  /// `places` has the place of each row in an order without much fill; rows get other places within it.
  /// Takes all entries of both triangles; those of value zero count.
  Supernodes(const Eigen::SparseMatrix<double>& matrix, std::vector<int> places,
             const SupernodeOptions& options = {});

  std::size_t size() const { return begins_.size() - 1; }

  /// The place of each row of the matrix.
  const std::vector<int>& places() const { return places_; }

  int begin(std::size_t node) const { return begins_[node]; }  ///< the first column
  int columns(std::size_t node) const { return begins_[node + 1] - begins_[node]; }

  /// Rows below the columns, ascending.
  std::span<const int> below(std::size_t node) const {
    return std::span(below_).subspan(below_begins_[node], below_begins_[node + 1] - below_begins_[node]);
  }

  /// That of a root is the node itself.
  std::size_t parent(std::size_t node) const { return parents_[node]; }

  /// Rows [begin, end) of below(node) are columns of another supernode.
  struct Part {
    std::uint32_t node = 0, begin = 0, end = 0;
  };

  /// The parts of lower supernodes that are columns of this one, by ascending supernode.
  const std::vector<Part>& parts(std::size_t node) const { return parts_[node]; }

 private:
  std::vector<int> places_, begins_, below_;
  std::vector<std::size_t> below_begins_, parents_;
  std::vector<std::vector<Part>> parts_;
};

}  // namespace crossgrain
