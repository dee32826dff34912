// SPDX-License-Identifier: Apache-2.0
#include "picture/face_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "picture/cell_colours.hpp"
#include "picture/ray_scene.hpp"

namespace crossgrain {
namespace {

/// Prime, so that no regular numbering of a part repeats them beside each other.
constexpr std::array<Colour, 11> kTones{colour_of(0xf2c14e), colour_of(0x7fb7be), colour_of(0xe07a5f),
                                        colour_of(0xa8c686), colour_of(0xb497d6), colour_of(0xf4a6b7),
                                        colour_of(0x5fa8d3), colour_of(0xd9d375), colour_of(0x8fd3b0),
                                        colour_of(0xc89f7b), colour_of(0x9fa8da)};

/// Rays per height of letters, along each axis of the picture.
constexpr double kRaysPerLetter = 4;

/// A face has room for its number if a circle of this many heights of letters fits into it.
constexpr double kRoom = 0.45;

/// Of the most room that a face has.
constexpr double kNearlyMost = 0.9;

/// The numbers of the faces that rays through a grid of pixels meet first; 0 where there is none.
class SeenFaces {
 public:
  SeenFaces(const std::array<int, 2>& size, double step)
      : step_(step),
        wide_(static_cast<std::size_t>(std::ceil(size[0] / step))),
        high_(static_cast<std::size_t>(std::ceil(size[1] / step))),
        numbers_(wide_ * high_) {}

  double x(std::size_t i) const { return step_ * (static_cast<double>(i % wide_) + 0.5); }
  double y(std::size_t i) const { return step_ * (static_cast<double>(i / wide_) + 0.5); }
  std::size_t size() const { return numbers_.size(); }
  std::int32_t& operator[](std::size_t i) { return numbers_[i]; }
  std::int32_t operator[](std::size_t i) const { return numbers_[i]; }

  /// The distance of each ray to the nearest of another face, in pixels: in steps along and across the rows,
  /// by one pass down and one up. Beyond the picture lies another face.
  std::vector<double> distances_to_others() const {
    std::vector<double> distances(size(), 0);
    const auto grow = [&](std::size_t i, std::ptrdiff_t row, std::ptrdiff_t column) {
      const auto r = static_cast<std::ptrdiff_t>(i / wide_) + row;
      const auto c = static_cast<std::ptrdiff_t>(i % wide_) + column;
      const bool is_there = r >= 0 && c >= 0 && r < static_cast<std::ptrdiff_t>(high_) &&
                            c < static_cast<std::ptrdiff_t>(wide_);
      const std::size_t other =
          is_there ? static_cast<std::size_t>(r) * wide_ + static_cast<std::size_t>(c) : i;
      const double through =
          is_there && numbers_[other] == numbers_[i] ? distances[other] + step_ : step_ / 2;
      distances[i] = std::min(distances[i], through);
    };
    std::fill(distances.begin(), distances.end(), 1e30);
    for (std::size_t i = 0; i < size(); ++i)
      for (const auto& [row, column] : kBefore) grow(i, row, column);
    for (std::size_t i = size(); i-- > 0;)
      for (const auto& [row, column] : kBefore) grow(i, -row, -column);
    return distances;
  }

 private:
  static constexpr std::array<std::array<std::ptrdiff_t, 2>, 4> kBefore{
      {{0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

  double step_;
  std::size_t wide_, high_;
  std::vector<std::int32_t> numbers_;
};

/// For each face the ray that is nearest to the middle of those that see it, of those with nearly the most
/// room: a strip has as much all along it.
std::map<std::int32_t, std::size_t> places_in(const SeenFaces& seen, const std::vector<double>& room) {
  struct Sum {
    double x = 0, y = 0, count = 0, most = 0;
  };
  std::map<std::int32_t, Sum> sums;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == 0) continue;
    Sum& sum = sums[seen[i]];
    sum.x += seen.x(i), sum.y += seen.y(i), sum.count += 1;
    sum.most = std::max(sum.most, room[i]);
  }
  std::map<std::int32_t, std::pair<double, std::size_t>> best;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] == 0) continue;
    const Sum& sum = sums[seen[i]];
    if (room[i] < kNearlyMost * sum.most) continue;
    const double away = std::hypot(seen.x(i) - sum.x / sum.count, seen.y(i) - sum.y / sum.count);
    const auto [place, is_new] = best.try_emplace(seen[i], away, i);
    if (!is_new && away < place->second.first) place->second = {away, i};
  }
  std::map<std::int32_t, std::size_t> places;
  for (const auto& [number, place] : best) places[number] = place.second;
  return places;
}

}  // namespace

Colour colour_of_face(std::int32_t number) {
  if (number == 0) return kPlainPart;
  return kTones[static_cast<std::uint32_t>(number) % kTones.size()];
}

std::vector<Label> face_labels(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles,
                               const std::vector<std::int32_t>& faces, const Camera& camera,
                               const std::array<int, 2>& size, double text_size, const Section* section) {
  Box box = empty_box();
  for (const Vector3& vertex : vertices) include(box, vertex);
  const double extent = norm(box.high - box.low);
  const RaySpace space{0.5 * (box.low + box.high), extent > 0 ? extent : 1};
  const RayDevice device;
  RayScene scene(device, space);
  scene.add_triangles(vertices, triangles);
  scene.commit();

  const Vector3& towards = camera.axes().towards;
  SeenFaces seen(size, text_size / kRaysPerLetter);
  std::vector<Vector3> places(seen.size());
  parallel_for(seen.size(), [&](std::size_t i) {
    const Vector3 origin = camera.point_at(seen.x(i), seen.y(i)) + (camera.nearest() + space.size) * towards;
    Ray ray{space.from_model(origin), -towards};
    if (section != nullptr)
      ray.nearest = std::max(0.0, (section->offset - dot(section->normal, origin)) /
                                      (-dot(section->normal, towards) * space.size));
    ShapeHit hit;
    if (!scene.first_hit(ray, hit)) return;
    double facing = 0;
    for (std::size_t k = 0; k < 3; ++k) facing += static_cast<double>(hit.normal[k]) * towards[k];
    if (facing <= 0) return;  // seen from inside, through a cut
    seen[i] = faces[hit.primitive];
    places[i] = space.to_model(ray.origin + static_cast<double>(hit.distance) * ray.direction);
  });

  const std::vector<double> room = seen.distances_to_others();
  std::vector<Label> labels;
  for (const auto& [number, i] : places_in(seen, room))
    if (room[i] >= kRoom * text_size) labels.push_back({places[i], fmt::format("{}", number)});
  return labels;
}

LegendBlock face_legend(const std::vector<std::int32_t>& faces) {
  std::set<std::int32_t> numbers(faces.begin(), faces.end());
  numbers.erase(0);
  LegendBlock block{fmt::format("Faces ({})", numbers.size())};
  block.notes.push_back("numbers as in report.json; without where hidden or small");
  return block;
}

}  // namespace crossgrain
