// SPDX-License-Identifier: Apache-2.0
#include "figure.hpp"

#include <cmath>
#include <numbers>

#include "files/output_file.hpp"
#include "picture/font.hpp"
#include "picture/png_file.hpp"
#include "picture/renderer.hpp"

namespace crossgrain::figures {

Figure::Figure(int width, int height) : image_(width, height, pixel_of({1, 1, 1})), canvas_(image_) {}

Camera Figure::draw(const Drawing& drawing, const ViewDirection& view, std::span<const Vector3> seen,
                    const PixelBox& box) {
  const int left = static_cast<int>(box.left), top = static_cast<int>(box.top);
  Image panel(static_cast<int>(box.width()), static_cast<int>(box.height()));
  const Camera camera(view, seen, {0, 0, box.width(), box.height()}, 0);
  RenderOptions options;
  options.haze_share = 0.12f;  // shapes of a hand's size: far ends stay in colour
  render(drawing, camera, options, panel, {});
  for (int y = 0; y < panel.height(); ++y)
    for (int x = 0; x < panel.width(); ++x)
      image_.at(left + x, top + y) = over(panel.at(x, y), image_.at(left + x, top + y));
  return Camera(view, seen, box, 0);
}

void Figure::text(const std::string& text, double x, double y, double size, Align align,
                  const Colour& colour) {
  const double width = Font::sans().width(text, size);
  const double share = align == Align::kLeft ? 0 : align == Align::kCentre ? 0.5 : 1;
  canvas_.text(text, std::round(x - share * width), y, size, colour);
}

void Figure::write(const std::filesystem::path& path) const {
  OutputFile file(path);
  write_png(file, image_, {});
  file.commit();
}

std::vector<Vector3> ball_of_sight(double radius) {
  std::vector<Vector3> points;
  constexpr int kRings = 24;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double polar = std::numbers::pi * ring / kRings;
    for (int i = 0; i < 2 * kRings; ++i) {
      const double around = std::numbers::pi * i / kRings;
      points.push_back({radius * std::sin(polar) * std::cos(around),
                        radius * std::sin(polar) * std::sin(around), radius * std::cos(polar)});
    }
  }
  return points;
}

}  // namespace crossgrain::figures
