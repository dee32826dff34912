// SPDX-License-Identifier: Apache-2.0
#include "map/map_energy.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

Eigen::Vector3d to_eigen(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

/// The axes of a tet's frame as rows, in the names of the cut.
Eigen::Matrix3d named_axes(const CutSolid& cut, std::uint32_t tet) {
  Eigen::Matrix3d rows;
  for (SignedAxis axis = 0; axis < 3; ++axis) {
    const SignedAxis name = CubeGroup::instance().image(cut.names_of(tet), axis);
    const Eigen::Vector3d direction = to_eigen(axis_in_space(cut.field().frames()[tet], axis));
    rows.row(name % 3) = (name < 3 ? 1.0 : -1.0) * direction.transpose();
  }
  return rows;
}

Eigen::SparseMatrix<double> basis_of(const MapUnknowns& unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto copies = static_cast<std::uint32_t>(unknowns.cut().copies());
  for (std::uint32_t copy = 0; copy < copies; ++copy)
    for (std::uint32_t k = 0; k < 3; ++k)
      for (const auto& [column, factor] : unknowns.point(copy)[k].terms)
        entries.emplace_back(3 * copy + k, column, static_cast<double>(factor));
  Eigen::SparseMatrix<double> basis(3 * copies, static_cast<Eigen::Index>(unknowns.columns()));
  basis.setFromTriplets(entries.begin(), entries.end());
  return basis;
}

}  // namespace

MapEnergy::MapEnergy(const MapUnknowns& unknowns, double size)
    : unknowns_(&unknowns), size_(size), basis_(basis_of(unknowns)) {
  find_gradients();
  assemble();
}

void MapEnergy::find_gradients() {
  const TetMesh& mesh = unknowns_->cut().field().complex().solid().mesh;
  gradients_.resize(mesh.tets.size());
  volumes_.resize(mesh.tets.size());
  parallel_for(mesh.tets.size(), [&](std::size_t t) {
    Eigen::Matrix3d edges;
    for (Eigen::Index k = 0; k < 3; ++k)
      edges.col(k) = to_eigen(mesh.vertices[mesh.tets[t][static_cast<std::size_t>(k + 1)]] -
                              mesh.vertices[mesh.tets[t][0]]);
    volumes_[t] = edges.determinant() / 6;
    gradients_[t].rightCols<3>() = edges.inverse().transpose();
    gradients_[t].col(0) = -gradients_[t].rightCols<3>().rowwise().sum();
  });
}

void MapEnergy::assemble() {
  const CutSolid& cut = unknowns_->cut();
  const auto rows = static_cast<Eigen::Index>(3 * cut.copies());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(48 * gradients_.size());
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(rows);
  for (std::uint32_t t = 0; t < gradients_.size(); ++t) {
    const Eigen::Matrix4d stiffness = volumes_[t] * gradients_[t].transpose() * gradients_[t];
    const Eigen::Matrix<double, 3, 4> target = volumes_[t] / size_ * named_axes(cut, t) * gradients_[t];
    for (std::size_t a = 0; a < 4; ++a) {
      const auto row = static_cast<Eigen::Index>(3 * cut.copy_of(t, a));
      for (Eigen::Index k = 0; k < 3; ++k) {
        pull[row + k] += target(k, static_cast<Eigen::Index>(a));
        for (std::size_t b = 0; b < 4; ++b)
          entries.emplace_back(row + k, static_cast<Eigen::Index>(3 * cut.copy_of(t, b)) + k,
                               stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
      }
    }
  }
  Eigen::SparseMatrix<double> stiffness(rows, rows);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> transposed = basis_.transpose();
  matrix_ = transposed * (stiffness * basis_).eval();
  right_ = transposed * pull;
}

Eigen::Matrix3d MapEnergy::jacobian(const MapCoordinates& map, std::size_t tet) const {
  Eigen::Matrix<double, 3, 4> corners;
  for (std::size_t a = 0; a < 4; ++a)
    corners.col(static_cast<Eigen::Index>(a)) = map.segment<3>(
        static_cast<Eigen::Index>(3 * unknowns_->cut().copy_of(static_cast<std::uint32_t>(tet), a)));
  return size_ * corners * gradients_[tet].transpose();
}

std::vector<double> determinants_of(const MapEnergy& energy, const MapCoordinates& map) {
  std::vector<double> determinants(energy.unknowns().cut().copies_of_tets().size());
  parallel_for(determinants.size(),
               [&](std::size_t t) { determinants[t] = energy.jacobian(map, t).determinant(); });
  return determinants;
}

MapFlips flips_of(const MapEnergy& energy, const MapCoordinates& map) {
  constexpr double kFlat = 1e-9;
  const std::vector<double> determinants = determinants_of(energy, map);
  const std::size_t count = determinants.size();
  MapFlips flips;
  double all = 0;
  for (std::size_t t = 0; t < count; ++t) {
    all += energy.volume(t);
    if (determinants[t] > kFlat) continue;
    ++flips.tets;
    flips.share_of_volume += energy.volume(t);
  }
  flips.share_of_volume /= all;
  flips.least_determinant = *std::min_element(determinants.begin(), determinants.end());
  return flips;
}

}  // namespace crossgrain
