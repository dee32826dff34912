// SPDX-License-Identifier: Apache-2.0
// How frames turn on the way around an edge.
#pragma once

#include <cstdint>
#include <span>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {

/// What a frame that keeps to its neighbours on the way once around an edge has become when it is back: one
/// of the rotations of its cube, but not the identity. The way goes by the right-hand rule about the edge's
/// direction.
struct FrameTurn {
  enum class Kind : std::uint8_t {
    kQuarter,  ///< by 90 degrees about an axis of the frame
    kHalf,     ///< by 180 degrees about an axis of the frame
    kThird,    ///< by 120 degrees about a diagonal of its cube
    kSwap,     ///< by 180 degrees about the diagonal between two axes, which change places
  };
  Kind kind = Kind::kQuarter;

  /// Unit vector in space. Frames turn about it by a positive angle; of half turns, which end alike either
  /// way, by that of the steps between the frames on the way.
  Vector3 axis{0, 0, 1};

  /// Whether the turn is about an axis of the frame.
  bool is_about_an_axis() const { return kind == Kind::kQuarter || kind == Kind::kHalf; }

  /// As CubeRotation::is_odd.
  bool is_odd() const { return kind == Kind::kQuarter || kind == Kind::kSwap; }
};

/// The turn along which the frames of `way` go: from the first over all of them in their order back to the
/// first, with `product` of the matchings not the identity.
FrameTurn frame_turn(const CubeRotation& product, std::span<const Quaternion> way);

}  // namespace crossgrain
