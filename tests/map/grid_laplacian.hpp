// SPDX-License-Identifier: Apache-2.0
// Matrices like those of meshes, for tests of factors.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace crossgrain {

/// Of several cubes of n^3 points that nothing joins, with a row for each point: `diagonal` there, -1 for
/// each neighbour.
inline Eigen::SparseMatrix<double> laplacian_of_cubes(int cubes, int n, double diagonal = 7) {
  std::vector<Eigen::Triplet<double>> entries;
  const int count = n * n * n;
  for (int cube = 0; cube < cubes; ++cube) {
    for (int point = 0; point < count; ++point) {
      const int row = cube * count + point;
      entries.emplace_back(row, row, diagonal);
      for (const int step : {1, n, n * n}) {
        if (point / step % n == n - 1) continue;
        entries.emplace_back(row, row + step, -1);
        entries.emplace_back(row + step, row, -1);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(cubes * count, cubes * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace crossgrain
