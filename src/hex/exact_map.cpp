// SPDX-License-Identifier: Apache-2.0
#include "hex/exact_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

using Axis = std::array<Int128, 3>;

Axis exact_cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Whether the cube, centred at the origin with sides of 2 units, lies on one side of the triangle along an
/// axis. Lengths are twice as long as given, so that the centre is whole.
bool separates(const Axis& axis, const std::array<Axis, 3>& triangle) {
  Int128 low = 0, high = 0, reach = 0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    Int128 at = 0;
    for (std::size_t k = 0; k < 3; ++k) at += axis[k] * triangle[corner][k];
    low = corner == 0 ? at : std::min(low, at);
    high = corner == 0 ? at : std::max(high, at);
  }
  for (const Int128 part : axis) reach += (part < 0 ? -part : part) * kGridUnit;
  if (reach == 0) return false;  // no axis
  return low >= reach || high <= -reach;
}

ExactPoint rounded(const MapCoordinates& map, std::uint32_t copy) {
  ExactPoint point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = map[static_cast<Index>(3 * copy) + static_cast<Index>(k)];
    // Integers of the map are so to about 1e-9, far below half a step.
    point[k] = std::llround(value * static_cast<double>(kGridUnit));
  }
  return point;
}

bool is_inside(const std::array<Int128, 4>& weights, Int128 volume) {
  return volume != 0 && std::all_of(weights.begin(), weights.end(),
                                    [&](Int128 weight) { return volume > 0 ? weight >= 0 : weight <= 0; });
}

std::int64_t floor_to_unit(std::int64_t x) {
  const std::int64_t rest = ((x % kGridUnit) + kGridUnit) % kGridUnit;
  return x - rest;
}

template <class Visit>
void for_each_grid_point(const std::array<ExactPoint, 4>& corners, const Visit& visit) {
  ExactPoint low = corners[0], high = corners[0];
  for (const ExactPoint& corner : corners)
    for (std::size_t k = 0; k < 3; ++k)
      low[k] = std::min(low[k], corner[k]), high[k] = std::max(high[k], corner[k]);
  for (std::int64_t& x : low) x = floor_to_unit(x);
  for (std::int64_t x = low[0]; x <= high[0]; x += kGridUnit)
    for (std::int64_t y = low[1]; y <= high[1]; y += kGridUnit)
      for (std::int64_t z = low[2]; z <= high[2]; z += kGridUnit) visit(ExactPoint{x, y, z});
}

std::array<ExactPoint, 3> face_opposite(const std::array<ExactPoint, 4>& corners, std::size_t k) {
  return {corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]};
}

}  // namespace

bool meets_open_cell(const std::array<ExactPoint, 3>& triangle, const ExactPoint& low) {
  std::array<Axis, 3> corners{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t k = 0; k < 3; ++k) corners[corner][k] = 2 * (triangle[corner][k] - low[k]) - kGridUnit;
  std::array<Axis, 3> edges{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t k = 0; k < 3; ++k)
      edges[corner][k] = triangle[(corner + 1) % 3][k] - triangle[corner][k];
  for (std::size_t k = 0; k < 3; ++k) {
    Axis unit{0, 0, 0};
    unit[k] = 1;
    if (separates(unit, corners)) return false;
    for (const Axis& edge : edges)
      if (separates(exact_cross(edge, unit), corners)) return false;
  }
  return !separates(exact_cross(edges[0], edges[1]), corners);
}

ExactMap::ExactMap(const MapUnknowns& unknowns, const MapCoordinates& map)
    : cut_(unknowns.cut()), solid_(cut_.field().complex().solid()) {
  if (map.size() > 0 && map.cwiseAbs().maxCoeff() > kLargestCoordinate)
    throw Error(ErrorKind::kLimit, "the map has more hexahedra along an axis than its numbers hold");
  find_translations(map);
  round_points(map);
}

std::array<ExactPoint, 4> ExactMap::corners(std::uint32_t tet) const {
  std::array<ExactPoint, 4> result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = points_[cut_.copy_of(tet, k)];
  return result;
}

ExactPoint ExactMap::carried(const ExactPoint& point, const Crossing& crossing) const {
  return step(point, cut_.step_across(crossing));
}

ExactPoint ExactMap::carried_cell(const ExactPoint& low, const Crossing& crossing) const {
  ExactPoint high = low;
  for (std::int64_t& x : high) x += kGridUnit;
  const ExactPoint a = carried(low, crossing), b = carried(high, crossing);
  return {std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])};
}

std::uint8_t ExactMap::rotation_across(const Crossing& crossing) const {
  const SheetStep step = cut_.step_across(crossing);
  if (step == 0) return CubeGroup::kIdentity;
  const std::uint8_t own = cut_.rotation(static_cast<std::size_t>(std::abs(step) - 1));
  return step > 0 ? own : CubeGroup::instance().inverse_of(own);
}

ExactPoint ExactMap::step(const ExactPoint& point, SheetStep step) const {
  if (step == 0) return point;
  const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
  const ExactPoint& translation = translations_[sheet];
  ExactPoint result = point;
  if (step > 0) {
    result = turned(cut_.rotation(sheet), result);
    for (std::size_t k = 0; k < 3; ++k) result[k] += translation[k];
    return result;
  }
  for (std::size_t k = 0; k < 3; ++k) result[k] -= translation[k];
  return turned(CubeGroup::instance().inverse_of(cut_.rotation(sheet)), result);
}

/// Finds the translation of each sheet from any of its faces: those of a map to the grid are whole.
void ExactMap::find_translations(const MapCoordinates& map) {
  translations_.resize(cut_.sheets());
  std::vector<bool> is_known(cut_.sheets(), false);
  for (std::uint32_t f = 0; f < solid_.inner_faces.size(); ++f) {
    const SheetStep step = cut_.step_across({f, false});
    if (step == 0 || is_known[static_cast<std::size_t>(std::abs(step) - 1)]) continue;
    const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
    is_known[sheet] = true;
    const auto& [vertices, sides] = solid_.inner_faces[f];
    const std::uint32_t from = sides[step > 0 ? 0 : 1], to = sides[step > 0 ? 1 : 0];
    const ExactPoint before = rounded(map, cut_.copy_at(from, vertices[0])),
                     after = rounded(map, cut_.copy_at(to, vertices[0]));
    // Both are rounded to 2^-20; their difference is a whole number but for that.
    const ExactPoint there = turned(cut_.rotation(sheet), before);
    for (std::size_t k = 0; k < 3; ++k)
      translations_[sheet][k] =
          kGridUnit * std::llround(static_cast<double>(after[k] - there[k]) / static_cast<double>(kGridUnit));
  }
}

void ExactMap::round_points(const MapCoordinates& map) {
  points_.resize(cut_.copies());
  for (std::uint32_t copy = 0; copy < points_.size(); ++copy) {
    const std::uint32_t first = cut_.first_copy(copy);  // comes before its other copies
    if (first == copy) {
      points_[copy] = rounded(map, copy);
      continue;
    }
    ExactPoint point = points_[first];
    for (const SheetStep s : cut_.word_to(copy)) point = step(point, s);
    points_[copy] = point;
  }
}

std::array<Int128, 4> weights_of(const std::array<ExactPoint, 4>& corners, const ExactPoint& point) {
  const auto& [a, b, c, d] = corners;
  return {six_volumes(point, b, c, d), six_volumes(a, point, c, d), six_volumes(a, b, point, d),
          six_volumes(a, b, c, point)};
}

TetPart part_of(const std::array<ExactPoint, 4>& corners) {
  TetPart part;
  part.volume = six_volumes(corners[0], corners[1], corners[2], corners[3]);
  Checkpoint checkpoint;
  for_each_grid_point(corners, [&](const ExactPoint& point) {
    checkpoint.pass();
    TetPart::Cell cell{point, {}};
    bool meets = false;
    for (std::size_t k = 0; k < 4; ++k)
      meets |= cell.meets_face[k] = meets_open_cell(face_opposite(corners, k), point);
    const std::array<Int128, 4> weights = weights_of(corners, point);
    if (is_inside(weights, part.volume)) part.vertices.push_back({point, weights});
    ExactPoint centre = point;
    for (std::int64_t& x : centre) x += kGridUnit / 2;
    meets = meets || is_inside(weights_of(corners, centre), part.volume);
    if (meets) part.cells.push_back(cell);
  });
  return part;
}

}  // namespace crossgrain
