// SPDX-License-Identifier: Apache-2.0
#include "fit/fitting_energy.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

}  // namespace

std::vector<double> wanted_sizes(const HexMesh& mesh, double size) {
  constexpr double kLeast = 0.25, kMost = 1.3;
  std::vector<double> sizes(mesh.hexahedra.size());
  parallel_for(sizes.size(), [&](std::size_t h) {
    const HexCorners corners = corners_of(mesh, h);
    double volume = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto& [a, b, c] = kHexNeighbours[k];
      volume += dot(cross(corners[a] - corners[k], corners[b] - corners[k]), corners[c] - corners[k]) / 8;
    }
    sizes[h] = std::clamp(std::cbrt(std::max(volume, 0.0)), kLeast * size, kMost * size);
  });
  return sizes;
}

FittingEnergy::FittingEnergy(const HexMesh& mesh, const FittingPulls& pulls, double size,
                             const CornerEnergyOptions& options, std::vector<std::uint8_t> kept)
    : mesh_(mesh),
      pulls_(pulls),
      size_(size),
      options_(options),
      kept_(std::move(kept)),
      sizes_(wanted_sizes(mesh, size)),
      shapes_(mesh.vertices.size(), mesh.hexahedra, sizes_),
      uses_(corner_uses(mesh.vertices.size(), mesh.hexahedra)),
      pulled_by_(mesh.vertices.size(),
                 [&](const auto& add) {
                   for (std::uint32_t q = 0; q < pulls.of_quads.size(); ++q)
                     for (std::uint32_t k = 0; k < 3; ++k) add(pulls.of_quads[q].vertices[k], 3 * q + k);
                 }),
      inverses_(mesh.vertices.size()) {
  invert_blocks();
}

SymmetricMatrix3 FittingEnergy::block_of(std::uint32_t vertex) const {
  SecondOrder sum;
  for (const std::uint32_t use : uses_[vertex]) {
    const HexCorners corners = corners_of(mesh_, use / 8);
    const double scale = 1 / sizes_[use / 8];
    if (kept_[use / 8])
      add_energy_at(corners, use % 8, scale, options_, sum);
    else
      add_stiffness_at(corners, use % 8, scale, options_, sum.hessian);
  }
  for (std::size_t k = 0; k < 6; ++k) sum.hessian[k] += 2 * pulls_.of_vertex[vertex].weight[k];
  for (const std::uint32_t use : pulled_by_[vertex]) {
    const QuadPull& pull = pulls_.of_quads[use / 3];
    const double share = pull.shares[use % 3], factor = 2 * pulls_.quad_weight * pull.weight * share * share;
    std::size_t entry = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        sum.hessian[entry++] += factor * pull.direction[i] * pull.direction[j];
  }
  return sum.hessian;
}

void FittingEnergy::invert_blocks() {
  parallel_for(inverses_.size(), [&](std::size_t v) {
    const auto [xx, xy, xz, yy, yz, zz] = block_of(static_cast<std::uint32_t>(v));
    Eigen::Matrix3d block;
    block << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    block *= size_ * size_;
    inverses_[v] = block.trace() > 0 ? Eigen::Matrix3d(block.inverse()) : Eigen::Matrix3d::Identity();
  });
}

void FittingEnergy::precondition(const Eigen::VectorXd& gradient, Eigen::VectorXd& result) const {
  result.resize(gradient.size());
  parallel_for(inverses_.size(), [&](std::size_t v) {
    const Index first = 3 * static_cast<Index>(v);
    result.segment<3>(first).noalias() = inverses_[v] * gradient.segment<3>(first);
  });
}

std::vector<Vector3> FittingEnergy::places(const Eigen::VectorXd& displacements) const {
  std::vector<Vector3> places;
  find_places(displacements, places);
  return places;
}

void FittingEnergy::find_places(const Eigen::VectorXd& displacements, std::vector<Vector3>& places) const {
  places.resize(mesh_.vertices.size());
  parallel_for(places.size(), [&](std::size_t v) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      places[v][axis] = mesh_.vertices[v][axis] + size_ * displacements[static_cast<Index>(3 * v + axis)];
  });
}

double FittingEnergy::operator()(const Eigen::VectorXd& displacements, Eigen::VectorXd& gradient) {
  find_places(displacements, at_);
  double sum = shapes_(at_, options_, of_shapes_, kept_);
  gradient.setZero(displacements.size());
  if (!std::isfinite(sum) || !are_valid(at_, mesh_.hexahedra, kept_)) return INFINITY;
  differences_.resize(pulls_.of_quads.size());
  parallel_for(differences_.size(),
               [&](std::size_t q) { differences_[q] = pulls_.of_quads[q].difference(at_); });
  parallel_for(at_.size(), [&](std::size_t v) {
    if (pulls_.is_held[v]) return;
    const VertexPull& pull = pulls_.of_vertex[v];
    Vector3 total = of_shapes_[v] + 2 * crossgrain::apply(pull.weight, at_[v] - pull.point);
    for (const std::uint32_t use : pulled_by_[v]) {
      const QuadPull& by = pulls_.of_quads[use / 3];
      total +=
          (2 * pulls_.quad_weight * by.weight * by.shares[use % 3] * differences_[use / 3]) * by.direction;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      gradient[static_cast<Index>(3 * v + axis)] = size_ * total[axis];
  });
  sum += parallel_sum(at_.size(), [&](std::size_t v) {
    const Vector3 off = at_[v] - pulls_.of_vertex[v].point;
    return dot(off, crossgrain::apply(pulls_.of_vertex[v].weight, off));
  });
  for (std::size_t q = 0; q < differences_.size(); ++q)
    sum += pulls_.quad_weight * pulls_.of_quads[q].weight * differences_[q] * differences_[q];
  return sum;
}

}  // namespace crossgrain
