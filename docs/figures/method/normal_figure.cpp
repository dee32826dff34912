// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "chart.hpp"
#include "constraint/normal_form.hpp"
#include "harmonic_shape.hpp"
#include "harmonics/frame.hpp"
#include "method_figures.hpp"
#include "solids.hpp"

namespace crossgrain::figures {
namespace {

constexpr double kLeft = 14, kColumn = 238, kTop = 62, kPanel = 238;
constexpr ViewDirection kView{-66, 20};
constexpr Vector3 kUp{0, 0, 1}, kAcross{0, 1, 0};
const Vector3 kDiagonal{std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2, 0};

Quaternion turned(const Vector3& axis, double angle_deg) {
  return from_rotation_vector((angle_deg * std::numbers::pi / 180) * axis);
}

double energy4(const Quaternion& frame) {
  return normal_value(normal_basis<4>(kUp), frame_coefficients<4>(frame));
}

/// Times 5/3, as the solver takes it, so that small angles cost as much as in degree 4.
double energy3(const Quaternion& frame) {
  return 5.0 / 3 * normal_value(normal_basis<3>(kUp), frame_coefficients<3>(frame));
}

void draw_panel(Figure& figure, int column, const Coefficients<4>& h, const std::string& caption) {
  Drawing drawing;
  drawing.meshes.push_back(harmonic_shape<4>(h));
  drawing.meshes.push_back(plate({0, 0, -0.72}, kUp, kAcross, 1.35));
  add_arrow(drawing, {0, 0, -0.72}, kUp, 1.72);
  const double left = kLeft + kColumn * column;
  figure.draw(drawing, kView, ball_of_sight(1.03), {left, kTop, left + kPanel, kTop + kPanel});
  figure.text(caption, left + kPanel / 2, kTop + kPanel + 16, 20);
  if (column == 0) figure.text("n", left + kPanel / 2 + 18, kTop + 22, 24, Align::kLeft, kNormal);
  const double energy = normal_value(normal_basis<4>(kUp), h);
  figure.text(fmt::format("E = {:.3g}", std::abs(energy) < 1e-12 ? 0.0 : energy), left + kPanel / 2,
              kTop + kPanel + 50, 24, Align::kCentre, energy < 1e-12 ? kFaint : colour_of(0xb3263d));
}

void draw_panels(Figure& figure) {
  for (int i = 0; i < 3; ++i) {
    const int angle_deg = 20 * i;
    draw_panel(figure, i, frame_coefficients<4>(turned(kUp, angle_deg)),
               i == 0 ? "one of them" : fmt::format("turned {}° about n", angle_deg));
  }
  draw_panel(figure, 3, normal_basis<4>(kUp).zonal, "their mean: no frame");
  for (int i = 1; i <= 3; ++i)
    draw_panel(figure, 3 + i, frame_coefficients<4>(turned(kAcross, 15 * i)),
               fmt::format("tilted by {}°", 15 * i));
  const double split = kLeft + 4 * kColumn, right = kLeft + 7 * kColumn;
  figure.text("an axis along the normal n: what the plane allows", 0.5 * (kLeft + split), 38, 25);
  figure.text("no axis along it: what it charges for", 0.5 * (split + right), 38, 25);
  figure.canvas().line(split, 18, split, kTop + kPanel + 54, 1.5, kRule);
}

std::vector<Chart::Point> cost_by_angle(double (*energy)(const Quaternion&), const Vector3& axis) {
  std::vector<Chart::Point> points;
  for (int degrees = 0; degrees <= 90; ++degrees)
    points.push_back({static_cast<double>(degrees), energy(turned(axis, degrees))});
  return points;
}

void draw_costs(Figure& figure) {
  const PixelBox box{96, kTop + kPanel + 142, figure.width() - 440, figure.height() - 84};
  Chart chart(figure, box, {0, 90, 15, "°"}, {0, 2.5, 0.5});
  chart.draw_grid();
  figure.text("what a tilt costs", box.left, box.top - 22, 25, Align::kLeft);
  figure.text("angle between the normal and the axis that stood along it", 0.5 * (box.left + box.right),
              box.bottom + 64, 22, Align::kCentre, kFaint);

  struct Cost {
    double (*energy)(const Quaternion&);
    Vector3 axis;
    Colour colour;
    const char* degree;
    const char* way;
  };
  const std::array<Cost, 4> costs{
      {{energy4, kDiagonal, colour_of(0x6b3fa0), "degree 4, tilted about",
        "a diagonal of a face of its cube"},
       {energy4, kAcross, colour_of(0xb79ad6), "degree 4, tilted about", "another axis of the frame"},
       {energy3, kDiagonal, colour_of(0x11735c), "degree 3 times 5/3,", "about the diagonal"},
       {energy3, kAcross, colour_of(0x6fc4a9), "degree 3 times 5/3,", "about the other axis"}}};
  double y = box.top + 16;
  for (const Cost& cost : costs) {
    chart.curve(cost_by_angle(cost.energy, cost.axis), 4, cost.colour);
    const double left = box.right + 28;
    figure.canvas().line(left, y - 7, left + 34, y - 7, 5, cost.colour);
    figure.text(cost.degree, left + 50, y, 22, Align::kLeft);
    figure.text(cost.way, left + 50, y + 28, 20, Align::kLeft, kFaint);
    y += 78;
  }
}

}  // namespace

Figure normal_figure() {
  Figure figure(static_cast<int>(2 * kLeft + 7 * kColumn), 870);
  draw_panels(figure);
  draw_costs(figure);
  return figure;
}

}  // namespace crossgrain::figures
