// SPDX-License-Identifier: Apache-2.0
#include "picture/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "picture/ray_tracing.hpp"

namespace crossgrain {
namespace {

/// Number of rows of pixels per task.
constexpr std::size_t kRowsAtOnce = 8;

/// Smallest difference in a channel that makes an edge between neighbours: what the eye sees as a step, and
/// more than the difference between cells of a good field.
constexpr float kStep = 0.05f;

/// Positions of the rays of a pixel on an edge, in sixteenths of it: no two in one row or column, so that
/// nearly horizontal and vertical edges have as many shades as there are rays. The first kFirstRays, one in
/// each quarter, decide whether the edge is in this pixel at all.
constexpr std::size_t kFirstRays = 4;
constexpr std::array<std::array<int, 2>, 16> kPlaces{{{5, 4},
                                                      {14, 3},
                                                      {1, 11},
                                                      {11, 10},
                                                      {0, 5},
                                                      {2, 1},
                                                      {3, 14},
                                                      {4, 8},
                                                      {6, 12},
                                                      {7, 0},
                                                      {8, 15},
                                                      {9, 7},
                                                      {10, 2},
                                                      {12, 13},
                                                      {13, 6},
                                                      {15, 9}}};

bool differ(const Pixel& a, const Pixel& b) {
  const auto apart = [](float x, float y) { return std::abs(x - y) > kStep; };
  return apart(a.opacity, b.opacity) || apart(a.colour.r, b.colour.r) || apart(a.colour.g, b.colour.g) ||
         apart(a.colour.b, b.colour.b);
}

class Renderer {
 public:
  Renderer(const RayTracing& tracing, int width, int height, const Monitor& monitor)
      : tracing_(tracing),
        monitor_(monitor),
        first_(width, height),
        signatures_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  void cast_one_each() {
    for_rows([&](int y, RayTracing::Scratch& scratch) {
      for (int x = 0; x < first_.width(); ++x) {
        const RayTracing::Seen seen = tracing_.at(x + 0.5, y + 0.5, scratch);
        first_.at(x, y) = seen.pixel;
        signatures_[index(x, y)] = seen.signature;
      }
    });
  }

  void lay_over(Image& image) const {
    for_rows([&](int y, RayTracing::Scratch& scratch) {
      for (int x = 0; x < first_.width(); ++x) {
        const std::size_t rays = rays_in(x, y);
        const Pixel pixel = rays > 0 ? mean_in(x, y, rays, scratch) : first_.at(x, y);
        image.at(x, y) = over(pixel, image.at(x, y));
      }
    });
  }

 private:
  template <class Body>
  void for_rows(const Body& body) const {
    parallel_for_chunks(static_cast<std::size_t>(first_.height()), kRowsAtOnce,
                        [&](std::size_t begin, std::size_t end) {
                          RayTracing::Scratch scratch;
                          for (std::size_t y = begin; y < end; ++y) {
                            monitor_.check();
                            body(static_cast<int>(y), scratch);
                          }
                        });
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(first_.width()) +
           static_cast<std::size_t>(x);
  }

  /// Number of further rays for a pixel: all if an outline runs between it and a neighbour, a few if only the
  /// colour of the same shape changes, as from cell to cell.
  std::size_t rays_in(int x, int y) const {
    bool has_step = false;
    for (int there_y = std::max(y - 1, 0); there_y <= std::min(y + 1, first_.height() - 1); ++there_y) {
      for (int there_x = std::max(x - 1, 0); there_x <= std::min(x + 1, first_.width() - 1); ++there_x) {
        if (signatures_[index(x, y)] != signatures_[index(there_x, there_y)]) return kPlaces.size();
        has_step = has_step || differ(first_.at(x, y), first_.at(there_x, there_y));
      }
    }
    return has_step ? kFirstRays : 0;
  }

  Pixel mean_in(int x, int y, std::size_t rays, RayTracing::Scratch& scratch) const {
    Pixel sum;
    bool is_crossed = false;
    const Pixel& middle = first_.at(x, y);
    for (std::size_t i = 0; i < rays; ++i) {
      if (i == kFirstRays && !is_crossed) return mean_of(sum, i);
      const auto& [across, down] = kPlaces[i];
      const Pixel pixel = tracing_.at(x + (across + 0.5) / 16, y + (down + 0.5) / 16, scratch).pixel;
      is_crossed = is_crossed || differ(pixel, middle);
      sum.colour = sum.colour + pixel.colour;
      sum.opacity += pixel.opacity;
    }
    return mean_of(sum, rays);
  }

  static Pixel mean_of(const Pixel& sum, std::size_t count) {
    const float share = 1 / static_cast<float>(count);
    return {share * sum.colour, share * sum.opacity};
  }

  const RayTracing& tracing_;
  const Monitor& monitor_;
  Image first_;
  std::vector<std::uint32_t> signatures_;
};

}  // namespace

void render(const Drawing& drawing, const Camera& camera, const RenderOptions& options, Image& image,
            const Monitor& monitor) {
  const RayTracing tracing(drawing, camera, options);
  monitor.check();
  Renderer renderer(tracing, image.width(), image.height(), monitor);
  renderer.cast_one_each();
  renderer.lay_over(image);
}

}  // namespace crossgrain
