// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "harmonic_shape.hpp"
#include "method_figures.hpp"
#include "picture/axis_cross.hpp"

namespace crossgrain::figures {
namespace {

constexpr double kColumn = 184, kRow = 250, kLeft = 140, kTop = 74;
constexpr ViewDirection kView{-62, 24};

/// On the unit sphere and up to a factor, in the order of their coefficients (harmonics/evaluation.hpp).
constexpr std::array<const char*, 9> kPolynomials4{"xy(x²−y²)",      "yz(3x²−y²)",  "xy(7z²−1)",
                                                   "yz(7z²−3)",      "35z⁴−30z²+3", "xz(7z²−3)",
                                                   "(x²−y²)(7z²−1)", "xz(x²−3y²)",  "x⁴−6x²y²+y⁴"};
constexpr std::array<const char*, 7> kPolynomials3{"y(3x²−y²)", "xyz",      "y(5z²−1)", "z(5z²−3)",
                                                   "x(5z²−1)",  "z(x²−y²)", "x(x²−3y²)"};

/// The harmonics of one degree, each in the column of its order.
template <int D>
void draw_row(Figure& figure, double top, const std::array<const char*, 2 * D + 1>& polynomials) {
  const std::vector<Vector3> sight = ball_of_sight(0.87);  // the largest, of degree 4 and order 0, is 0.846
  for (int m = -D; m <= D; ++m) {
    Coefficients<D> h{};
    h[index_of_order<D>(m)] = 1;
    Drawing drawing;
    drawing.meshes.push_back(harmonic_shape<D>(h));
    const double left = kLeft + kColumn * (m + 4);
    figure.draw(drawing, kView, sight, {left, top, left + kColumn, top + kRow - 56});
    figure.text(polynomials[static_cast<std::size_t>(m + D)], left + kColumn / 2, top + kRow - 30, 23);
  }
  figure.text(fmt::format("degree {}", D), 24, top + 96, 26, Align::kLeft);
  figure.text(fmt::format("{} shapes", 2 * D + 1), 24, top + 130, 22, Align::kLeft, kFaint);
}

}  // namespace

Figure basis_figure() {
  Figure figure(static_cast<int>(kLeft + 9 * kColumn + 8), static_cast<int>(kTop + 2 * kRow + 14));
  figure.text("order", 24, 44, 22, Align::kLeft, kFaint);
  for (int m = -4; m <= 4; ++m)
    figure.text(m < 0 ? fmt::format("−{}", -m) : std::to_string(m), kLeft + kColumn * (m + 4.5), 44, 26);
  figure.canvas().line(24, 62, figure.width() - 24, 62, 1.5, kRule);
  draw_row<4>(figure, kTop, kPolynomials4);
  draw_row<3>(figure, kTop + kRow, kPolynomials3);

  const double x = kLeft + 8.5 * kColumn, y = kTop + 1.5 * kRow;
  draw_axis_cross(figure.canvas(), ViewAxes(kView), x, y, 62, kInk);
  figure.canvas().disc(26 + 8, kTop + kRow + 192, 9, kPositive);
  figure.text("positive", 26 + 26, kTop + kRow + 200, 22, Align::kLeft);
  figure.canvas().disc(26 + 8, kTop + kRow + 226, 9, kNegative);
  figure.text("negative", 26 + 26, kTop + kRow + 234, 22, Align::kLeft);
  return figure;
}

}  // namespace crossgrain::figures
