// SPDX-License-Identifier: Apache-2.0
// The ways that vertices of a patch may go.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/hex_patch.hpp"

namespace crossgrain {

/// Directions of free vertices, each with an unknown: along its way for a vertex on a curve, two for one on a
/// face, three inside. Surfaces are taken as flat.
class PatchSlides {
 public:
  /// `normals`: FittingTargets::normals_of the whole mesh. `blocked` takes freedom from vertices: from all
  /// directions, with which those off their carrier begin, to those along it, with which others begin, to
  /// none.
  PatchSlides(const HexPatch& patch, const FittingTargets& targets, std::span<const Vector3> normals,
              std::span<const std::uint8_t> blocked);

  Eigen::Index size() const { return static_cast<Eigen::Index>(slides_.size()); }

  /// Moves places by the unknowns, in sizes.
  void move(const Eigen::VectorXd& x, std::vector<Vector3>& places) const;

  /// Makes `gradient` that by the unknowns, of one by places.
  void put_gradient(std::span<const Vector3> by_place, Eigen::VectorXd& gradient) const;

  /// Returns kReachWeight times the squared ways of vertices that are not inside, and adds its gradient.
  double add_reach(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;

 private:
  struct Slide {
    std::uint32_t vertex;
    Vector3 direction;
    bool is_inside;
  };
  void add(std::uint32_t vertex, const Vector3& direction, bool is_inside = false) {
    slides_.push_back({vertex, direction, is_inside});
  }

  double size_;
  std::vector<Slide> slides_;
};

}  // namespace crossgrain
