// SPDX-License-Identifier: Apache-2.0
// A picture of several panels: drawings of shapes, with text and flat lines between.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "picture/camera.hpp"
#include "picture/canvas.hpp"
#include "picture/drawing.hpp"
#include "picture/image.hpp"

namespace crossgrain::figures {

inline constexpr Colour kInk = colour_of(0x1d2630), kFaint = colour_of(0x66727f), kRule = colour_of(0xd3d9df);

/// Where a harmonic is positive and negative; told apart with any colour vision and in grey.
inline constexpr Colour kPositive = colour_of(0xf0a63a), kNegative = colour_of(0x2f6fb0);

/// Where text stands from its x.
enum class Align { kLeft, kCentre, kRight };

class Figure {
 public:
  /// White, in pixels.
  Figure(int width, int height);

  Canvas& canvas() { return canvas_; }
  double width() const { return image_.width(); }
  double height() const { return image_.height(); }

  /// Draws shapes into a box of whole pixels so that `seen` fills it. Returns the camera, whose pixels are
  /// those of the figure.
  Camera draw(const Drawing& drawing, const ViewDirection& view, std::span<const Vector3> seen,
              const PixelBox& box);

  /// `y` is the baseline.
  void text(const std::string& text, double x, double y, double size, Align align = Align::kCentre,
            const Colour& colour = kInk);

  /// A PNG file, complete or not at all. Throws Error(kOutput).
  void write(const std::filesystem::path& path) const;

 private:
  Image image_;
  Canvas canvas_;
};

/// Points of a sphere about the origin: what a camera is to show wherever a shape of that size points.
std::vector<Vector3> ball_of_sight(double radius);

}  // namespace crossgrain::figures
