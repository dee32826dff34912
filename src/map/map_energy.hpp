// SPDX-License-Identifier: Apache-2.0
// How well a map follows the frames of a field.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "reduction/map_unknowns.hpp"

namespace crossgrain {

/// Coordinates of a map at the copies of vertices (CutSolid), three for each, in sizes of hexahedra.
using MapCoordinates = Eigen::VectorXd;

/// The energy sum over tets of V |grad u - F / h|^2, with volumes V, the axes F of frames as rows and the
/// size h of hexahedra: a quadratic function x^T K x - 2 b^T x + c of the columns x (MapUnknowns). `unknowns`
/// must outlive it.
class MapEnergy {
 public:
  /// `size` is in model units and positive.
  MapEnergy(const MapUnknowns& unknowns, double size);

  const MapUnknowns& unknowns() const { return *unknowns_; }
  double size() const { return size_; }

  /// Coordinates = basis * columns.
  const Eigen::SparseMatrix<double>& basis() const { return basis_; }
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }  ///< K
  const Eigen::VectorXd& right() const { return right_; }                ///< b

  /// Gradients of the four linear functions that are 1 at one corner of a tet, as columns; model units.
  const Eigen::Matrix<double, 3, 4>& gradients(std::size_t tet) const { return gradients_[tet]; }
  double volume(std::size_t tet) const { return volumes_[tet]; }

  /// The rows are the gradients of the three coordinates, in the names of the cut, times the size of
  /// hexahedra: a rotation where the map follows the frames.
  Eigen::Matrix3d jacobian(const MapCoordinates& map, std::size_t tet) const;

 private:
  void find_gradients();
  void assemble();

  const MapUnknowns* unknowns_;
  double size_;
  std::vector<Eigen::Matrix<double, 3, 4>> gradients_;
  std::vector<double> volumes_;
  Eigen::SparseMatrix<double> basis_, matrix_;
  Eigen::VectorXd right_;
};

/// Tets that a map turns inside out or flattens.
struct MapFlips {
  std::size_t tets = 0;
  double share_of_volume = 0;
  double least_determinant = 0;  ///< of the Jacobians; 1 where the map follows the frames
};

/// The determinants of the Jacobians of all tets.
std::vector<double> determinants_of(const MapEnergy& energy, const MapCoordinates& map);

/// Counts tets with determinants of at most 1e-9.
MapFlips flips_of(const MapEnergy& energy, const MapCoordinates& map);

}  // namespace crossgrain
