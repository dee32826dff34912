// SPDX-License-Identifier: Apache-2.0
// Colours of pictures, in sRGB from 0 to 1. They are mixed without linearisation: thin dark lines on white
// keep their weight, and no powers are needed, which differ in the last digit between machines.
#pragma once

#include <cstdint>

namespace crossgrain {

struct Colour {
  float r = 0, g = 0, b = 0;

  bool operator==(const Colour&) const = default;
};

/// Colour from 0xRRGGBB.
constexpr Colour colour_of(std::uint32_t hex) {
  return {static_cast<float>(hex >> 16 & 255) / 255, static_cast<float>(hex >> 8 & 255) / 255,
          static_cast<float>(hex & 255) / 255};
}

constexpr Colour operator*(float s, const Colour& c) {
  return {s * c.r, s * c.g, s * c.b};
}
constexpr Colour operator+(const Colour& a, const Colour& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}

/// Mixture of two colours: a for t = 0, b for t = 1.
constexpr Colour mix(const Colour& a, const Colour& b, float t) {
  return (1 - t) * a + t * b;
}

/// A colour and its share of a pixel. The colour is premultiplied by `opacity`.
struct Pixel {
  Colour colour;
  float opacity = 0;
};

/// The composite of `front` over `behind`.
constexpr Pixel over(const Pixel& front, const Pixel& behind) {
  const float left = 1 - front.opacity;
  return {front.colour + left * behind.colour, front.opacity + left * behind.opacity};
}

constexpr Pixel pixel_of(const Colour& colour, float opacity = 1) {
  return {opacity * colour, opacity};
}

}  // namespace crossgrain
