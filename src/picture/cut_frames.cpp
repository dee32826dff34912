// SPDX-License-Identifier: Apache-2.0
#include "picture/cut_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "display/axis_colours.hpp"

namespace crossgrain {
namespace {

/// Two outward triangles for each of the six sides of a box; bit k of a corner's number is its side along
/// axis k.
constexpr std::array<std::array<std::uint32_t, 3>, 12> kBoxTriangles{{{0, 2, 3},
                                                                      {0, 3, 1},
                                                                      {4, 5, 7},
                                                                      {4, 7, 6},
                                                                      {0, 1, 5},
                                                                      {0, 5, 4},
                                                                      {2, 6, 7},
                                                                      {2, 7, 3},
                                                                      {0, 4, 6},
                                                                      {0, 6, 2},
                                                                      {1, 3, 7},
                                                                      {1, 7, 5}}};

/// The triangles of the two sides across each axis.
constexpr std::array<std::array<std::size_t, 4>, 3> kTrianglesAcross{
    {{8, 9, 10, 11}, {4, 5, 6, 7}, {0, 1, 2, 3}}};

/// Points of a plane at least `spacing` apart, less rounding.
class PlacedApart {
 public:
  PlacedApart(std::size_t b, std::size_t c, double spacing) : b_(b), c_(c), spacing_(0.999 * spacing) {}

  bool has_room_at(const Vector3& place) const {
    const auto [i, j] = bin_of(place);
    for (int di = -1; di <= 1; ++di) {
      for (int dj = -1; dj <= 1; ++dj) {
        const auto bin = bins_.find({i + di, j + dj});
        if (bin == bins_.end()) continue;
        for (const std::size_t other : bin->second)
          if (norm(places_[other] - place) < spacing_) return false;
      }
    }
    return true;
  }

  void add(const Vector3& place) {
    bins_[bin_of(place)].push_back(places_.size());
    places_.push_back(place);
  }

  const std::vector<Vector3>& all() const { return places_; }

 private:
  using Bin = std::pair<std::int64_t, std::int64_t>;
  Bin bin_of(const Vector3& place) const {
    return {static_cast<std::int64_t>(std::floor(place[b_] / spacing_)),
            static_cast<std::int64_t>(std::floor(place[c_] / spacing_))};
  }

  std::size_t b_, c_;
  double spacing_;
  std::vector<Vector3> places_;
  std::map<Bin, std::vector<std::size_t>> bins_;
};

}  // namespace

std::vector<DrawnMesh> frame_boxes(const std::vector<PlacedFrame>& frames, double side,
                                   const Vector3& normal) {
  std::vector<DrawnMesh> meshes(3);
  for (std::size_t k = 0; k < 3; ++k) {
    meshes[k].is_whole = true;
    meshes[k].colour = colour_of(kAxisColours[k]);
  }
  for (const PlacedFrame& placed : frames) {
    const auto axes = axes_of(placed.frame);
    double height = 0;
    for (const Vector3& axis : axes) height += 0.5 * side * std::abs(dot(axis, normal));
    for (std::size_t across = 0; across < 3; ++across) {
      DrawnMesh& mesh = meshes[placed.names[across]];
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (int corner = 0; corner < 8; ++corner) {
        Vector3 vertex = placed.place + height * normal;
        for (std::size_t k = 0; k < 3; ++k) vertex += (corner >> k & 1 ? 0.5 : -0.5) * side * axes[k];
        mesh.vertices.push_back(vertex);
      }
      for (const std::size_t k : kTrianglesAcross[across]) {
        const auto& [a, b, c] = kBoxTriangles[k];
        mesh.triangles.push_back({first + a, first + b, first + c});
      }
    }
  }
  return meshes;
}

DrawnRods frame_crosses(const std::vector<PlacedFrame>& frames, double length, const Vector3& normal) {
  constexpr double kThickness = 0.15;
  DrawnRods drawn;
  drawn.is_whole = true;
  for (const PlacedFrame& placed : frames) {
    const auto axes = axes_of(placed.frame);
    double height = 0;
    for (const Vector3& axis : axes) height = std::max(height, 0.5 * length * std::abs(dot(axis, normal)));
    const Vector3 middle = placed.place + height * normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 half = (0.5 * length) * axes[k];
      drawn.rods.push_back({middle - half, middle + half, 0.5 * kThickness * length,
                            colour_of(kAxisColours[placed.names[k]])});
    }
  }
  return drawn;
}

std::vector<Vector3> places_on_plane(const Box& box, std::size_t axis, double position, double spacing,
                                     const std::function<bool(const Vector3&)>& is_wanted) {
  const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
  // Rows are centred, with equal margins at both ends.
  const auto first = [&](std::size_t k, double step) {
    const double extent = box.high[k] - box.low[k];
    return box.low[k] + 0.5 * (extent - step * std::floor(extent / step));
  };
  PlacedApart places(b, c, spacing);
  constexpr int kFinerRows = 4;
  for (const double step : {spacing, spacing / kFinerRows}) {
    for (double y = first(c, step); y <= box.high[c]; y += step) {
      for (double x = first(b, step); x <= box.high[b]; x += step) {
        Vector3 place;
        place[axis] = position;
        place[b] = x;
        place[c] = y;
        if (places.has_room_at(place) && is_wanted(place)) places.add(place);
      }
    }
  }
  return places.all();
}

}  // namespace crossgrain
