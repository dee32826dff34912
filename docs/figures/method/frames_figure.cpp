// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "harmonic_shape.hpp"
#include "harmonics/frame.hpp"
#include "method_figures.hpp"
#include "picture/cut_frames.hpp"

namespace crossgrain::figures {
namespace {

constexpr double kLeft = 210, kColumn = 258, kTop = 62, kRow = 280, kPanel = 226;
constexpr ViewDirection kView{-66, 24};

struct Turn {
  const char* title;
  Vector3 axis;
  double angle_deg;
};
constexpr std::array<Turn, 5> kTurns{{{"as it stands", {0, 0, 1}, 0},
                                      {"turned by 30°", {0, 0, 1}, 30},
                                      {"by 60°", {0, 0, 1}, 60},
                                      {"by 90°: as before", {0, 0, 1}, 90},
                                      {"about a skew axis", {0.8, 0.36, 0.48}, 40}}};

Quaternion rotation_of(const Turn& turn) {
  return from_rotation_vector((turn.angle_deg * std::numbers::pi / 180) * turn.axis);
}

/// A cube of glass with the three axes in it, which have neither names nor ends.
Drawing frame_drawing(const Quaternion& frame) {
  constexpr double kSide = 0.66, kReach = 0.6, kAxis = 0.032, kEdge = 0.008;
  const std::vector<PlacedFrame> placed{{{0, 0, 0}, frame}};
  Drawing drawing;
  drawing.meshes.push_back(frame_boxes(placed, kSide, colour_of(0xb4c0cc)));
  drawing.meshes.back().opacity = drawing.meshes.back().grazing_opacity = 0.42f;
  DrawnRods cross, edges{RodLook::kInk, {}, {}};
  const auto axes = axes_of(frame);
  for (const Vector3& axis : axes)
    cross.rods.push_back({-kReach * axis, kReach * axis, kAxis, colour_of(0x3d8f5f)});
  for (std::size_t along = 0; along < 3; ++along) {
    for (const double side : {-1.0, 1.0}) {
      for (const double other : {-1.0, 1.0}) {
        const Vector3 middle = 0.5 * kSide * (side * axes[(along + 1) % 3] + other * axes[(along + 2) % 3]);
        const Vector3 half = 0.5 * kSide * axes[along];
        edges.rods.push_back({middle - half, middle + half, kEdge, kFaint});
      }
    }
  }
  drawing.rods.push_back(cross);
  drawing.rods.push_back(edges);
  return drawing;
}

/// With true minus signs and no negative zero.
std::string number(double value) {
  const double rounded = std::round(value * 1000) / 1000;
  return rounded < 0 ? fmt::format("−{:.3g}", -rounded) : fmt::format("{:.3g}", std::abs(rounded));
}

template <int D>
void draw_harmonic(Figure& figure, const Quaternion& frame, const PixelBox& box, double baseline) {
  const Coefficients<D> h = frame_coefficients<D>(frame);
  Drawing drawing;
  drawing.meshes.push_back(harmonic_shape<D>(h));
  figure.draw(drawing, kView, ball_of_sight(0.68), box);
  figure.text(fmt::format("h · h₀ = {}", number(dot(h, reference_frame<D>()))), 0.5 * (box.left + box.right),
              baseline, 24);
}

}  // namespace

Figure frames_figure() {
  Figure figure(static_cast<int>(kLeft + 5 * kColumn + 10), static_cast<int>(kTop + 3 * kRow - 20));
  for (std::size_t i = 0; i < kTurns.size(); ++i) {
    const double left = kLeft + kColumn * static_cast<double>(i) + (kColumn - kPanel) / 2;
    const Quaternion frame = rotation_of(kTurns[i]);
    figure.text(kTurns[i].title, left + kPanel / 2, 40, 25);
    const auto box = [&](int row) {
      const double top = kTop + kRow * row - (row == 0 ? 0 : 24);
      return PixelBox{left, top, left + kPanel, top + kPanel};
    };
    figure.draw(frame_drawing(frame), kView, ball_of_sight(0.66), box(0));
    draw_harmonic<4>(figure, frame, box(1), box(1).bottom + 28);
    draw_harmonic<3>(figure, frame, box(2), box(2).bottom + 28);
  }
  const std::array<std::array<const char*, 3>, 3> labels{{{"frame", "three axes without", "names or signs"},
                                                          {"degree 4", "√(7/12) e₀", "+ √(5/12) e₄"},
                                                          {"degree 3", "e₋₂, which", "is xyz"}}};
  for (std::size_t row = 0; row < labels.size(); ++row) {
    const double y = kTop + kRow * static_cast<double>(row) + 110 - (row == 0 ? 0 : 24);
    figure.text(labels[row][0], 22, y, 27, Align::kLeft);
    figure.text(labels[row][1], 22, y + 36, 21, Align::kLeft, kFaint);
    figure.text(labels[row][2], 22, y + 64, 21, Align::kLeft, kFaint);
  }
  return figure;
}

}  // namespace crossgrain::figures
