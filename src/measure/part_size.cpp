// SPDX-License-Identifier: Apache-2.0
#include "measure/part_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/digits.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Range of the longest side in which cubes and inverse squares of cell sizes fit into single precision.
constexpr double kSmallestModel = 1e-9;
constexpr double kLargestModel = 1e12;

/// Largest distance from the origin, in sizes of the model. Farther away, coordinates have too few digits for
/// its shape.
constexpr double kFarthestModel = 1e9;

/// More elements are in no memory: at 100 bytes each, 100 TB. They are a wrong unit; fewer may be a wish.
constexpr double kBeyondMemory = 1e12;

/// Elements along the longest side that a user may have meant, when a size is taken in another unit.
constexpr double kLeastMeant = 4, kMostMeant = 2000;

/// Start of the lines of `usual_thickness` off the surface, relative to the longest side: beyond rounding.
constexpr double kStart = 1e-6;

/// Edge of a regular tet over the cube root of its volume, to the third power.
constexpr double kTetsPerCube = 6 * 1.4142135623730951;

/// A unit that a part may be in while the size is in millimetres, or the other way round.
struct Unit {
  const char* name;
  const char* short_name;
  double millimetres;
};
constexpr std::array kUnits = {Unit{"inches", "inch", 25.4}, Unit{"metres", "m", 1000}};

bool may_be_meant(double elements) {
  return elements >= kLeastMeant && elements <= kMostMeant;
}

/// Asks for the unit of a size, where another than the part's makes it one that suits.
std::string other_unit_of(const AskedSize& asked, const PartSize& part) {
  const auto question = [&](double size, const char* unit) {
    return may_be_meant(part.longest / size)
               ? fmt::format("; in {}? That is {} here", unit, length_text(size, part.unit))
               : "";
  };
  for (const Unit& unit : kUnits) {
    std::string text;
    if (part.unit == "mm") text = question(asked.size * unit.millimetres, unit.name);
    if (part.unit == unit.short_name) text = question(asked.size / unit.millimetres, "millimetres");
    if (!text.empty()) return text;
  }
  return "";
}

/// Says what unit a size is in, with a guess if there is one.
std::string unit_of(const AskedSize& asked, const PartSize& part) {
  if (!part.unit.empty()) return other_unit_of(asked, part);
  std::string guess;
  for (const auto& [name, short_name, millimetres] : kUnits) {
    if (!guess.empty()) break;
    if (may_be_meant(part.longest * millimetres / asked.size))
      guess = fmt::format("; {}?", name);
    else if (may_be_meant(part.longest / millimetres / asked.size))
      guess = fmt::format("; millimetres, and the size in {}?", name);
  }
  return fmt::format("; sizes are in the unit of the model (none is named{})", guess);
}

/// Points spread evenly over the area of a surface, each with its triangle.
struct SpreadPoint {
  Vector3 place;
  std::size_t triangle;
};

std::vector<SpreadPoint> spread_points(const Surface& surface, std::size_t count) {
  std::vector<double> area_up_to(surface.size());
  std::partial_sum(surface.areas.begin(), surface.areas.end(), area_up_to.begin());
  std::vector<SpreadPoint> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double number = static_cast<double>(k) + 0.5;
    const double area = area_up_to.back() * number / static_cast<double>(count);
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, area);
    points[k].triangle = static_cast<std::size_t>(found - area_up_to.begin());
    const auto [a, b, c] = surface.corners(points[k].triangle);
    // Multiples of the plastic number's inverses fill the square evenly (Roberts 2018).
    double u = std::fmod(0.7548776662466927 * number, 1), v = std::fmod(0.5698402909980532 * number, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    points[k].place = a + u * (b - a) + v * (c - a);
  }
  return points;
}

}  // namespace

PartSize part_size(const Surface& surface) {
  return {longest_side(surface.box), enclosed_volume(surface),
          std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0), surface.mesh.unit};
}

double expected_tets(const PartSize& part, double size) {
  return std::max(kTetsPerCube * part.volume / size / size / size, part.area / size / size);
}

std::string length_text(double length, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", length, unit.empty() ? "" : " ", unit);
}

void check_scale(const Box& box) {
  const double size = longest_side(box);
  if (!(size >= kSmallestModel && size <= kLargestModel)) {
    throw Error(ErrorKind::kInput,
                fmt::format("the model is {:.3g} across, which is not between {:g} and {:g}", size,
                            kSmallestModel, kLargestModel),
                Remedy::kRescale);
  }
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  }
  if (farthest > kFarthestModel * size) {
    throw Error(ErrorKind::kInput,
                fmt::format("the model is {:.3g} across but {:.3g} away from the origin", size, farthest),
                Remedy::kMoveToOrigin);
  }
}

void check_asked_size(const AskedSize& asked, const PartSize& part) {
  constexpr double kRounding = 1e-9;
  const bool is_large = asked.size * asked.least > part.longest * (1 + kRounding);
  const bool is_small = !(asked.expected <= kBeyondMemory);
  if (!is_large && !is_small) return;
  const std::string many = is_large ? ""
                           : std::isfinite(asked.expected)
                               ? fmt::format(", about {:.2g} of them would fill it", asked.expected)
                               : ", no memory holds as many as would fill it";
  throw Error(ErrorKind::kUsage,
              {"", "",
               fmt::format("{} of {} are too {} for the part, which is {} across{}{}", asked.elements,
                           length_text(asked.size, part.unit), is_large ? "large" : "small",
                           length_text(part.longest, part.unit), many, unit_of(asked, part)),
               asked.remedy, rounded_down(part.longest / asked.usual, 2)});
}

double usual_thickness(const TriangleBvh& bvh, std::size_t lines) {
  const Surface& surface = bvh.surface();
  const double longest = longest_side(surface.box);
  std::vector<double> thicknesses;
  for (const auto& [place, triangle] : spread_points(surface, lines)) {
    const auto hit = bvh.first_hit(place, -surface.normals[triangle], kStart * longest, 2 * longest);
    thicknesses.push_back(hit ? hit->t : std::numeric_limits<double>::infinity());
  }
  const auto middle = thicknesses.begin() + static_cast<std::ptrdiff_t>(lines / 2);
  std::nth_element(thicknesses.begin(), middle, thicknesses.end());
  return *middle;
}

}  // namespace crossgrain
