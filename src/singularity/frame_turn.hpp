// SPDX-License-Identifier: Apache-2.0
// The rotation of frames on a path around an edge.
#pragma once

#include <cstdint>
#include <span>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {

/// The rotation of a frame that follows its neighbours once around an edge: one of the rotations of its cube
/// other than the identity. The path is right-handed about the edge's direction.
struct FrameTurn {
  enum class Kind : std::uint8_t {
    kQuarter,  ///< 90 degrees about an axis of the frame
    kHalf,     ///< 180 degrees about an axis of the frame
    kThird,    ///< 120 degrees about a diagonal of its cube
    kSwap,     ///< 180 degrees about the diagonal between two axes, which are exchanged
  };
  Kind kind = Kind::kQuarter;

  /// Unit vector in space, about which frames rotate by a positive angle. The rotation by 180 degrees is the
  /// same in either sense; its sense is that of the steps between the frames on the path.
  Vector3 axis{0, 0, 1};

  bool is_about_an_axis() const { return kind == Kind::kQuarter || kind == Kind::kHalf; }

  /// Whether the rotation is odd (CubeRotation::is_odd).
  bool is_odd() const { return kind == Kind::kQuarter || kind == Kind::kSwap; }
};

/// The rotation of the frames of `way`, from the first through all of them in order and back to the first.
/// `product` is that of the matchings and must not be the identity.
FrameTurn frame_turn(const CubeRotation& product, std::span<const Quaternion> way);

}  // namespace crossgrain
