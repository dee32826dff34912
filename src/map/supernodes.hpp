// SPDX-License-Identifier: Apache-2.0
// Which entries the Cholesky factor of a sparse matrix has, in blocks of columns.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace crossgrain {

struct SupernodeOptions {
  int most_columns = 256;  ///< of a supernode, at least 1; wider ones are divided

  /// Supernodes of at most so many columns together are merged if at most this share of their entries is
  /// zero.
  struct Merging {
    int columns = 0;
    double zeros = 0;
  };

  /// By ascending numbers of columns: the first that fits counts. None: nothing is merged. These are the
  /// limits of CHOLMOD (Chen, Davis, Hager, Rajamanickam, ACM TOMS 35, 2008).
  std::vector<Merging> merging{{4, 1}, {16, 0.8}, {48, 0.1}, {std::numeric_limits<int>::max(), 0.05}};
};

/// The entries of the factor L of a symmetric matrix, rows and columns in an order of elimination: supernodes
/// are ranges of columns with one set of rows below them (Davis, "Direct Methods for Sparse Linear Systems",
/// 2006, chapter 4). Supernodes form a forest: the parent of a supernode is the one that has its first row
/// below among its columns, and comes after it. All rows below a supernode are columns of its ancestors.
class Supernodes {
 public:
  /// `places` is a permutation: the place of each row in an order without much fill. Rows get other places of
  /// the same fill, in which each branch of the forest keeps together. The pattern of `matrix` is symmetric,
  /// with the entries of both triangles; entries of value zero count.
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

  /// The parent of a supernode; a root is its own parent.
  std::size_t parent(std::size_t node) const { return parents_[node]; }

  /// Rows [begin, end) of below(node) are columns of another supernode.
  struct Part {
    std::uint32_t node = 0, begin = 0, end = 0;
  };

  /// For each lower supernode with rows among the columns of this one, ascending: which of its rows they are.
  const std::vector<Part>& parts(std::size_t node) const { return parts_[node]; }

 private:
  std::vector<int> places_, begins_, below_;
  std::vector<std::size_t> below_begins_, parents_;
  std::vector<std::vector<Part>> parts_;
};

}  // namespace crossgrain
