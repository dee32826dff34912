// SPDX-License-Identifier: Apache-2.0
// An order of the rows of a sparse matrix in which its Cholesky factor has few entries.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace crossgrain {

/// The place of each row of a symmetric matrix, all of whose entries are given, in SCOTCH's order of nested
/// dissection: the factor of large ones has half the entries or fewer of those of a minimum-degree order.
/// (METIS finds as good an order, but takes over the signals and the random numbers of the process.) The same
/// whatever else the process does.
std::vector<int> nested_dissection(const Eigen::SparseMatrix<double>& matrix);

}  // namespace crossgrain
