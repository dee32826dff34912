// SPDX-License-Identifier: Apache-2.0
// Lighting: soft from above, a key light from the upper left of the viewer and a weak one from the right.
// Uses only square roots and products, so that colours are the same on every machine.
#pragma once

#include <algorithm>
#include <array>

#include "picture/colour.hpp"

namespace crossgrain {

/// A unit vector in the axes of the picture: right, up, towards the viewer.
using SeenNormal = std::array<float, 3>;

namespace light {
inline constexpr SeenNormal kKey{-0.451f, 0.621f, 0.641f}, kFill{0.754f, 0.101f, 0.649f};
inline constexpr float kAmbient = 0.46f, kSky = 0.10f, kKeyShare = 0.44f, kFillShare = 0.12f;
}  // namespace light

inline float seen_dot(const SeenNormal& a, const SeenNormal& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Brightness of a matt surface, about 0.5 to 1.
inline float brightness(const SeenNormal& normal) {
  return light::kAmbient + light::kSky * normal[1] +
         light::kKeyShare * std::max(seen_dot(normal, light::kKey), 0.0f) +
         light::kFillShare * std::max(seen_dot(normal, light::kFill), 0.0f);
}

/// Highlight of a glossy surface, 0 to 1: the reflection of the key light.
inline float highlight(const SeenNormal& normal) {
  // The direction half-way between the key light and the viewer.
  constexpr SeenNormal kHalfWay{-0.249f, 0.343f, 0.906f};
  const float along = std::max(seen_dot(normal, kHalfWay), 0.0f);
  const float squared = along * along, fourth = squared * squared, eighth = fourth * fourth;
  return eighth * eighth * eighth;
}

/// Colour of a facet of a small solid: contrasts between facets, without the rim that would hide small ones.
inline Colour facet_shade(const Colour& colour, const SeenNormal& normal) {
  return mix((0.05f + 0.95f * brightness(normal)) * colour, {1, 1, 1}, 0.25f * highlight(normal));
}

/// Colour of a round shape: glossy, with a dark rim that sets it off from the background.
inline Colour solid_shade(const Colour& colour, const SeenNormal& normal) {
  const float rim = std::clamp((normal[2] - 0.10f) / 0.35f, 0.0f, 1.0f);
  const float shade = (0.12f + 0.88f * brightness(normal)) * (0.42f + 0.58f * rim);
  return mix(shade * colour, {1, 1, 1}, 0.45f * highlight(normal));
}

}  // namespace crossgrain
