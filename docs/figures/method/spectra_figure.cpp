// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "chart.hpp"
#include "method_figures.hpp"
#include "picture/font.hpp"
#include "shape_spectra.hpp"
#include "solids.hpp"

namespace crossgrain::figures {
namespace {

constexpr double kLeft = 14, kColumn = 272, kTop = 56, kPicture = 200, kBars = 190;
constexpr ViewDirection kView{-58, 24};
constexpr Colour kKnown = colour_of(0x2f6fb0), kOpen = colour_of(0xf0a63a);

/// Eigenvalues that exceed the smallest by no more belong to its eigenspace.
bool is_open(const Coefficients<3>& eigenvalues, std::size_t i) {
  return eigenvalues[i] <= eigenvalues[0] + ClassificationTolerances().same_eigenvalue;
}

void add_face(Drawing& drawing, const Vector3& centre, const Vector3& normal, const Vector3& along,
              double side) {
  drawing.meshes.push_back(plate(centre, normal, along, side));
  add_arrow(drawing, centre, normal, 0.5);
}

Drawing flat() {
  Drawing drawing;
  add_face(drawing, {0, 0, -0.1}, {0, 0, 1}, {1, 0, 0}, 1.3);
  return drawing;
}

/// Three faces of a cube that the viewer sees.
Drawing corner() {
  Drawing drawing;
  for (const Vector3& normal : {Vector3{1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1}})
    add_face(drawing, 0.45 * normal, normal, {normal[2], normal[0], normal[1]}, 0.9);
  return drawing;
}

/// Two faces on both sides of an upright edge, which is nearest to the viewer.
Drawing crease(double angle_deg) {
  constexpr double kSide = 0.95;
  const double middle = kView.azimuth_deg * std::numbers::pi / 180, half = angle_deg * std::numbers::pi / 360;
  const Vector3 edge{0.3 * std::cos(middle), 0.3 * std::sin(middle), 0};
  Drawing drawing;
  for (const double side : {-1.0, 1.0}) {
    const double azimuth = middle + side * half;
    const Vector3 normal{std::cos(azimuth), std::sin(azimuth), 0};
    const Vector3 away = side * cross({0, 0, 1}, normal);
    add_face(drawing, edge + 0.5 * kSide * away, normal, {0, 0, 1}, kSide);
  }
  return drawing;
}

Drawing round(const DrawnMesh& mesh, const std::vector<Vector3>& normals, double radius) {
  Drawing drawing;
  drawing.meshes.push_back(mesh);
  for (const Vector3& normal : normals) add_arrow(drawing, radius * normal, normal, 0.45);
  return drawing;
}

void draw_bars(Figure& figure, const ShapeSpectrum& shape, const PixelBox& box) {
  constexpr double kPitch = 34, kBar = 24;
  Canvas& canvas = figure.canvas();
  const double left = 0.5 * (box.left + box.right) - 3.5 * kPitch;
  for (std::size_t i = 0; i < 7; ++i) {
    const double value = shape.eigenvalues[i], x = left + kPitch * (static_cast<double>(i) + 0.5);
    const double height = std::max(value * box.height(), 3.0);
    const Colour colour = is_open(shape.eigenvalues, i) ? kOpen : kKnown;
    canvas.fill({x - kBar / 2, box.bottom - height, x + kBar / 2, box.bottom}, colour);
    const std::string text = value < 1e-9       ? "0"
                             : value > 1 - 1e-9 ? "1"
                                                : fmt::format("{:.2f}", value).substr(1);
    figure.text(text, x, box.bottom - height - 8, 17, Align::kCentre, kFaint);
  }
  canvas.line(left, box.bottom, left + 7 * kPitch, box.bottom, 2, kInk);
}

struct Shape {
  std::string title;
  ShapeSpectrum spectrum;
  Drawing drawing;
  std::string says;
};

std::vector<Shape> shapes() {
  const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  return {{"plane", plane_spectrum(), flat(), "one axis known"},
          {"normals at 90°", crease_spectrum(90), crease(90), "all three known"},
          {"corner of a cube", corner_spectrum(), corner(), "all three known"},
          {"thin cylinder", cylinder_spectrum(), round(cylinder(0.36, 1.3), {x, -y, -x, y}, 0.36),
           "one known, along it"},
          {"normals at 60°", crease_spectrum(60), crease(60), "known, but fits badly"},
          {"small sphere", sphere_spectrum(), round(ball(0.55), {x, -y, -x, y, z}, 0.55), "nothing known"}};
}

void draw_shapes(Figure& figure) {
  int column = 0;
  for (const Shape& shape : shapes()) {
    const double left = kLeft + kColumn * column++, middle = left + kColumn / 2;
    figure.text(shape.title, middle, 36, 25);
    figure.draw(shape.drawing, kView, ball_of_sight(0.98),
                {left + 20, kTop - 10, left + kColumn - 20, kTop - 10 + kPicture});
    const double top = kTop + kPicture + 34;
    draw_bars(figure, shape.spectrum, {left, top, left + kColumn, top + kBars});
    figure.text(name_of(shape.spectrum.constraint_class), middle, top + kBars + 38, 25);
    figure.text(shape.says, middle, top + kBars + 70, 21, Align::kCentre, kFaint);
  }
}

/// The class by the angle, as a band. What is too narrow for its name has it below.
void draw_classes(Figure& figure, const Chart& chart, double top, double bottom) {
  constexpr double kStep = 0.125, kText = 21;
  double begin = 0;
  ConstraintClass current = crease_spectrum(0).constraint_class;
  for (double angle = kStep; angle <= 90 + kStep; angle += kStep) {
    const bool is_end = angle > 90;
    const ConstraintClass next = is_end ? current : crease_spectrum(angle).constraint_class;
    if (next == current && !is_end) continue;
    const double from = chart.pixel_x(begin), to = chart.pixel_x(std::min(angle, 90.0));
    const double middle = 0.5 * (from + to);
    const bool fits = Font::sans().width(name_of(current), kText) < to - from - 6;
    figure.canvas().fill({from + 1, top, to - 1, bottom}, colour_of(fits ? 0xe6ebf0 : 0xc3ccd6));
    figure.text(name_of(current), middle, fits ? 0.5 * (top + bottom) + 8 : bottom + 27, kText);
    begin = angle;
    current = next;
  }
}

void draw_creases(Figure& figure) {
  const PixelBox box{96, kTop + kPicture + kBars + 190, figure.width() - 40, figure.height() - 176};
  Chart chart(figure, box, {0, 90, 15, "°"}, {0, 1, 0.25});
  chart.draw_grid();
  for (std::size_t i = 7; i-- > 0;) {
    for (int half = 0; half < 180; ++half) {
      const double from = 0.5 * half, to = from + 0.5;
      const Coefficients<3> a = crease_spectrum(from).eigenvalues, b = crease_spectrum(to).eigenvalues;
      chart.curve({{from, a[i]}, {to, b[i]}}, 4, is_open(b, i) ? kOpen : kKnown);
    }
  }
  figure.text("crease: the seven eigenvalues by the angle between its normals", box.left, box.top - 22, 25,
              Align::kLeft);
  draw_classes(figure, chart, box.bottom + 46, box.bottom + 84);
  const double y = figure.height() - 22;
  figure.canvas().fill({box.left, y - 17, box.left + 22, y + 3}, kOpen);
  figure.text("the smallest, and what exceeds it by 0.1 at most: what the surface leaves open", box.left + 34,
              y, 21, Align::kLeft);
  figure.canvas().fill({box.left + 920, y - 17, box.left + 942, y + 3}, kKnown);
  figure.text("what it excludes", box.left + 954, y, 21, Align::kLeft);
}

}  // namespace

Figure spectra_figure() {
  Figure figure(static_cast<int>(2 * kLeft + 6 * kColumn), 1130);
  draw_shapes(figure);
  draw_creases(figure);
  return figure;
}

}  // namespace crossgrain::figures
