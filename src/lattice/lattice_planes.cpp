// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Faces are normal to an axis within 6 degrees, and in one plane within this share of a size.
constexpr double kNormalCosine = 0.995, kSamePlane = 0.03;

/// The border of the surface gets a plane unless a face is this near to it, in sizes; that of a thin surface
/// on both sides, so that there is a cell between them.
constexpr double kBorderGap = 0.3;

/// Wider holes are seen by planes that are a size apart.
constexpr double kWidestHole = 2;

/// In sizes: shorter lines, such as the ends of a fillet, get no plane.
constexpr double kShortestLine = 2;

/// Both sides of a wall or a gap get planes if they have this area, in squared sizes, and are this far apart.
/// Of gaps between boxes and hollow boxes with walls of 1e-2 to 1e-7 sizes, all down to 1e-5 are filled by
/// right angles with any smaller value; walls of 1e-6 are none for the volume shares.
constexpr double kWallArea = 4, kThinnestWall = 1e-5;

struct FlatArea {
  double coordinate, area;
  double towards;  ///< area that looks along the axis, less that which looks back
  Box box = empty_box();
};

/// Adds the planes in which some triangles normal to an axis lie: each one's mean coordinate and area.
void add_planes(std::vector<FlatArea> triangles, double size, std::vector<FlatArea>& planes) {
  std::ranges::sort(triangles, {}, &FlatArea::coordinate);
  for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
    double area = 0, moment = 0, towards = 0;
    Box box = empty_box();
    for (; end < triangles.size() &&
           triangles[end].coordinate - triangles[begin].coordinate < kSamePlane * size;
         ++end) {
      area += triangles[end].area;
      moment += triangles[end].area * triangles[end].coordinate;
      towards += triangles[end].towards;
      include(box, triangles[end].box.low);
      include(box, triangles[end].box.high);
    }
    planes.push_back({moment / area, area, towards, box});
  }
}

/// Returns the planes of the faces normal to an axis, the largest first. Faces that look along the axis are
/// in other planes than those that look back, however near: they may be the sides of a wall.
std::vector<FlatArea> flat_areas(const Surface& surface, std::size_t axis, double size) {
  std::array<std::vector<FlatArea>, 2> triangles;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    if (std::abs(surface.normals[t][axis]) < kNormalCosine) continue;
    const auto [a, b, c] = surface.corners(t);
    const bool looks_back = surface.normals[t][axis] < 0;
    Box box = empty_box();
    for (const Vector3& corner : {a, b, c}) include(box, corner);
    triangles[looks_back ? 1 : 0].push_back({(a[axis] + b[axis] + c[axis]) / 3, surface.areas[t],
                                             looks_back ? -surface.areas[t] : surface.areas[t], box});
  }
  std::vector<FlatArea> planes;
  for (std::vector<FlatArea>& of_direction : triangles) add_planes(std::move(of_direction), size, planes);
  std::ranges::stable_sort(planes, [](const FlatArea& a, const FlatArea& b) { return a.area > b.area; });
  return planes;
}

/// Whether two planes bound a thin wall, or a thin gap: most of one looks away from most of the other.
bool bound_wall(const FlatArea& a, const FlatArea& b, double size) {
  const double least = kWallArea * size * size;
  return a.towards * b.towards < 0 && std::min(std::abs(a.towards), std::abs(b.towards)) >= least &&
         std::abs(a.coordinate - b.coordinate) >= kThinnestWall * size;
}

/// Whether two boxes overlap as seen along an axis.
bool overlap_along(const Box& a, const Box& b, std::size_t axis) {
  for (std::size_t k = 0; k < 3; ++k)
    if (k != axis && (a.high[k] <= b.low[k] || b.high[k] <= a.low[k])) return false;
  return true;
}

/// Returns the coordinates of both sides of walls, and gaps, between holes or bosses and flat areas, or two
/// of the same kind: of each side of a hole the thinnest.
std::vector<double> sides_of_walls_at_holes(const std::vector<FlatArea>& flats,
                                            const std::vector<HoleBox>& holes, std::size_t axis,
                                            double size) {
  std::vector<double> sides;
  Checkpoint checkpoint;
  for (const HoleBox& hole : holes) {
    const double low = hole.box.low[axis], high = hole.box.high[axis];
    double below = -INFINITY, above = INFINITY;
    const auto look_at = [&](double coordinate, bool is_above) {
      checkpoint.pass();
      if (is_above && coordinate - high >= kThinnestAtHole * size) above = std::min(above, coordinate);
      if (!is_above && low - coordinate >= kThinnestAtHole * size) below = std::max(below, coordinate);
    };
    // A wall ends with a face that looks away from the hole, a gap with one that looks at the boss.
    for (const FlatArea& flat : flats)
      if (flat.area >= kPlaneArea * size * size && overlap_along(hole.box, flat.box, axis))
        look_at(flat.coordinate, (flat.towards > 0) != hole.is_boss);
    for (const HoleBox& other : holes) {
      if (other.is_boss != hole.is_boss || !overlap_along(hole.box, other.box, axis)) continue;
      look_at(other.box.low[axis], true);
      look_at(other.box.high[axis], false);
    }
    if (above - high < kThickestAtHole * size) sides.insert(sides.end(), {high, above});
    if (low - below < kThickestAtHole * size) sides.insert(sides.end(), {below, low});
  }
  sort_uniquely(sides);
  return sides;
}

template <class MayBeNear>
void add_apart(const FlatArea& flat, double gap, const MayBeNear& may_be_near,
               std::vector<FlatArea>& planes) {
  if (std::ranges::all_of(planes, [&](const FlatArea& other) {
        return std::abs(flat.coordinate - other.coordinate) >= gap || may_be_near(flat, other);
      }))
    planes.push_back(flat);
}

/// Ascending, with as many between two of them as make the distances nearest to those that are wanted, and
/// one beyond either end.
std::vector<double> divided(std::vector<double> planes, const PlaneDistance& distance) {
  std::ranges::sort(planes);
  std::vector<double> all = {planes.front()};
  for (std::size_t k = 0; k + 1 < planes.size(); ++k) {
    const double count = distance.between(planes[k], planes[k + 1]);
    const double parts = std::max(1.0, std::round(count));
    for (double part = 1; part < parts; ++part)
      all.push_back(distance.after(planes[k], planes[k + 1], count * part / parts));
    all.push_back(planes[k + 1]);
  }
  all.insert(all.begin(), all.front() - distance.at(all.front()));
  all.push_back(all.back() + distance.at(all.back()));
  return all;
}

}  // namespace

PlaneDistance::PlaneDistance(double size, const std::vector<FinePlace>& fine, std::size_t axis)
    : size_(size) {
  for (const FinePlace& place : fine)
    if (std::abs(place.normal[axis]) >= kLeastAcross || norm(place.normal) == 0)
      places_.emplace_back(place.at[axis], place.size);
  std::ranges::sort(places_);
}

double PlaneDistance::at(double coordinate) const {
  double least = size_;
  for (const auto& [place, size] : places_)
    least = std::min(least, size + kGrowth * std::max(0.0, std::abs(coordinate - place) - size));
  return least;
}

/// Ends of pieces that are short beside the distances there.
std::vector<double> PlaneDistance::steps(double low, double high) const {
  constexpr double kPiece = 1.0 / 16;
  std::vector<double> ends = {low};
  while (ends.back() < high) ends.push_back(std::min(high, ends.back() + kPiece * at(ends.back())));
  return ends;
}

double PlaneDistance::between(double low, double high) const {
  if (places_.empty()) return (high - low) / size_;
  double count = 0;
  const std::vector<double> ends = steps(low, high);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    count += (ends[k + 1] - ends[k]) / at(0.5 * (ends[k] + ends[k + 1]));
  return count;
}

double PlaneDistance::after(double low, double high, double count) const {
  if (places_.empty()) return std::min(high, low + count * size_);
  const std::vector<double> ends = steps(low, high);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double distance = at(0.5 * (ends[k] + ends[k + 1])), part = (ends[k + 1] - ends[k]) / distance;
    if (part >= count) return ends[k] + count * distance;
    count -= part;
  }
  return high;
}

double slanted_share(const Surface& surface) {
  double slanted = 0, all = 0;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const Vector3& normal = surface.normals[t];
    all += surface.areas[t];
    if (std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])}) < kNormalCosine)
      slanted += surface.areas[t];
  }
  return slanted / all;
}

LatticePlanes lattice_planes(const Surface& surface, double size, const NarrowPlanes& narrow) {
  const auto is_wall = [&](const FlatArea& a, const FlatArea& b) {
    return narrow.walls && bound_wall(a, b, size);
  };
  const auto is_never_near = [](const FlatArea&, const FlatArea&) { return false; };
  LatticePlanes planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PlaneDistance distance(size, narrow.fine, axis);
    std::vector<FlatArea> kept;
    const std::vector<FlatArea> flats = flat_areas(surface, axis, size);
    for (const FlatArea& flat : flats) {
      const double here = distance.at(flat.coordinate);
      if (flat.area >= kPlaneArea * here * here) add_apart(flat, kLeastGap * here, is_wall, kept);
    }
    const double low = surface.box.low[axis], high = surface.box.high[axis];
    for (const double end : {low, high})
      add_apart({end, 0, 0}, std::min(kBorderGap * size, 0.5 * (high - low)), is_never_near, kept);
    for (const Box& line : narrow.lines) {
      const double middle = 0.5 * (line.low[axis] + line.high[axis]), here = distance.at(middle);
      if (line.high[axis] - line.low[axis] < kSamePlane * here && longest_side(line) >= kShortestLine * here)
        add_apart({middle, 0, 0}, kLineGap * here, is_never_near, kept);
    }
    if (narrow.walls)
      for (const double side : sides_of_walls_at_holes(flats, narrow.holes, axis, size))
        add_apart({side, 0, 0}, kThinnestAtHole * size, is_never_near, kept);
    for (const Box& box : narrow.boxes) {
      if (box.high[axis] - box.low[axis] >= kWidestHole * size) continue;
      for (const double side : {box.low[axis], box.high[axis]})
        add_apart({side, 0, 0}, kHoleGap * size, is_never_near, kept);
    }
    std::vector<double> coordinates;
    for (const FlatArea& flat : kept) coordinates.push_back(flat.coordinate);
    planes.at[axis] = divided(std::move(coordinates), distance);
  }
  return planes;
}

}  // namespace crossgrain
